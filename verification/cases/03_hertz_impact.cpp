// Elastic impact of stiff spheres (Chung and Ooi 2011, tests 1, 2): peak force, overlap, duration.
//
// Hertz: m* v^2 / 2 = (2/5) k delta^(5/2) with k = (4/3) E* sqrt(R*), so
//   delta_max = (5 m* v^2 / (4 k))^(2/5),   F_max = k delta_max^(3/2),
//   t_c = 2 (delta_max / v) int_0^1 dx / sqrt(1 - x^(5/2))
//       = 2 sqrt(pi) Gamma(7/5) / Gamma(9/10) delta_max / v.
// Two equal spheres: E* = E / (2 (1 - nu^2)), R* = R/2, m* = m/2, v the approach of both. Rigid
// wall: E* = E / (1 - nu^2), R* = R, m* = m.
#include <gsl/gsl_sf_gamma.h>

#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

namespace {
/// SI units; R: radius, v: speed of each sphere. Published: force [N], overlap [m], duration [s].
struct Test {
  const char* name;
  double E, nu, rho, R, v;
  bool wall;
  double force, overlap, duration;
};
const Test tests[] = {
    {"glass-glass", 48e9, 0.20, 2800, 0.01, 10, false, 10696.9, 274.113e-6, 40.34e-6},
    {"limestone-limestone", 20e9, 0.25, 2500, 0.01, 10, false, 7108.2, 368.304e-6, 54.20e-6},
    {"aluminium-wall", 70e9, 0.30, 2699, 0.1, 0.2, true, 11369.9, 49.717e-6, 0},
    {"magnesium-wall", 40e9, 0.35, 1800, 0.1, 0.2, true, 7232.7, 52.123e-6, 0}};
struct Peak {
  double force = 0, overlap = 0, duration = 0, rebound = 0, evaluations = 0;
};
Peak hertz(const Test& a) {
  const double bodies = a.wall ? 1 : 2, m = 4 * pi / 3 * a.rho * a.R * a.R * a.R / bodies;
  const double k = 4. / 3 * a.E / (bodies * (1 - a.nu * a.nu)) * std::sqrt(a.R / bodies);
  const double v = bodies * a.v, delta = std::pow(5 * m * v * v / (4 * k), 0.4);
  const double t = 2 * std::sqrt(pi) * gsl_sf_gamma(1.4) / gsl_sf_gamma(0.9) * delta / v;
  return {k * std::pow(delta, 1.5), delta, t, 1, 0};
}
Parameters parameters(const Test& a, const std::string& scheme, double step) {
  Parameters p =
      scene("en = 1; mus = 0; mur = 0; mut = 0; scheme = " + scheme + setting("E", real(a.E)) +
            setting("nu", real(a.nu)) + setting("rho", real(a.rho)) + setting("Rmin", real(a.R)) +
            setting("Rmax", real(a.R)));
  p.dt = real(step * eq50(p, a.R));
  return p;
}
/// Peaks over the steps; the end of the contact is interpolated inside its step.
template <class Step, class Overlap, class Force>
Peak record(double dt, Step step, Overlap overlap, Force force) {
  Peak peak;
  double before = 0, delta = 0;
  for (long n = 1;; ++n) {
    step(), before = delta, delta = overlap(), peak.evaluations = double(n);
    if (delta <= 0) return peak.duration = (double(n) - delta / (delta - before)) * dt, peak;
    peak.overlap = std::max(peak.overlap, delta), peak.force = std::max(peak.force, force());
  }
}
Peak solver(const Test& a, const std::string& scheme, double step) {
  const Parameters p = parameters(a, scheme, step);
  const Vec3 v{0, 0, real(-a.v)};
  Simulation s =
      a.wall
          ? on_plate(p, real(a.R), v)
          : Simulation(p, {}, {ball({0, 0, real(2 * a.R)}, real(a.R), v), ball({}, real(a.R), -v)});
  const auto overlap = [&] {
    const auto all = s.particles();
    return a.R * (a.wall ? 1 : 2) - double(all[0].x.z - (a.wall ? 0 : all[1].x.z));
  };
  const auto force = [&] { return double(norm(s.contacts().at(0).fn)); };
  Peak peak = record(
      double(p.dt), [&] { s.run(1); }, overlap, force);
  peak.rebound = double(s.particles()[0].v.z) / a.v;
  return peak;
}
Peak one_contact(const Test& a, Method method, double step) {
  const Parameters p = parameters(a, "consistent", step);
  OneContact<double> c(p, a.wall);
  c.i.R = c.j.R = a.R, c.i.v.z = -a.v, c.j.v.z = a.v, c.i.x.z = (a.wall ? 1 : 2) * a.R;
  Peak peak = record(
      double(p.dt), [&] { c.step(method, double(p.dt)); }, [&] { return c.delta(); },
      [&] { return norm(c.look().fn); });
  return peak.rebound = c.i.v.z / a.v, peak.evaluations = double(c.evaluations), peak;
}
void history(const Arguments& arg) {
  Csv file(arg.out / "history.csv", "test,t_s,delta_m,force_N,delta_max_m,force_max_N,duration_s");
  for (const Test& a : tests) {
    const Peak exact = hertz(a);
    const Parameters p = parameters(a, "consistent", 1);
    OneContact<double> c(p, a.wall);
    c.i.R = c.j.R = a.R, c.i.v.z = -a.v, c.j.v.z = a.v, c.i.x.z = (a.wall ? 1 : 2) * a.R;
    for (int n = 1; n <= 42; ++n) {
      c.step(Method::semi_implicit_euler, exact.duration / 40);
      file.row(a.name, n * exact.duration / 40, std::max(c.delta(), 0.), norm(c.look().fn),
               exact.overlap, exact.force, exact.duration);
    }
  }
}
double error(double x, double reference) { return std::abs(x / reference - 1); }
void peaks(const Arguments& arg, Metrics& metric) {
  Csv table(arg.out / "peaks.csv",
            "test,source,force_N,overlap_um,duration_us,force_error,overlap_error,duration_error");
  double force = 0, overlap = 0, duration = 0, published = 0, rebound = 0;
  for (const Test& a : tests) {
    const Peak exact = hertz(a), s = solver(a, "consistent", 1. / 64);
    force = std::max(force, error(s.force, exact.force));
    overlap = std::max(overlap, error(s.overlap, exact.overlap));
    duration = std::max(duration, error(s.duration, exact.duration));
    rebound = std::max(rebound, error(s.rebound, 1));
    const double time = a.duration > 0 ? error(s.duration, a.duration) : 0;
    published = std::max({published, error(s.force, a.force), error(s.overlap, a.overlap), time});
    table.row(a.name, "published", a.force, a.overlap * 1e6, a.duration * 1e6,
              error(a.force, exact.force), error(a.overlap, exact.overlap),
              a.duration > 0 ? error(a.duration, exact.duration) : 0);
    table.row(a.name, "solver", s.force, s.overlap * 1e6, s.duration * 1e6,
              error(s.force, exact.force), error(s.overlap, exact.overlap),
              error(s.duration, exact.duration));
  }
  metric("force", force), metric("overlap", overlap), metric("duration", duration);
  metric("rebound", rebound), metric("published", published);
}
}  // namespace

int main(int argc, char** argv) {
  const Arguments arg(argc, argv);
  Metrics metric(arg.out);
  peaks(arg, metric), history(arg);
  Work work(arg.out);
  std::vector<double> steps, errors;
  const Test& glass = tests[0];
  const auto add = [&](const std::string& method, double step, auto measure) {
    const Timer timer;
    const Peak p = measure();
    const double e = error(p.duration, hertz(glass).duration);
    return work(method, step, p.evaluations, timer.seconds(), e), e;
  };
  for (double step = 4; step > (arg.quick ? 0.03 : 0.002); step /= 2) {
    const double e = add("consistent", step, [&] { return solver(glass, "consistent", step); });
    if (step > 0.03 && step < 3) steps.push_back(step), errors.push_back(e);
    add("paper", step, [&] { return solver(glass, "paper", step); });
    for (const Method m : {Method::velocity_verlet, Method::rk4})
      add(name(m), step, [&] { return one_contact(glass, m, step); });
  }
  metric("order", order(steps, errors));
}
