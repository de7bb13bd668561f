// A collision does not notice that the neighbour list is built anew in its middle.
//
// While two spheres collide, others are spawned far away, one per step: each makes the solver build
// its list again, sort all particles along another curve, and carry the springs of the contact
// over, seen from either side. References: the same run without spawning, and the contact law
// integrated for this contact alone, without any list.
#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

struct Impact {
  std::string name;
  bool wall;
  Particle i, j;
};
static Impact impact(bool wall) {
  const real R = real(0.005), gap = real(1e-6);
  if (wall)
    return {
        "sphere and plate", true, ball({0, 0, R + gap}, R, {1, real(0.3), -1}, {30, -60, 90}), {}};
  const Vec3 n{real(0.48), real(-0.6), real(0.64)};
  const Vec3 v = real(-0.7) * n + Vec3{real(0.5), real(0.4), real(-0.2)};
  return {"two spheres", false, ball((2 * R + gap) * n, R, v, {100, -50, 20}),
          ball({}, R, {real(0.1), real(-0.2), real(0.1)}, {-40, 70, 10})};
}
static Parameters scene_of(const std::string& scheme, bool spawning, double step) {
  Parameters p = scene(
      "Rmin = 0.004; Rmax = 0.006; mus = 0.4; mur = 0.2; smin = 9,9,9; smax = 11,11,11; v0 = "
      "0,0,0; scheme = " +
      scheme + (spawning ? "; Nspawn = 1; Nmax = 1000" : "; Nspawn = 0"));
  p.dt = real(step * eq50(p, 0.005));
  return p;
}
/// Largest difference of velocities and surface speeds, over the speed of the impact (1 m/s).
static double difference(const Particle& a, const Particle& b) {
  return std::max(double(norm(a.v - b.v)), double(a.R) * double(norm(a.w - b.w)));
}
static Particle particle(const Sphere<double>& s) {
  return ball({real(s.x.x), real(s.x.y), real(s.x.z)}, real(s.R),
              {real(s.v.x), real(s.v.y), real(s.v.z)}, {real(s.w.x), real(s.w.y), real(s.w.z)});
}
static Sphere<double> sphere(const Particle& a) {
  return {{double(a.x.x), double(a.x.y), double(a.x.z)},
          {double(a.v.x), double(a.v.y), double(a.v.z)},
          {double(a.w.x), double(a.w.y), double(a.w.z)},
          double(a.R)};
}
struct Result {
  double plain = 0, alone = 0;  // largest differences
  long lists = 0;
};
static Result compare(const Impact& c, const std::string& scheme, double step, Csv& csv) {
  tinydem::vector<Particle> start{c.i};
  if (!c.wall) start.push_back(c.j);
  const Mesh mesh = c.wall ? plate(1) : Mesh{};
  const Parameters p = scene_of(scheme, false, step);
  Simulation plain(p, mesh, start), split(scene_of(scheme, true, step), mesh, start);
  OneContact<double> alone(p, c.wall);
  alone.i = sphere(c.i), alone.j = sphere(c.wall ? ball({}, 1) : c.j);
  Result r;
  bool touched = false;
  for (int k = 0; k < 2000; ++k) {
    const size_t before = split.particles().size();
    plain.run(1), split.run(1), alone.step(Method::semi_implicit_euler, double(p.dt));
    const auto a = plain.particles(), b = split.particles();
    if (alone.delta() > 0) touched = true, r.lists += b.size() > before;
    for (size_t s = 0; s < a.size(); ++s) {
      r.plain = std::max(r.plain, difference(a[s], b[s]));
      r.alone = std::max(r.alone, difference(particle(s ? alone.j : alone.i), b[s]));
    }
    csv.row(c.name, scheme, double(plain.time()), double(alone.delta()), double(a[0].v.x),
            double(b[0].v.x), double(a[0].w.z), double(b[0].w.z), b.size());
    if (touched && alone.delta() < 0) break;
  }
  return r;
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  Csv csv(run.out / "track.csv",
          "contact,scheme,t_s,overlap_m,vx_m_s,vx_split_m_s,wz_1_s,wz_split_1_s,particles");
  Result worst;
  worst.lists = 1000000;
  for (const bool wall : {false, true})
    for (const std::string scheme : {"consistent", "paper"}) {
      const Result r = compare(impact(wall), scheme, run.quick ? 0.1 : 0.05, csv);
      worst.plain = std::max(worst.plain, r.plain), worst.alone = std::max(worst.alone, r.alone);
      worst.lists = std::min(worst.lists, r.lists);
    }
  metrics("against_one_list", worst.plain);
  metrics("against_no_list", worst.alone);
  metrics("lists_in_contact", double(worst.lists));
}
