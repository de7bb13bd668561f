// A plane made of triangles is not flat: on a seam a sphere touches two of them.
//
// Coplanar elements: n elements that share the closest point push with n times the force, so that
// the static overlap there is delta n^(-2/3): n = 2 on an edge, 6 in a corner of a regular mesh.
// Beside the seam, at distance s, the far triangle is touched at its edge, with the centre at the
// height h:
//   overlap R - sqrt(h^2 + s^2), direction h/sqrt(h^2 + s^2) to the plane.
// The height for which both forces carry m g is the bump, exactly, for slow motion.
#include "support.hpp"

using namespace verification;

static const double R = 0.005, g = 9.81, E = 1e6, nu = 0.3, rho = 1000;
static const double K = 4 * E / (3 * (1 - nu * nu)) * std::sqrt(R),
                    weight = 4 * pi / 3 * rho * R * R * R * g;
static double static_overlap(double elements) { return std::pow(weight / (elements * K), 2.0 / 3); }
/// Height of the centre at a distance s from a straight seam.
static double height(double s) {
  double low = R - static_overlap(1), high = R - static_overlap(4);
  for (int k = 0; k < 100; ++k) {
    const double h = (low + high) / 2, d = std::hypot(h, s), beside = R > d ? R - d : 0;
    const double force = K * (std::pow(R - h, 1.5) + std::pow(beside, 1.5) * h / d);
    (force > weight ? low : high) = h;
  }
  return low;
}
/// A strip of n squares of edge a, from x = 0, about y = 0: rectangles or pairs of triangles. With
/// `one` a single rectangle.
static Mesh strip(int n, double a, bool triangles, bool one) {
  Mesh mesh;
  const auto vertex = [&](double x, double y) { mesh.vertices.push_back({real(x), real(y), 0}); };
  if (one) n = 1;
  for (int k = 0; k <= n; ++k)
    vertex(k * a * (one ? 20 : 1), -a / 2), vertex(k * a * (one ? 20 : 1), a / 2);
  for (int k = 0; k < n; ++k) {
    const int v = 2 * k;
    if (!triangles) mesh.elements.push_back({4, {v, v + 2, v + 3, v + 1}, 0});
    else {
      mesh.elements.push_back({3, {v, v + 2, v + 3, 0}, 0});
      mesh.elements.push_back({3, {v, v + 3, v + 1, 0}, 0});
    }
  }
  return mesh;
}
static Parameters rolling(const std::string& more) {
  return scene("Rmin = 0.005; mus = 0.5; mur = 0; g = 0,0,-9.81" + more);
}
/// At rest on a seam, and in a corner of six triangles.
static void statics(Metrics& metrics) {
  Mesh corner;
  corner.vertices = {{0, 0, 0}};
  for (int k = 0; k < 6; ++k) {
    corner.vertices.push_back(
        {real(0.05 * std::cos(k * pi / 3)), real(0.05 * std::sin(k * pi / 3)), 0});
    corner.elements.push_back({3, {0, 1 + k, 1 + (k + 1) % 6, 0}, 0});
  }
  double worst = 0;
  for (const int n : {1, 2, 6}) {
    const Mesh mesh = n == 1 ? plate(1) : n == 2 ? strip(20, 0.02, false, false) : corner;
    const double x = n == 2 ? 0.2 : 0, delta = static_overlap(n);
    Simulation sim(rolling("; mus = 0"), mesh,
                   {ball({real(x), 0, real(R - delta * 0.9)}, real(R))});
    sim.run(3000);
    const Particle a = sim.particles()[0];
    worst = std::max(worst, std::abs((R - double(a.x.z)) / delta - 1));
  }
  metrics("static_overlap", worst);
}
/// Placed at the height of the closed form: do the normal forces carry the weight?
static void profile(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "profile.csv", "s_m,lift_over_overlap,force_over_weight");
  const double reach =
      std::sqrt(2 * R * static_overlap(1));  // the far element is touched from here
  double worst = 0;
  for (double s = -1.5 * reach; s < 1.5 * reach; s += reach / 50) {
    Simulation sim(rolling(""), strip(20, 0.02, false, false),
                   {ball({real(0.2 + s), 0, real(height(std::abs(s)))}, real(R))});
    double up = 0;
    for (const auto& c : sim.contacts()) up += double(c.fn.z) / weight;
    csv.row(s, (height(std::abs(s)) - R) / static_overlap(1) + 1, up);
    worst = std::max(worst, std::abs(up - 1));
  }
  metrics("profile_force", worst);
}
struct Passage {
  double left = 0, lift = 0;  // share of the speed that is left; lift over the static overlap
};
/// Rolls over ten squares (0: one rectangle, 1: rectangles, 2: triangles); writes the way of x <
/// 0.12.
static Passage passage(int mesh, double v0, const Parameters& p,
                       const std::function<void(double, double)>& way) {
  const double delta = static_overlap(1), r = R - delta / 2;
  Simulation sim(p, strip(20, 0.02, mesh == 2, mesh == 0),
                 {ball({real(0.05), real(0.0031), real(R - delta)}, real(R), {real(v0), 0, 0},
                       {0, real(v0 / r), 0})});
  const long n = std::max(1L, std::lround(2e-5 / v0 / double(p.dt)));
  Passage result;
  Particle a = sim.particles()[0];
  while (double(a.x.x) < 0.25 && double(sim.time()) < 6) {
    sim.run(n), a = sim.particles()[0];
    const double up = (double(a.x.z) - R + delta) / delta;
    result.lift = std::max(result.lift, up);
    if (double(a.x.x) < 0.12) way(double(a.x.x), up);
  }
  result.left = double(a.x.x) < 0.25 ? 0 : double(a.v.x) / v0;
  return result;
}
static void roll(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "roll.csv", "mesh,v0_m_s,x_m,lift_over_overlap");
  Csv sum(run.out / "loss.csv", "mesh,scheme,v0_m_s,speed_left,largest_lift_over_overlap");
  const char* const names[] = {"one rectangle", "rectangles", "triangles"};
  double flat = 0;
  for (const double v0 : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0})
    for (int mesh = 0; mesh < 3; ++mesh)
      for (const std::string scheme : {"consistent", "paper"}) {
        if (run.quick && v0 > 0.25) continue;
        Parameters p = rolling("; scheme = " + scheme);
        p.dt *= real(0.25);
        const bool draw = scheme == "consistent" && (v0 == 0.1 || v0 == 1);
        const Passage a = passage(mesh, v0, p, [&](double x, double up) {
          if (draw) csv.row(names[mesh], v0, x, up);
        });
        sum.row(names[mesh], scheme, v0, a.left, a.lift);
        if (mesh == 0) flat = std::max({flat, std::abs(a.left - 1), a.lift});
      }
  metrics("one_rectangle", flat);
  double loss[2];
  for (const int fine : {0, 1}) {  // is it the step?
    Parameters p = rolling("");
    p.dt *= real(fine ? 1.0 / 32 : 0.25);
    const Passage a = passage(2, 0.2, p, [](double, double) {});
    loss[fine] = 1 - a.left;
    if (!fine) metrics("loss_on_triangles", loss[0]), metrics("lift_on_triangles", a.lift);
  }
  metrics("loss_change_with_step", std::abs(loss[1] / loss[0] - 1));
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  statics(metrics);
  profile(run, metrics);
  roll(run, metrics);
}
