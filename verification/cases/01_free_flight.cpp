// Free flight and Stokes drag, Eqs. (3, 4, 42-46): every step is known in closed form.
//
// Semi-implicit Euler without drag:  v_n = v_0 + n g h,  x_n = x_0 + n h v_0 + g h^2 n (n + 1) / 2.
// With drag, v' = v + h (g - c v), so that v_n - g/c = (1 - c h)^n (v_0 - g/c); the geometric sum
// of the v_k gives x_n. The spin decays as (1 - gamma h)^n. For h -> 0: exponentials.
#include "support.hpp"

using namespace verification;

namespace {
const double R = 0.01, eta = 1, rho = 1000, g = 9.81;               // a marble in glycerine [SI]
const double c = 9 * eta / (2 * rho * R * R), gamma_ = 10 * c / 3;  // Stokes: 6 pi eta R / m, ...
const Vec3 v0{real(0.3), real(-0.2), real(0.1)}, w0{real(40), real(-70), real(20)};

struct State {
  double v[3], w[3], x[3];
};
State measured(const std::string& drag, const std::string& scheme, double h, long steps) {
  const Parameters p = scene("Rmin = 0.01; rho = 1000; g = 0,0,-9.81; scheme = " + scheme + drag +
                             setting("dt", real(h)));
  Simulation s(p, {}, {ball({}, real(R), v0, w0)});
  s.run(steps);
  const Particle a = s.particles()[0];
  return {{a.v.x, a.v.y, a.v.z}, {a.w.x, a.w.y, a.w.z}, {a.x.x, a.x.y, a.x.z}};
}
/// The exact answer of the method after n steps (h > 0), or of the motion at time t (h = 0).
State exact(double drag, double h, double n, double t) {
  const double vs[] = {v0.x, v0.y, v0.z}, ws[] = {w0.x, w0.y, w0.z}, gs[] = {0, 0, -g};
  State s{};
  for (int k = 0; k < 3; ++k) {
    if (drag == 0) {
      s.v[k] = vs[k] + gs[k] * t, s.w[k] = ws[k];
      s.x[k] = vs[k] * t + gs[k] * (h > 0 ? h * h * n * (n + 1) / 2 : t * t / 2);
      continue;
    }
    const double end = gs[k] / drag, a = vs[k] - end;
    const double lost = -std::expm1(h > 0 ? n * std::log1p(-drag * h) : -drag * t);
    s.v[k] = end + (1 - lost) * a;
    s.x[k] = end * t + a * lost / drag * (h > 0 ? 1 - drag * h : 1);
    s.w[k] = ws[k] * (h > 0 ? std::pow(1 - 10 * drag / 3 * h, n) : std::exp(-10 * drag / 3 * t));
  }
  return s;
}
/// Largest difference, each relative to the size of the exact vector.
double difference(const State& a, const State& b) {
  double worst = 0;
  const auto compare = [&](const double* p, const double* q) {
    const double size = std::hypot(q[0], q[1], q[2]);
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(p[k] - q[k]) / size);
  };
  compare(a.v, b.v), compare(a.w, b.w), compare(a.x, b.x);
  return worst;
}
const std::string with_drag = "; eta = 1";

void fall(const Arguments& arg, double step) {
  Csv file(arg.out / "fall.csv", "t_s,h_c,vz_m_s,vz_exact_m_s,wy_1_s,wy_exact_1_s");
  for (const double hc : {0.5, 0.1, step * c}) {
    const double h = hc / c;
    const long stride = std::max(1L, std::lround(0.05 / hc));
    for (long n = 0; double(n) * hc < 4; n += stride) {
      const State a = measured(with_drag, "consistent", h, n);
      const State b = exact(c, 0, 0, double(n) * h);
      file.row(double(n) * h, hc, a.v[2], b.v[2], a.w[1], b.w[1]);
    }
  }
}
}  // namespace

int main(int argc, char** argv) {
  const Arguments arg(argc, argv);
  const double step = eq50(scene("rho = 1000"), R);
  Metrics metric(arg.out);
  Csv discrete(arg.out / "discrete.csv", "drag,step_over_eq50,steps,difference");
  double free = 0, dragged = 0;
  for (const double factor : {0.01, 1., 36.})  // 36: the spin overshoots, 1 - gamma h = -0.63
    for (const long n : {1L, 10L, 100L, arg.quick ? 1000L : 10000L}) {
      const double h = factor * step, t = double(n) * h;
      const auto compare = [&](const std::string& text, double drag, double& worst) {
        const double error =
            difference(measured(text, "consistent", h, n), exact(drag, h, double(n), t));
        worst = std::max(worst, error);
        discrete.row(drag > 0 ? "on" : "off", factor, n, error);
      };
      if (g * t * h < R / 2) compare("", 0, free);  // the solver refuses to move R in one step
      if (gamma_ * t < 20) compare(with_drag, c, dragged);  // later the spin is rounding error
    }
  metric("free_discrete", free), metric("drag_discrete", dragged);
  const State end = measured(with_drag, "consistent", 0.1 / c, 2000);
  metric("terminal", std::abs(end.v[2] * c / -g - 1));

  Work work(arg.out);
  double apart = 0;
  std::vector<double> steps, errors;
  for (const char* scheme : {"consistent", "paper"})
    for (double n = 4; n < (arg.quick ? 3000 : 60000); n *= 2) {
      const double t = 1 / c, h = t / n;
      const Timer timer;
      const State a = measured(with_drag, scheme, h, long(n));
      const double seconds = timer.seconds(), error = difference(a, exact(c, 0, 0, t));
      work(scheme, h / step, n, seconds, error);
      const State same = measured(with_drag, "consistent", h, long(n));
      apart = std::max(apart, difference(a, same));
      if (n >= 64 && n < 3000) steps.push_back(h), errors.push_back(error);
    }
  metric("order_defect", std::abs(order(steps, errors) - 1));
  metric("schemes_apart", apart);
  fall(arg, step);
}
