// A surface made of many elements: what is one contact, and what are two?
//
// The solver counts a point of an element unless it lies on another element of the same group that
// is nearer. Elements are convex; so, from such a point, one comes nearer to the centre of the sphere
// along the other element: what is left are the local minima of the distance, each once. Hence on a
// plane one contact, however it is cut up; on two half-planes that meet at the origin, with
// directions f1, f2 and the centre at p (in the cross section; t = p.f):
//   a contact with each half-plane for which t > 0, at the distance |p x f|,
//   none with t > 0: one contact with the edge, at the distance |p|.
// In a prism (a cylinder made of facets), seen from inside: a contact with each facet that has the foot
// of p; from outside: with the nearest point of the polygon only.
#include <algorithm>
#include <random>

#include "support.hpp"

using namespace verification;

static const double R = 0.005, g = 9.81, E = 1e6, nu = 0.3, rho = 1000;
static const double K = 4 * E / (3 * (1 - nu * nu)) * std::sqrt(R),
                    weight = 4 * pi / 3 * rho * R * R * R * g;
static const double overlap = std::pow(weight / K, 2.0 / 3);  // at rest on a plane
static double hertz(double delta) { return delta > 0 ? K * std::pow(delta, 1.5) : 0; }

// ----------------------------------------------------------------------------------- meshes

struct Random {
  std::mt19937_64 bits{23};
  double operator()(double low, double high) {
    return low + (high - low) * double(bits() >> 11) * 0x1p-53;
  }
  int below(int n) { return int(bits() % size_t(n)); }
};
static Random uniform;
/// Adds a triangle with vertices of its own, which start anywhere and turn either way.
static void triangle(Mesh& mesh, Vec3 a, Vec3 b, Vec3 c) {
  Vec3 v[3] = {a, b, c};
  std::rotate(v, v + uniform.below(3), v + 3);
  if (uniform.below(2)) std::swap(v[1], v[2]);
  const int n = int(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), v, v + 3);
  mesh.elements.push_back({3, {n, n + 1, n + 2, 0}, 0});
}
/// Covers the parallelogram o, o + u, o + u + v, o + v with 2 n^2 triangles of all shapes and sizes;
/// some are cut once more (their neighbours do not know: T-junctions), some are there twice.
static void cover(Mesh& mesh, const Vec3& o, const Vec3& u, const Vec3& v, int n) {
  const auto cut = [&](int k) {  // the ends stay
    return (k + (k % n ? uniform(-0.4, 0.4) : 0)) / n;
  };
  std::vector<Vec3> node;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) node.push_back(o + real(cut(i)) * u + real(cut(j)) * v);
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    if (const Vec3 m = real(0.5) * (a + b); uniform.below(3) == 0)
      triangle(mesh, a, m, c), triangle(mesh, m, b, c);
    else
      for (int k = uniform.below(8) ? 1 : 2; k > 0; --k) triangle(mesh, a, b, c);
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Vec3 *a = &node[size_t(j * (n + 1) + i)], *b = a + n + 1;
      if (uniform.below(2)) add(a[0], a[1], b[1]), add(b[1], b[0], a[0]);
      else add(a[1], b[1], b[0]), add(b[0], a[0], a[1]);
    }
}
/// Axes that are parallel to nothing.
struct Frame {
  Vec3 x{real(0.36), real(0.48), real(-0.8)}, y{real(-0.8), real(0.6), 0},
      z{real(0.48), real(0.64), real(0.6)};
  Vec3 at(double a, double b, double c) const { return real(a) * x + real(b) * y + real(c) * z; }
};
static const Frame tilted;

// ------------------------------------------------------------------------------------ planes

static const double side = 12 * R;
enum Surface { one, rectangles, fan, wild, surfaces };
static const char* const names[] = {"one rectangle", "rectangles", "fan of six", "wild triangles"};
/// The square of edge 2 side about the origin in the plane of x and y.
static Mesh plane(Surface kind, const Vec3& x, const Vec3& y) {
  const Vec3 u = real(side) * x, v = real(side) * y;
  if (kind == one) return {{-u - v, u - v, u + v, v - u}, {{4, {0, 1, 2, 3}, 0}}};
  Mesh mesh;
  if (kind == wild) return cover(mesh, -u - v, 2 * u, 2 * v, 24), mesh;
  if (kind == fan) {
    for (int k = 0; k < 6; ++k) {
      const auto corner = [&](int n) {
        return real(2 * std::cos(n * pi / 3)) * u + real(2 * std::sin(n * pi / 3)) * v;
      };
      triangle(mesh, {}, corner(k), corner(k + 1));
    }
    return mesh;
  }
  for (int k = 0; k <= 20; ++k)
    for (const real b : {-1, 0, 1}) mesh.vertices.push_back(real(0.1 * k - 1) * u + b * v);
  for (int k = 0; k < 60; ++k)
    if (k % 3 < 2) mesh.elements.push_back({4, {k, k + 3, k + 4, k + 1}, 0});
  return mesh;
}
/// A place on the plane, not near its rim: inside an element, on its edge, on its vertex.
static Vec3 place(const Mesh& mesh, int kind) {
  const auto& e = mesh.elements[size_t(uniform.below(int(mesh.elements.size())))];
  const int first = uniform.below(e.n);
  const auto corner = [&](int n) { return mesh.corner(e, (first + n) % e.n); };
  const Vec3 a = corner(0), b = corner(1), c = corner(2);
  const real s = real(uniform(0.1, 0.5)), t = real(uniform(0.1, 0.5));
  const Vec3 x = kind == 0 ? a + s * (b - a) + t * (c - a) : kind == 1 ? a + s * (b - a) : a;
  const auto off = [&](const Vec3& axis) { return std::abs(double(dot(x, axis))); };
  return std::max(off(tilted.x), off(tilted.y)) < 0.7 * side ? x : place(mesh, kind);
}
/// A sphere at rest anywhere, on either side: how many contacts, and do they carry its weight?
static void statics(Metrics& metrics) {
  double force = 0, wrong = 0;
  for (const Surface kind : {rectangles, fan, wild}) {
    const Mesh mesh = plane(kind, tilted.x, tilted.y);
    for (int k = 0; k < 300; ++k) {
      const Vec3 up = real(k % 2 ? 1 : -1) * tilted.z, at = place(mesh, k % 3);
      const Simulation sim(scene(""), mesh, {ball(at + real(R - overlap) * up, real(R))});
      Vec3 f;
      for (const auto& c : sim.contacts()) f += c.fn;
      force = std::max(force, double(norm(real(1 / weight) * f - up)));
      wrong += sim.contacts().size() != 1;
    }
  }
  metrics("plane_contacts", wrong), metrics("plane_force", force);
}
static Parameters material(const std::string& more) { return scene("Rmin = 0.005" + more); }
/// The state of a sphere after a time, started at `at` above a surface in the tilted frame.
static Particle after(const Parameters& p, const Mesh& mesh, const Particle& start, double time) {
  Simulation sim(p, mesh, {start});
  sim.run(std::lround(time / double(p.dt)));
  return sim.particles()[0];
}
static double difference(const Particle& a, const Particle& b, double speed) {
  return std::max({double(norm(a.v - b.v)) / speed, R * double(norm(a.w - b.w)) / speed,
                   double(norm(a.x - b.x)) / R});
}
/// Oblique impacts with spin at random places: against the same on one rectangle.
static void impacts(const Arguments& run, Metrics& metrics) {
  double worst = 0;
  for (const std::string scheme : {"consistent", "paper"})
    for (const Surface kind : {rectangles, fan, wild}) {
      const Mesh mesh = plane(kind, tilted.x, tilted.y), single = plane(one, tilted.x, tilted.y);
      for (int k = 0; k < (run.quick ? 20 : 200); ++k) {
        const Parameters p = material("; scheme = " + scheme);
        const auto any = [](double size) { return uniform(-size, size); };
        const Vec3 at = place(mesh, k % 3), v = tilted.at(any(1), any(1), -1),
                   w = tilted.at(any(200), any(200), any(200));
        const Particle start = ball(at + real(1.01 * R) * tilted.z, real(R), v, w);
        worst = std::max(worst, difference(after(p, mesh, start, 0.02),
                                           after(p, single, start, 0.02), double(norm(v))));
      }
    }
  metrics("plane_impact", worst);
}
/// Rolls and slides down a slope of 20 degrees over half of the plane and its seams.
static void slopes(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "slope.csv", "motion,surface,t_s,v_m_s,f_over_weight");
  struct Motion {
    const char *name, *friction;
    double mur, mus, worst = 0, acceleration = 0;
  };
  Motion motions[] = {{"rolls", "; mus = 0.5; mur = 0; mut = 0", 0, 1},
                      {"rolls with rolling friction", "; mus = 0.5; mur = 0.1; mut = 0", 0.1, 1},
                      {"slides", "; mus = 0.05; mur = 0; mut = 0", 0, 0.05}};
  for (Motion& m : motions) {
    Particle single{};
    for (int kind = 0; kind < surfaces; ++kind) {
      Parameters p = material(m.friction);
      const double angle = 20 * pi / 180;
      p.g = tilted.at(real(g * std::sin(angle)), 0, real(-g * std::cos(angle)));
      const double depth = overlap * std::pow(std::cos(angle), 2.0 / 3);
      const Particle start =
          ball(tilted.at(-0.9 * side, 0.0003, R - depth), real(R), tilted.at(0.1, 0.01, 0));
      Simulation sim(p, plane(Surface(kind), tilted.x, tilted.y), {start});
      while (double(dot(sim.particles()[0].x, tilted.x)) < 0.5 * side) {
        sim.run(20);
        const auto all = sim.contacts();
        const double f = all.empty() ? 0 : double(norm(all[0].fs)) / weight;
        csv.row(m.name, names[kind], double(sim.time()),
                double(dot(sim.particles()[0].v, tilted.x)), all.size() == 1 ? f : -1);
      }
      const Particle a = sim.particles()[0];
      if (kind == one) single = a;
      m.worst = std::max(m.worst, difference(a, single, double(norm(a.v))));
      sim.run(100);
      const double gained = double(dot(sim.particles()[0].v - a.v, tilted.x)), r = R - depth / 2,
                   sine = std::sin(angle), cosine = std::cos(angle),
                   closed = m.mus < 1 ? sine - m.mus * cosine
                                      : (sine - m.mur * R / r * cosine) / (1 + 0.4 * R * R / (r * r));
      m.acceleration = std::max(m.acceleration,
                                std::abs(gained / (100 * double(p.dt) * g * closed) - 1));
    }
  }
  double roll = std::max(motions[0].worst, motions[1].worst), acceleration = 0;
  metrics("plane_roll", roll), metrics("plane_slide", motions[2].worst);
  for (const Motion& m : motions) acceleration = std::max(acceleration, m.acceleration);
  metrics("plane_acceleration", acceleration);
}

// --------------------------------------------------------------------- wedges, prisms, corners

struct Loads {
  double x = 0, z = 0;
  int contacts = 0;
  void add(double force, double nx, double nz) {
    if (force > 0) x += force * nx, z += force * nz, ++contacts;
  }
};
/// On two half-planes that meet at the angle phi.
static Loads wedge_force(double phi, double px, double pz) {
  Loads sum;
  const double f[2][2] = {{1, 0}, {std::cos(phi), std::sin(phi)}};
  int feet = 0;
  for (const auto& d : f) {
    const double t = px * d[0] + pz * d[1];
    if (t <= 0) continue;
    const double nx = px - t * d[0], nz = pz - t * d[1], h = std::hypot(nx, nz);
    ++feet, sum.add(hertz(R - h), nx / h, nz / h);
  }
  if (const double h = std::hypot(px, pz); feet == 0) sum.add(hertz(R - h), px / h, pz / h);
  return sum;
}
/// How wrong are the forces and the number of contacts at a place of the cross section (x, z)?
static void compare(const Mesh& mesh, double x, double y, double z, const Loads& expected,
                    double& force, double& wrong) {
  const Simulation sim(scene(""), mesh, {ball(tilted.at(x, y, z), real(R))});
  Vec3 f;
  for (const auto& c : sim.contacts()) f += c.fn;
  const double size = hertz(0.01 * R);
  force = std::max(force, double(norm(real(1 / size) * (f - tilted.at(expected.x, 0, expected.z)))));
  wrong += int(sim.contacts().size()) != expected.contacts;
}
/// Two faces that meet at an angle phi on the side of the sphere: furrows below, ridges above 180.
static void wedges(const Arguments& run, Metrics& metrics) {
  double force = 0, wrong = 0;
  for (int degrees = 1; degrees < 360; degrees += run.quick ? 7 : 1) {
    if (degrees == 180) continue;
    const double phi = degrees * pi / 180, length = std::max(4.0, 1.5 / std::sin(phi / 2)) * R;
    Mesh mesh;
    for (const double a : {0.0, phi})
      cover(mesh, tilted.at(0, -4 * R, 0), tilted.at(0, 8 * R, 0),
            tilted.at(length * std::cos(a), 0, length * std::sin(a)), 6);
    for (int k = 0; k < 40; ++k) {
      // near the place in the bisector where both faces, or the edge, are touched
      const double depth = R * std::pow(10, uniform(-4, -2)),
                   far = phi < pi ? (R - depth) / std::sin(phi / 2) : R - depth,
                   turn = k % 4 ? phi / 2 + uniform(-1, 1) * std::min(0.02, phi / 4)
                                : uniform(0.1, 0.9) * phi,
                   px = far * std::cos(turn), pz = far * std::sin(turn);
      const Loads expected = wedge_force(phi, px, pz);
      compare(mesh, px, uniform(-2, 2) * R, pz, expected, force, wrong);
    }
  }
  metrics("wedge_force", force), metrics("wedge_contacts", wrong);
}
/// A cylinder of 10 R made of n facets, from inside (sign = 1) and from outside (-1).
static void prisms(const Arguments& run, Metrics& metrics) {
  double force = 0, wrong = 0;
  for (const int n : {8, 13, 21, 50, 100, 200}) {
    const double rho_c = 10 * R, theta = 2 * pi / n;
    Mesh mesh;
    for (int k = 0; k < n; ++k) {
      const auto at = [&](int i) {
        return tilted.at(rho_c * std::cos(i * theta), -3 * R, rho_c * std::sin(i * theta));
      };
      cover(mesh, at(k), at(k + 1) - at(k), tilted.at(0, 6 * R, 0), 2);
    }
    const double apothem = rho_c * std::cos(theta / 2), half = rho_c * std::sin(theta / 2);
    for (int k = 0; k < (run.quick ? 60 : 300); ++k) {
      const int sign = k % 2 ? 1 : -1;
      const double turn = uniform(0, 2 * pi), depth = R * std::pow(10, uniform(-4, -2)),
                   off = std::abs(std::remainder(turn - theta / 2, theta));  // from a facet's middle
      const double p = (sign > 0 ? apothem - R + depth : apothem + R - depth) / std::cos(off);
      const double px = p * std::cos(turn), pz = p * std::sin(turn);
      Loads expected;
      double nearest = 1e9;
      for (int i = 0; i < n; ++i) {
        const double a = (i + 0.5) * theta, c = std::cos(a), s = std::sin(a),
                     h = apothem - px * c - pz * s, t = pz * c - px * s,
                     beyond = std::max(0.0, std::abs(t) - half);
        if (sign > 0 && beyond == 0) expected.add(hertz(R - h), -c, -s);
        if (const double d = std::hypot(h, beyond); sign < 0 && h < 0 && d < nearest) {
          nearest = d, expected = {};
          const double along = t > 0 ? beyond : -beyond;
          expected.add(hertz(R - d), (-h * c - along * s) / d, (-h * s + along * c) / d);
        }
      }
      compare(mesh, px, uniform(-1, 1) * R, pz, expected, force, wrong);
    }
  }
  metrics("prism_force", force), metrics("prism_contacts", wrong);
}
/// Places that touch a known number of things; every face is cut up.
static void corners(Metrics& metrics) {
  const double d = R - overlap, a = 8 * R;
  struct Place {
    std::vector<std::array<Vec3, 3>> faces;  // o, u, v
    Vec3 at;
    size_t contacts;
  };
  const auto t = [](double x, double y, double z) { return tilted.at(x, y, z); };
  const double h = 0.3 * R, lower = std::sqrt(d * d - (R - h) * (R - h));
  const std::vector<Place> places = {
      // a corner of a room, a furrow and a bare edge
      {{{t(0, 0, 0), t(a, 0, 0), t(0, a, 0)}, {t(0, 0, 0), t(0, a, 0), t(0, 0, a)},
        {t(0, 0, 0), t(0, 0, a), t(a, 0, 0)}}, t(d, d, d), 3},
      {{{t(0, 0, 0), t(a, 0, 0), t(0, a, 0)}, {t(0, 0, 0), t(0, a, 0), t(0, 0, a)}}, t(d, R, d), 2},
      {{{t(0, 0, 0), t(a, 0, 0), t(0, a, 0)}}, t(-0.6 * d, R, 0.8 * d), 1},
      // the tip of a cube from outside
      {{{t(0, 0, 0), t(-a, 0, 0), t(0, -a, 0)}, {t(0, 0, 0), t(0, -a, 0), t(0, 0, -a)},
        {t(0, 0, 0), t(0, 0, -a), t(-a, 0, 0)}}, t(0.6 * d, 0.48 * d, 0.64 * d), 1},
      // in front of a step of height h: the floor and the edge
      {{{t(-a, -a, 0), t(a, 0, 0), t(0, 2 * a, 0)}, {t(0, -a, 0), t(0, 0, h), t(0, 2 * a, 0)},
        {t(0, -a, h), t(a, 0, 0), t(0, 2 * a, 0)}}, t(-lower, 0, d), 2},
      // on a slit of width R: both rims, and on a square hole: four
      {{{t(-a, -a, 0), t(a - R / 2, 0, 0), t(0, 2 * a, 0)}, {t(R / 2, -a, 0), t(a, 0, 0), t(0, 2 * a, 0)}},
       t(0, 0, std::sqrt(d * d - R * R / 4)), 2},
      {{{t(-a, -a, 0), t(a - R / 2, 0, 0), t(0, 2 * a, 0)}, {t(R / 2, -a, 0), t(a, 0, 0), t(0, 2 * a, 0)},
        {t(-R / 2, -a, 0), t(R, 0, 0), t(0, a - R / 2, 0)}, {t(-R / 2, R / 2, 0), t(R, 0, 0), t(0, a, 0)}},
       t(0, 0, std::sqrt(d * d - R * R / 4)), 4},
      // between two plates
      {{{t(-a, -a, 0), t(2 * a, 0, 0), t(0, 2 * a, 0)}, {t(-a, -a, 2 * d), t(2 * a, 0, 0), t(0, 2 * a, 0)}},
       t(0, 0, d), 2}};
  double wrong = 0;
  for (const Place& p : places)
    for (int k = 0; k < 20; ++k) {
      Mesh mesh;
      for (const auto& [o, u, v] : p.faces) cover(mesh, o, u, v, 5);
      const Simulation sim(scene(""), mesh, {ball(p.at, real(R))});
      wrong += sim.contacts().size() != p.contacts;
    }
  metrics("corner_contacts", wrong);
}

// ------------------------------------------------------------------------------------ limits

/// Upwards force over the weight at a height R - overlap above the first of two faces, at the way s
/// from their seam; the second one rises by `degrees`.
static double lift(double degrees, double depth, double s) {
  const double phi = pi - degrees * pi / 180;
  Mesh mesh;
  for (const double a : {0.0, phi})
    cover(mesh, tilted.at(0, -4 * R, 0), tilted.at(0, 8 * R, 0),
          tilted.at(8 * R * std::cos(a), 0, 8 * R * std::sin(a)), 1);
  const Simulation sim(scene(""), mesh, {ball(tilted.at(s, 0.1 * R, R - depth), real(R))});
  double up = 0;
  for (const auto& c : sim.contacts()) up += double(dot(c.fn, tilted.z));
  return up / hertz(depth);
}
static void limits(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "furrow.csv", "degrees,s_over_R,force");
  for (const double degrees : {0.0, 0.1, 0.5, 1.0, 2.0, 5.0}) {
    const double middle = (1 - 1e-3) * std::tan(degrees * pi / 360);
    for (double s = 0; s < 0.04; s += run.quick ? 0.01 : 0.0002)
      csv.row(degrees, s, lift(degrees, 1e-3 * R, (middle + s) * R));
  }
  // the second contact of a shallow furrow ends where its foot reaches the seam, still under load
  const double theta = pi / 180, end = std::tan(theta) * (1 - 1e-3);
  metrics("furrow_jump", lift(1, 1e-3 * R, (end - 1e-5) * R) - lift(1, 1e-3 * R, (end + 1e-5) * R));
  Mesh two = plane(rectangles, tilted.x, tilted.y);
  for (size_t k = 20; k < 40; ++k) two.elements[k].group = 1;
  Parameters p = scene("");
  p.Rmesh = {0, 0};
  const Simulation sim(p, two, {ball(tilted.at(0, R, R - overlap), real(R))});
  metrics("two_groups", double(sim.contacts().size()));
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  statics(metrics), impacts(run, metrics), slopes(run, metrics);
  wedges(run, metrics), prisms(run, metrics), corners(metrics);
  limits(run, metrics);
}
