// How many default steps a collision takes. Paper, Eq. (50): a dozen, for two equal particles at an
// indentation delta/(2 R*) of 10 % and e_n = 1/2.
//
// From the closed form of a head-on impact (case 2): y = delta^(5/4) = Y exp(-beta w s) sin(w_d s)
// with Y = (5/4) v / w_d, w^2 = (5/4) k / m*, w_d = w sqrt(1 - beta^2), k = (4/3) E* sqrt(R*). The
// time is t_c = int y^(-1/5) ds over half a period, a quadrature. The largest y gives the speed:
// y_max = (5/4) (v / w) exp(-beta acos(beta) / sqrt(1 - beta^2)).
#include <gsl/gsl_integration.h>

#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

namespace {
/// A head-on impact; ratio: radius of the partner over that of the particle, 0 = wall.
struct Impact {
  double en = 0.5, indentation = 0.1, ratio = 1, R = 0.01, E = 1e6, nu = 0.3, rho = 1000;
  std::string scheme = "consistent";
  double mstar() const {
    const double m = 4 * pi / 3 * rho * R * R * R, q = ratio * ratio * ratio;
    return ratio > 0 ? m * q / (1 + q) : m;
  }
  double Rstar() const { return ratio > 0 ? R * ratio / (1 + ratio) : R; }
  double k() const {
    return 4. / 3 * E / ((ratio > 0 ? 2 : 1) * (1 - nu * nu)) * std::sqrt(Rstar());
  }
  double beta() const { return en < 1 ? 1 / std::sqrt(1 + std::pow(pi / std::log(en), 2)) : 0; }
  double w() const { return std::sqrt(1.25 * k() / mstar()); }
  double speed() const {
    const double b = beta(), tail = b * std::acos(b) / std::sqrt(1 - b * b);
    return 0.8 * w() * std::pow(2 * Rstar() * indentation, 1.25) * std::exp(tail);
  }
  double eq50() const { return R * std::sqrt(rho * (1 - nu * nu) / E); }
};
double integrand(double s, void* impact) {
  const Impact& a = *static_cast<Impact*>(impact);
  const double wd = a.w() * std::sqrt(1 - a.beta() * a.beta());
  const double y = 1.25 * a.speed() / wd * std::exp(-a.beta() * a.w() * s) * std::sin(wd * s);
  return std::pow(std::max(y, 1e-300), -0.2);
}
double duration(Impact a) {
  gsl_function f{integrand, &a};
  double t = 0, error = 0;
  gsl_integration_workspace* space = gsl_integration_workspace_alloc(1000);
  gsl_integration_qags(&f, 0, pi / (a.w() * std::sqrt(1 - a.beta() * a.beta())), 0, 1e-10, 1000,
                       space, &t, &error);
  gsl_integration_workspace_free(space);
  return t;
}
Parameters parameters(const Impact& a, double step) {
  Parameters p =
      scene("mus = 0; mur = 0; mut = 0; scheme = " + a.scheme + setting("en", real(a.en)) +
            setting("E", real(a.E)) + setting("nu", real(a.nu)) + setting("rho", real(a.rho)));
  p.dt = real(step * a.eq50());
  return p;
}
/// The duration that a method shows; the end is interpolated inside its step.
double measured(const Impact& a, Method method, double step, double& evaluations) {
  const Parameters p = parameters(a, step);
  OneContact<double> c(p, a.ratio == 0);
  c.i.R = a.R, c.j.R = a.ratio * a.R, c.i.x.z = c.i.R + c.j.R, c.i.v.z = -a.speed();
  const double dt = double(p.dt);
  double before = 0, delta = 1;
  long n = 0;
  for (; delta > 0; ++n) before = std::max(c.delta(), 0.), c.step(method, dt), delta = c.delta();
  evaluations = double(c.evaluations);
  return (double(n) - delta / (delta - before)) * dt;
}
/// The same by the solver.
double solver(const Impact& a, double step) {
  const Parameters p = parameters(a, step);
  const Vec3 v{0, 0, real(-a.speed())};
  Simulation s =
      a.ratio > 0 ? two_spheres(p, real(a.R), real(a.ratio * a.R), v) : on_plate(p, real(a.R), v);
  double before = 0, delta = 1;
  const auto overlap = [&] {
    const auto all = s.particles();
    return a.R * (1 + a.ratio) - double(all[0].x.z - (a.ratio > 0 ? all[1].x.z : 0));
  };
  while (delta > 0) before = std::max(overlap(), 0.), s.run(1), delta = overlap();
  return double(s.time()) - delta / (delta - before) * double(p.dt);
}
void sweep(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "steps.csv", "partner,e_n,indentation,steps,steps_exact,steps_at_eq50");
  double worst = 0, ignored = 0, apart = 0;
  for (const double ratio : {1., 5., 0.})
    for (const double en : {0.1, 0.3, 0.5, 0.7, 0.9, 1.})
      for (const double d : {0.01, 0.02, 0.05, 0.1, 0.2}) {
        Impact a;
        a.en = en, a.indentation = d, a.ratio = ratio;
        const double exact = duration(a);
        const double t = measured(a, Method::semi_implicit_euler, 1. / 64, ignored);
        const double coarse = measured(a, Method::semi_implicit_euler, 1, ignored);
        if (d == 0.1) apart = std::max(apart, std::abs(solver(a, 1. / 64) / t - 1));
        if (en > 0.2) worst = std::max(worst, std::abs(t / exact - 1));
        file.row(ratio == 0  ? "wall"
                 : ratio > 1 ? "five times larger"
                             : "equal",
                 en, d, t / a.eq50(), exact / a.eq50(), coarse / a.eq50());
      }
  metric("duration", worst), metric("solver_apart", apart);
}
void claims(Metrics& metric) {
  Impact a;
  double ignored = 0;
  const auto steps = [&] {
    return measured(a, Method::semi_implicit_euler, 1. / 64, ignored) / a.eq50();
  };
  metric("dozen", std::abs(steps() / 12 - 1));
  double low = steps(), high = low;
  for (const double E : {1e5, 1e9})
    for (const double nu : {-0.5, 0., 0.49})
      for (const double R : {1e-4, 1.}) {
        a.E = E, a.nu = nu, a.R = R, a.rho = 1e4 * R + 500;
        low = std::min(low, steps()), high = std::max(high, steps());
      }
  metric("universal", high / low - 1);
  double step = 0;  // that of the solver, against Eq. (50) as it stands here
  for (const char* text : {"Rmin = 0.003; E = 7e8; nu = 0.1; rho = 2400", "nu = 0.5; E = 3e5"}) {
    const Parameters p = scene(text);
    step = std::max(step, std::abs(double(p.dt) / eq50(p, double(p.Rmin)) - 1));
  }
  metric("default_step", step);
  a = Impact(), a.ratio = 0;
  metric("wall", steps());
}
}  // namespace

int main(int argc, char** argv) {
  const Arguments arg(argc, argv);
  Metrics metric(arg.out);
  sweep(arg, metric), claims(metric);
  Work work(arg.out);
  Impact a;
  const double exact = duration(a);
  for (double step = 4; step > (arg.quick ? 0.03 : 0.002); step /= 2)
    for (const char* method : {"consistent", "paper", "velocity Verlet", "RK4"}) {
      const Timer timer;
      double n = 0;
      a.scheme = method == std::string("paper") ? method : "consistent";
      const Method m = method[0] == 'v'   ? Method::velocity_verlet
                       : method[0] == 'R' ? Method::rk4
                                          : Method::semi_implicit_euler;
      const double error = std::abs(measured(a, m, step, n) / exact - 1);
      work(method, step, n, timer.seconds(), error);
    }
}
