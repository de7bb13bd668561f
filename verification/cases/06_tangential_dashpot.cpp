// The tangential dashpot: does the factor 1/6 of Eq. (19) make e_s equal to e_n?
//
// The claim concerns the dashpot alone: no friction spring, no Coulomb limit, a slow tangential
// motion on top of a head-on impact. Then  m* dv_s/dt = -f c_s v_s, with f = 1 if only the
// translation answers to the force, 5/2 if only the rotation of solid spheres does, and their sum,
// 7/2, for the contact point of free spheres. So e_s = exp(-(f / m*) int c_s dt), where
// c_s = sqrt(kappa / 30) c_n with kappa = k_s / k_n = 3 (1 - nu) / (2 - nu). In the variables of
// case 2 the normal motion is a damped spring, int c_n dt / m* = 2 beta w * pi / w_d = -2 ln(e_n),
// therefore
//     e_s = e_n^p,   p = f sqrt(2 kappa / 15).
// Here the solver's own law is integrated with GSL, and compared with that.
#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

namespace {
const double R = 0.01, speed = 1, slow = 1e-6;
const double poisson[] = {-0.5, 0, 0.3, 1. / 3, 0.45};

/// Two equal spheres under the law with the overlap `delta`, normal and tangential velocities.
OneContact<double> contact(double en, double nu) {
  OneContact<double> c(
      scene("mus = 1e9; mur = 0; mut = 0" + setting("en", real(en)) + setting("nu", real(nu))),
      false);
  c.i.R = c.j.R = R;
  return c;
}
Loading<double> at(OneContact<double>& c, double delta, double vn, double vs) {
  c.i.x = {0, 0, 2 * R - delta}, c.i.v = {vs, 0, vn}, c.u = {};
  return c.look();
}
struct Rebound {
  double normal, tangential;
};
/// The law with the dashpot of the sliding mode only, integrated to the end of the contact.
Rebound integrate(double en, double nu, double f) {
  OneContact<double> c = contact(en, nu);
  const double m = c.mass(c.i) / 2;
  Ode ode(
      [&](double, const double* y, double* dydt) {
        const Loading<double> load = at(c, y[0], y[1], slow * y[2]);
        dydt[0] = -y[1], dydt[1] = load.fn.z / m, dydt[2] = f * load.fs.x / m / slow;
      },
      {1e-3, speed, 1});
  double t = 0;
  std::vector<double> y{0, -speed, 1};
  ode.advance(
      t, y, 1, [](double, const double* state) { return state[0]; }, 1e-9);
  return {y[1] / speed, y[2]};
}
double exponent(double nu, double f) { return f * std::sqrt(2 * 3 * (1 - nu) / (2 - nu) / 15); }

void matching(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "matching.csv", "nu,reading,e_n,e_s,e_s_exact");
  double worst = 0, normal = 0, third = 0, standard = 0, free = 0;
  for (const double nu : poisson)
    for (const double f : {1., 2.5, 3.5})
      for (double en = 0.05; en < 0.999; en += arg.quick ? 0.19 : 0.05) {
        const Rebound r = integrate(en, nu, f);
        const double exact = std::pow(en, exponent(nu, f)), gap = std::abs(r.tangential - en);
        worst = std::max(worst, std::abs(r.tangential - exact));
        normal = std::max(normal, std::abs(r.normal - en));
        if (f == 2.5 && nu > 0.32 && nu < 0.34) third = std::max(third, gap);
        if (f == 2.5 && nu == 0.3) standard = std::max(standard, gap);
        if (f == 3.5 && nu == 0.3) free = std::max(free, gap);
        file.row(nu, f, en, r.tangential, exact);
      }
  metric("exponent", worst), metric("normal", normal), metric("claim_at_third", third);
  metric("claim_at_default", standard), metric("free_bodies", free);
}
void ratio(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "ratio.csv", "nu,cs_cn,cs_cn_exact");
  double worst = 0, outside = 0;
  for (double nu = -0.99; nu < 0.505; nu += 0.01) {
    OneContact<double> c = contact(0.5, std::min(nu, 0.5));
    const Loading<double> load = at(c, 1e-3, -speed, slow);
    const double cn = (load.kn * 1e-3 - load.fn.z) / -speed, cs = -load.fs.x / slow;
    const double exact = std::sqrt((1 - nu) / (10 * (2 - nu)));
    worst = std::max(worst, std::abs(cs / cn / exact - 1));
    outside = std::max({outside, 0.18 - cs / cn, cs / cn - 0.26});
    file.row(nu, cs / cn, exact);
  }
  metric("ratio", worst), metric("ratio_outside", outside);
}
}  // namespace

int main(int argc, char** argv) {
  const Arguments arg(argc, argv);
  Metrics metric(arg.out);
  matching(arg, metric), ratio(arg, metric);
}
