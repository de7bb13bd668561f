// How large may a time step be? A sphere at rest on a plate is nudged in one mode; the step at
// which the nudge starts to grow is found by bisection, and compared with linear theory.
//
// Theory: a step is a linear map of (velocities, springs); it is stable while no eigenvalue is
// larger than 1. Velocities are those of the centre, v, and of the surface, s = R w. With rho = r/R
//   sliding   vs = v - rho s,   fs = -(ks us + cs vs)      m v' = fs,   0.4 m s' = fr - rho fs
//   rolling   vr = rho s,       fr = -(kn ur + cn vr)
//   twisting  vt = s,           ft = -(ks ut + cs vt)      0.4 m s' = ft
//   normal    the derivative of kn d is 1.5 kn, so fn = -(1.5 kn un + cn vn)
// The schemes differ in when a spring advances. All stiffnesses are those of the static overlap.
#include <gsl/gsl_eigen.h>

#include "support.hpp"

using namespace verification;

static const double R = 0.002, g = 9.81;
struct Kind {
  std::string name;
  double mus, mur, mut;  // far above what a nudge asks for, or off
};
static const Kind kinds[] = {{"normal", 0, 0, 0},
                             {"sliding", 1e3, 0, 0},
                             {"rolling", 0, 1e3, 0},
                             {"twisting", 0, 0, 1e3},
                             {"sliding and rolling", 1e3, 1e3, 0}};
/// Constants of the static contact, Eqs. (12, 13, 18, 19, 21).
struct Contact {
  double m, delta, kn, ks, cn, cs;
  explicit Contact(double en) {
    const double E = 1e6, nu = 0.3, rho = 1000, logen = std::log(en);
    m = 4 * pi / 3 * rho * R * R * R;
    const double K = 4 * E / (3 * (1 - nu * nu)) * std::sqrt(R);
    delta = std::pow(m * g / K, 2.0 / 3), kn = K * std::sqrt(delta);
    ks = 8 * E / (2 * (2 - nu) * (1 + nu)) * std::sqrt(R * delta);
    const double beta = en < 1 ? 1 / std::sqrt(1 + pi * pi / (logen * logen)) : 0;
    cn = beta * std::sqrt(5 * m * kn), cs = beta * std::sqrt(m * ks / 6);
  }
};
/// A step of size h, linear in y = (v, s, u1, u2), as the scheme does it.
static void step(const Kind& kind, const Contact& c, bool paper, double h, double* y) {
  const double rho = (R - c.delta / 2) / R, v = y[0], s = y[1];
  if (kind.name == "normal") {
    y[0] -= h / c.m * (1.5 * c.kn * y[2] + c.cn * v), y[2] += h * y[0];
    return;
  }
  const double rate[2] = {kind.mut > 0 ? s : v - rho * s, rho * s};
  double u[2] = {y[2], y[3]};
  for (int k = 0; k < 2; ++k) {
    if (k == 0 ? kind.mur > 0 && kind.mus == 0 : kind.mur == 0) continue;  // a mode that is off
    y[2 + k] += h * rate[k];
    if (!paper) u[k] = y[2 + k];
  }
  const double f = -(c.ks * u[0] + c.cs * rate[0]), fr = -(c.kn * u[1] + c.cn * rate[1]);
  if (kind.mut > 0) y[1] += h / (0.4 * c.m) * f;
  if (kind.mus > 0) y[0] += h / c.m * f, y[1] -= h / (0.4 * c.m) * rho * f;
  if (kind.mur > 0) y[1] += h / (0.4 * c.m) * fr;
}
/// Largest modulus of an eigenvalue of the step.
static double radius(const Kind& kind, const Contact& c, bool paper, double h) {
  gsl_matrix* a = gsl_matrix_alloc(4, 4);
  for (size_t j = 0; j < 4; ++j) {
    double y[4] = {0, 0, 0, 0};
    y[j] = j < 2 ? 1 : h;  // springs in units of h
    step(kind, c, paper, h, y);
    for (size_t i = 0; i < 4; ++i) gsl_matrix_set(a, i, j, i < 2 ? y[i] : y[i] / h);
  }
  gsl_vector_complex* values = gsl_vector_complex_alloc(4);
  gsl_eigen_nonsymm_workspace* work = gsl_eigen_nonsymm_alloc(4);
  gsl_eigen_nonsymm(a, values, work);
  double largest = 0;
  for (size_t i = 0; i < 4; ++i) {
    const gsl_complex z = gsl_vector_complex_get(values, i);
    largest = std::max(largest, std::hypot(GSL_REAL(z), GSL_IMAG(z)));
  }
  gsl_eigen_nonsymm_free(work), gsl_vector_complex_free(values), gsl_matrix_free(a);
  return largest;
}
/// What moves in a mode.
static double motion(const Kind& kind, const Particle& a) {
  const double roll = R * std::abs(double(a.w.y)),
               slide = std::abs(double(a.v.x) - R * double(a.w.y));
  if (kind.name == "normal") return std::abs(double(a.v.z));
  if (kind.mut > 0) return R * std::abs(double(a.w.z));
  return kind.mur == 0 ? slide : kind.mus == 0 ? roll : slide + roll;
}
/// Does a nudge of 1e-9 m/s grow from the first twenty to the last of all steps? (What is unstable
/// may soon be large enough to slip or to bounce, and grows no further.)
static bool grows(const Kind& kind, double en, bool paper, double h, long steps) {
  Parameters p = scene("g = 0,0,-9.81; orientation = off" + setting("en", real(en)) +
                       setting("mus", real(kind.mus)) + setting("mur", real(kind.mur)) +
                       setting("mut", real(kind.mut)));
  p.dt = real(h), p.scheme = paper ? "paper" : "consistent";
  const bool normal = kind.name == "normal", twist = kind.mut > 0;
  const double size = 1e-9;
  const Vec3 v{real(normal || twist || kind.mus == 0 ? 0 : size), 0, real(normal ? size : 0)};
  const Vec3 w{0, real(kind.mur > 0 ? size / R : 0), real(twist ? size / R : 0)};
  Simulation sim = on_plate(p, real(R), v, w, real(Contact(en).delta));
  double first = 0, last = 0;
  try {
    for (int k = 0; k < 20; ++k) {
      sim.run(1), first = std::max(first, motion(kind, sim.particles()[0]));
    }
    sim.run(steps - 100);
    for (int k = 0; k < 80; ++k) {
      sim.run(1), last = std::max(last, motion(kind, sim.particles()[0]));
    }
  } catch (const tinydem::RunError&) { return true; }
  return !(last < 2 * first);
}
template <class F> static double onset(double low, double high, int bits, F unstable) {
  for (int k = 0; k < bits; ++k) {
    const double middle = std::sqrt(low * high);
    (unstable(middle) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}
/// Onset of a mode in units of sqrt(m/kn); 0 when nothing is stable.
static double theory(const Kind& kind, double en, bool paper) {
  const Contact c(en);
  const double unit = std::sqrt(c.m / c.kn);
  const double h =
      onset(1e-5, 10, 50, [&](double x) { return radius(kind, c, paper, x * unit) > 1 + 1e-10; });
  return h < 2e-5 ? 0 : h;
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  Csv curves(run.out / "theory.csv", "mode,scheme,en,kn_h2_over_m,dt_over_eq50");
  Csv points(run.out / "measured.csv",
             "mode,scheme,en,kn_h2_over_m,dt_over_eq50,theory_dt_over_eq50");
  double worst = 0, never = 0;
  for (const Kind& kind : kinds)
    for (const bool paper : {false, true}) {
      const char* scheme = paper ? "paper" : "consistent";
      const auto eq = [&](double en) {
        const Contact c(en);
        return std::sqrt(c.m / c.kn) / eq50(scene(""), R);
      };
      for (double en = 0.02; en < 0.9999; en += run.quick ? 0.1 : 0.01) {
        const double x = theory(kind, en, paper);
        curves.row(kind.name, scheme, en, x * x, x * eq(en));
      }
      for (const double en : {0.2, 0.35, 0.5, 0.65, 0.8, 1.0}) {
        if (run.quick && en != 0.5 && en != 1.0) continue;
        // the printed scheme grows slowly; where only the normal mode acts the schemes are the same
        if (paper && kind.name == "normal") continue;
        const long steps = !paper ? 4000 : run.quick ? 10000 : 40000;
        const Contact c(en);
        const double unit = std::sqrt(c.m / c.kn), x = theory(kind, en, paper);
        const auto unstable = [&](double y) { return grows(kind, en, paper, y * unit, steps); };
        if (x == 0) {  // nothing is stable: try a tenth of Eq. (50)
          never += !unstable(0.1 / eq(en));
          continue;
        }
        const double y = onset(0.8 * x, 1.25 * x, 10, unstable);
        points.row(kind.name, scheme, en, y * y, y * eq(en), x * eq(en));
        worst = std::max(worst, std::abs(y / x - 1));
      }
    }
  metrics("onset", worst);
  metrics("undamped_paper_stable", never);
  const auto limit = [&](int k, bool paper) { return std::pow(theory(kinds[k], 0.5, paper), 2); };
  const double logen = std::log(0.5), zeta = std::sqrt(5.0 / 6 / (1 + pi * pi / (logen * logen)));
  const double closed = std::pow(2 * (std::sqrt(1 + zeta * zeta) - zeta), 2) / 1.5;
  metrics("normal_closed_form", std::abs(limit(0, false) / closed - 1));
  // the tightest limit of each scheme, sliding and rolling against twisting, as a ratio of steps
  metrics("steps_ratio", std::sqrt(limit(4, false) / limit(3, true)));
}
