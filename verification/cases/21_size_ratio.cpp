// A small sphere on the neck between two large fixed ones (after Vyas and others, 2025).
//
// The large spheres, of radius R, touch at the origin, with their centres on the y axis. The small
// one (r) starts on the circle around the neck, 1 degree from its top, and must roll off. Rigid
// limit, with d = R + r - delta, the circle's radius rho = sqrt(d^2 - R^2), cos psi = rho/d, and r'
// = r - delta/2:
//   2 N cos psi = m (g cos theta - rho theta'^2)                     each contact presses with N
//   m rho theta'' = m g sin theta - 2 f,   2/5 m r^2 w' = 2 f r' cos psi
//   sticks, rho theta' = r' cos psi w, while f <= mus N; then f = mus N;   it leaves when N = 0.
// Rolling and twisting friction are off: a sphere that rolls in a groove also twists at its
// contacts. For mus > tan(wedge) = cos psi/sin psi the groove is a self-locking wedge: friction can
// keep the elastic pressure of the start although no load is left, and the rigid limit says nothing
// about N.
#include "support.hpp"

using namespace verification;

static const double R = 0.005, g = 9.81, E = 1e7, nu = 0.3, rho_m = 2500;
struct Groove {
  double mus, r, m, delta, radius, cosine, lever;
  Groove(double small, double mu)
      : mus(mu), r(small), m(4 * pi / 3 * rho_m * small * small * small) {
    const double K = 4 * E / (3 * (1 - nu * nu)) * std::sqrt(r);
    radius = std::sqrt((R + r) * (R + r) - R * R), cosine = radius / (R + r);
    delta = std::pow(m * g / (2 * cosine * K), 2.0 / 3);
    const double d = R + r - delta;
    radius = std::sqrt(d * d - R * R), cosine = radius / d, lever = (r - delta / 2) * cosine;
  }
};
struct Path {
  std::vector<double> t, theta;  // 20 moments until it leaves
  double leaves = 0, slips = 0;  // angles [rad]
};
/// By GSL: sticks, slips, leaves.
static Path reference(const Groove& c, double start) {
  const auto press = [&](const double* y) {  // 2 N/m
    return (g * std::cos(y[0]) - c.radius * y[1] * y[1]) / c.cosine;
  };
  const double kappa = 0.4 * c.r * c.r / (c.lever * c.lever);
  const auto stick = [&](double, const double* y, double* dy) {
    dy[0] = y[1], dy[1] = g * std::sin(y[0]) / c.radius / (1 + kappa);
  };
  const auto slip = [&](double, const double* y, double* dy) {
    dy[0] = y[1], dy[1] = (g * std::sin(y[0]) - c.mus * press(y)) / c.radius;
  };
  const auto spare = [&](double, const double* y) {
    return c.mus * press(y) - kappa / (1 + kappa) * g * std::sin(y[0]);
  };
  const auto load = [&](double, const double* y) { return press(y); };
  Ode first(stick, {1, 100}), second(slip, {1, 100});
  Path path;
  std::vector<double> y{start, 0};
  double t = 0;
  first.advance(t, y, 10, spare);
  const double t_slip = t;
  path.slips = y[0];
  second.advance(t, y, 10, load);
  path.leaves = y[0];
  const double end = t;
  y = {start, 0}, t = 0;
  for (int k = 1; k <= 20; ++k) {
    const double moment = 0.98 * end * k / 20;
    if (moment <= t_slip) first.advance(t, y, moment);
    else {
      if (t < t_slip) first.advance(t, y, t_slip);
      second.advance(t, y, moment);
    }
    path.t.push_back(moment), path.theta.push_back(y[0]);
  }
  return path;
}
struct Run {
  double error = 0, leaves = 0, aside = 0, wall_time = 0;  // leaves: [deg]
  long steps = 0;
  std::vector<double> theta{};
};
static double angle(const Particle& a) { return std::atan2(double(a.x.x), double(a.x.z)); }
/// The solver, `step` in units of Eq. (50) of the small sphere.
static Run roll(const Groove& c, const Path& path, const std::string& scheme, double step) {
  Parameters p = scene(
      "E = 1e7; rho = 2500; mur = 0; mut = 0; en = 0.5; g = 0,0,-9.81; Rmesh = 0.005; scheme = " +
      scheme + setting("mus", real(c.mus)));
  const double start = pi / 180;
  Mesh mesh;
  mesh.vertices = {{0, real(-R), 0}, {0, real(R), 0}};
  mesh.elements = {{1, {0, 0, 0, 0}, 0}, {1, {1, 0, 0, 0}, 0}};
  const Vec3 x{real(c.radius * std::sin(start)), 0, real(c.radius * std::cos(start))};
  p.dt = real(step * eq50(p, c.r));
  Run result;
  const Timer timer;
  Simulation sim(p, mesh, {ball(x, real(c.r))});
  for (const double t : path.t) {  // to the step nearest to the moment, then along the tangent
    const long n = std::lround(t / double(p.dt));
    sim.run(n - result.steps), result.steps = n;
    const Particle a = sim.particles()[0];
    const double late = t - double(n) * double(p.dt), r2 = double(a.x.x * a.x.x + a.x.z * a.x.z);
    result.theta.push_back(angle(a) + late * double(a.v.x * a.x.z - a.v.z * a.x.x) / r2);
    result.error =
        std::max(result.error, std::abs(result.theta.back() - path.theta[result.theta.size() - 1]));
    result.aside = std::max(result.aside, std::abs(double(a.x.y)) / c.r);
  }
  result.wall_time = timer.seconds();
  double at = result.theta.back();
  // until it is in the air, or at the bottom of the neck, or has stuck for half a second
  const double latest = 0.5 + path.t.back();
  while (at > 0 && !sim.contacts().empty() && double(sim.time()) < latest) {
    sim.run(std::max(1L, std::lround(0.1 / step))), at = angle(sim.particles()[0]);
  }
  result.leaves = at > 0 ? at * 180 / pi : 180;
  return result;
}
/// Not self-locking: the rigid limit is the reference.
static void below(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "below.csv",
          "ratio,scheme,leaves_exact_deg,leaves_deg,largest_error_rad,aside");
  Csv tracks(run.out / "tracks.csv", "ratio,scheme,t_s,theta_exact_deg,theta_deg");
  double worst = 0, leaves = 0, aside = 0;
  for (const double ratio : {5.0, 10.0, 20.0, 50.0}) {
    if (run.quick && ratio != 5) continue;
    const Groove c(R / ratio, 0.15);
    const Path path = reference(c, pi / 180);
    for (const std::string scheme : {"consistent", "paper"}) {
      const Run a = roll(c, path, scheme, 1);
      const double exact = path.leaves * 180 / pi;
      csv.row(ratio, scheme, exact, a.leaves, a.error, a.aside);
      for (size_t k = 0; k < path.t.size(); ++k)
        tracks.row(ratio, scheme, path.t[k], path.theta[k] * 180 / pi, a.theta[k] * 180 / pi);
      if (scheme == "paper") continue;
      worst = std::max(worst, a.error), leaves = std::max(leaves, std::abs(a.leaves - exact));
      aside = std::max(aside, a.aside);
      if (ratio == 5) metrics("path_ratio_5", a.error);
    }
  }
  metrics("path", worst);
  metrics("leaves_deg", leaves);
  metrics("aside", aside);
}
/// The published coefficient of friction: where does it leave, over the step?
static void published(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "published.csv", "ratio,scheme,dt_over_eq50,leaves_rigid_deg,leaves_deg");
  long circles = 0;
  for (const double ratio : {5.0, 10.0, 20.0, 50.0}) {
    const Groove c(R / ratio, 0.5);
    const Path path = reference(c, pi / 180);
    for (const std::string scheme : {"consistent", "paper"})
      for (double step = 2; step > (run.quick ? 0.6 : 0.1); step /= 2) {
        const Run a = roll(c, path, scheme, step);
        csv.row(ratio, scheme, step, path.leaves * 180 / pi, a.leaves);
        if (step == 1 && scheme == "consistent") circles += a.leaves > 150;
        if (step == 1 && scheme == "consistent" && ratio == 5)
          metrics("leaves_ratio_5_deg", std::abs(a.leaves - path.leaves * 180 / pi));
      }
  }
  metrics("circles_the_neck", double(circles));
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  below(run, metrics);
  published(run, metrics);
  Work work(run.out);
  const Groove c(R / 5, 0.15);
  const Path path = reference(c, pi / 180);
  for (const std::string scheme : {"consistent", "paper"})
    for (double step = 8; step > (run.quick ? 0.9 : 0.1); step /= 2) {
      const Run a = roll(c, path, scheme, step);
      work(scheme, step, 2 * double(a.steps), a.wall_time, a.error);
    }
}
