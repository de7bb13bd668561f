// Head-on impact: the rebound is e_n times the impact, for every speed, size and material.
//
// With y = delta^(5/4) and d tau = delta^(1/4) dt, Eqs. (5, 10, 12, 14, 18) become the linear
//     y'' + 2 beta w y' + w^2 y = 0,   w^2 = (5/4) (4/3) E* sqrt(R*) / m*,
// because c_n goes as delta^(1/4). A contact that ends at delta = 0 lasts half a period of it, so
// that e = exp(-pi beta / sqrt(1 - beta^2)), which is e_n by Eq. (21). Were it to end where the
// force changes its sign, it would be exp(-2 beta acos(beta) / sqrt(1 - beta^2)), larger.
#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

namespace {
/// A head-on impact; lower = 0 is a wall. phase: part of a step at which the contact starts.
struct Impact {
  double en = 0.5, v = 1, upper = 0.01, lower = 0.01, step = 1, phase = 0;  // step: of Eq. (50)
  std::string material = "", scheme = "consistent";
  Parameters parameters() const {
    Parameters p =
        scene("mus = 0; mur = 0; mut = 0; scheme = " + scheme + material + setting("en", real(en)) +
              setting("Rmin", real(upper)) + setting("Rmax", real(upper + lower)));
    p.dt = real(step * eq50(p, upper));
    return p;
  }
};
/// The coefficient of restitution that the solver shows; counts its steps.
double solver(const Impact& a, double& steps) {
  const Parameters p = a.parameters();
  const Vec3 v{0, 0, real(-a.v)};
  const real gap = real(-a.phase * a.v) * p.dt;
  Simulation s = a.lower > 0 ? two_spheres(p, real(a.upper), real(a.lower), v, gap)
                             : on_plate(p, real(a.upper), v, {}, gap);
  s.run(2);
  while (!s.contacts().empty()) s.run(4);
  steps += double(s.time()) / double(p.dt);
  const auto end = s.particles();
  return double(a.lower > 0 ? end[0].v.z - end[1].v.z : end[0].v.z) / a.v;
}
/// The same with another method at the level of one contact; counts evaluations of the force.
double one_contact(const Impact& a, Method method, double& evaluations) {
  const Parameters p = a.parameters();
  OneContact<double> c(p, false);
  c.j.R = a.lower, c.i.R = a.upper, c.i.v.z = -a.v;
  const double dt = double(p.dt);
  c.i.x.z = a.upper + a.lower + a.phase * a.v * dt;
  c.step(method, dt), c.step(method, dt);
  while (c.delta() > 0) c.step(method, dt);
  evaluations += double(c.evaluations);
  return (c.i.v.z - c.j.v.z) / a.v;
}
/// Statistics of e over the phases of a step.
struct Spread {
  double rms = 0, low = 1e9, high = -1e9, count = 0;
  void add(double e, double en) {
    rms += (e - en) * (e - en), ++count, low = std::min(low, e), high = std::max(high, e);
  }
  double error() const { return std::sqrt(rms / count); }
};
template <class F> Spread over_phases(Impact a, int phases, F measure) {
  Spread s;
  for (int k = 0; k < phases; ++k) a.phase = (k + 0.5) / phases, s.add(measure(a), a.en);
  return s;
}

void curve(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "restitution.csv", "e_n,clipped,small_step,eq50_low,eq50_high");
  double fine = 0, coarse = 0, ignored = 0;
  for (double en = 0.05; en < 1.01; en += arg.quick ? 0.19 : 0.05) {
    Impact a;
    a.en = std::min(en, 1.0);
    const double beta = a.en < 1 ? 1 / std::sqrt(1 + std::pow(pi / std::log(a.en), 2)) : 0;
    const double clipped = std::exp(-2 * beta * std::acos(beta) / std::sqrt(1 - beta * beta));
    const Spread s = over_phases(a, 16, [&](const Impact& b) { return solver(b, ignored); });
    a.step = 1. / 64;
    const double e = solver(a, ignored);
    fine = std::max(fine, std::abs(e - a.en));
    coarse = std::max({coarse, std::abs(s.low - a.en), std::abs(s.high - a.en)});
    file.row(a.en, clipped, e, s.low, s.high);
  }
  metric("small_step", fine), metric("eq50", coarse);
}
void variations(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "variations.csv", "group,value,e_n,e");
  double worst = 0, ignored = 0;
  const auto measure = [&](const std::string& group, double value, Impact a) {
    for (const double en : {0.3, 0.6, 0.9}) {
      a.en = en, a.step = 1. / 64;
      const double e = solver(a, ignored);
      file.row(group, value, en, e), worst = std::max(worst, std::abs(e - en));
    }
  };
  Impact a;
  for (const double v : {0.001, 0.01, 0.1, 1., 3.}) a.v = v, measure("speed", v, a);
  a.v = 1;
  for (const double q : {1., 2., 5., 20.}) a.lower = q * a.upper, measure("size ratio", q, a);
  a.lower = 0, measure("wall", 0, a);
  a.lower = a.upper;
  double k = 0;
  for (const char* m : {"; E = 48e9; nu = 0.2; rho = 2800", "; E = 1e7; nu = 0.49; rho = 1100",
                        "; E = 210e9; nu = 0.3; rho = 7850", "; E = 2e9; nu = -0.5; rho = 200"})
    a.material = m, measure("material", k++, a);
  metric("variations", worst);
}
void work(const Arguments& arg, Metrics& metric) {
  Work file(arg.out);
  const int phases = arg.quick ? 16 : 32;
  const auto sweep = [&](double en, const std::string& method, auto measure) {
    std::vector<double> steps, errors;
    for (double step = 4; step > (arg.quick ? 0.01 : 0.002); step /= 2) {
      Impact a;
      a.en = en, a.step = step, a.scheme = method == "paper" ? method : "consistent";
      double cost = 0;
      const Timer timer;
      const Spread s = over_phases(a, phases, [&](const Impact& b) { return measure(b, cost); });
      if (en < 1) file(method, step, cost / phases, timer.seconds() / phases, s.error() / en);
      if (step < 0.6 && step > 0.03) steps.push_back(step), errors.push_back(s.error());
    }
    return order(steps, errors);
  };
  metric("order_damped", sweep(0.5, "consistent", solver));
  sweep(0.5, "paper", solver);
  for (const Method m : {Method::velocity_verlet, Method::rk4})
    sweep(0.5, name(m), [m](const Impact& a, double& n) { return one_contact(a, m, n); });
  metric("order_elastic", sweep(1, "consistent", solver));
}
/// Elastic, where the method is best, so that the rounding error of the precision shows.
void precision(const Arguments& arg) {
  Csv file(arg.out / "precision.csv", "dt_over_eq50,error");
  for (double step = 2; step > (arg.quick ? 0.01 : 0.001); step /= 2) {
    Impact a;
    double ignored = 0;
    a.en = 1, a.step = step;
    const auto measure = [&](const Impact& b) { return solver(b, ignored); };
    file.row(step, over_phases(a, 16, measure).error());
  }
}
}  // namespace

int main(int argc, char** argv) {
  const Arguments arg(argc, argv);
  precision(arg);
  if (!std::is_same_v<real, double>) return 0;
  Metrics metric(arg.out);
  curve(arg, metric), variations(arg, metric), work(arg, metric);
}
