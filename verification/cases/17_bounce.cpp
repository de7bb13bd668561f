// A sphere that is dropped on a plate bounces, again and again (MFIX DEM01 and DEM02 with Hertz's
// force).
//
// Flight is a parabola. In contact, with d = R - z:  m z'' = K d^(3/2) - beta sqrt(5 m K) d^(1/4)
// z' - m g, until d = 0 again; GSL integrates it and finds that moment. Gravity acts during the
// contact as well, so that the rebound is slower than e_n demands, the more so the slower the
// impact.
#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

static const double R = 0.1, g = 9.81, h0 = 0.5;  // centre at h0 above the ground
static Parameters drop(double en, const std::string& scheme = "consistent") {
  return scene("Rmin = 0.1; Rmax = 0.1; rho = 2600; mus = 0; mur = 0; g = 0,0,-9.81; scheme = " +
               scheme + setting("en", real(en)));
}
struct Bounce {
  double t_in, v_in, v_out, t_contact, apex;  // apex: height of the centre above the ground
};
/// The bounces whose apex leaves the plate, up to five, by GSL.
static std::vector<Bounce> reference(double en) {
  const Parameters p = drop(en);
  const double nu = double(p.nu), K = 4 * double(p.E) / (3 * (1 - nu * nu)) * std::sqrt(R);
  const double m = 4 * pi / 3 * double(p.rho) * R * R * R, logen = std::log(en);
  const double beta = en < 1 ? 1 / std::sqrt(1 + pi * pi / (logen * logen)) : 0;
  Ode ode(
      [&](double, const double* y, double* dy) {
        const double d = R - y[0] > 0 ? R - y[0] : 0;
        dy[0] = y[1];
        dy[1] =
            (K * std::pow(d, 1.5) - beta * std::sqrt(5 * m * K) * std::pow(d, 0.25) * y[1]) / m - g;
      },
      {R, 1});
  std::vector<Bounce> all;
  double t = std::sqrt(2 * (h0 - R) / g), v = g * t;
  while (all.size() < 5) {
    double end = t;
    std::vector<double> y{R - 1e-12 * R, -v};
    if (!ode.advance(
            end, y, t + 0.5, [](double, const double* z) { return R - z[0]; }, 1e-6))
      break;
    const double apex = R + y[1] * y[1] / (2 * g);
    if (apex < R + 0.05 * R) break;
    all.push_back({t, v, y[1], end - t, apex});
    t = end + 2 * y[1] / g, v = y[1];
  }
  return all;
}
/// Falls since a share of a step, so that it meets the plate in another phase of a step.
static Vec3 start(double ago, double& speed) {
  speed = -g * ago;
  return {0, 0, real(h0 - g * ago * ago / 2)};
}
/// Heights of the apexes; `advance` makes a step and answers (height, velocity).
template <class F> static std::vector<double> apexes(F advance, double dt, size_t n) {
  std::vector<double> all;
  double before = -1;
  for (long k = 0; all.size() < n && double(k) * dt < 6; ++k) {
    const std::pair<double, double> now = advance();
    if (before > 0 && now.second <= 0 &&
        now.first > R)  // h + v^2/2g is the same all along a flight
      all.push_back(now.first + now.second * now.second / (2 * g));
    before = now.second;
  }
  return all.resize(n, 0), all;
}
struct Stepper {
  std::string name;
  double step;  // in units of Eq. (50)
};
/// Root of the mean square, over bounces and phases, of the error of the apex over the drop.
static double apex_error(double en, const Stepper& method, const std::vector<Bounce>& exact,
                         long& count) {
  Parameters p = drop(en, method.name == "paper" ? "paper" : "consistent");
  const double dt = method.step * eq50(p, R);
  p.dt = real(dt);
  double sum = 0;
  for (double phase = 0; phase < 4; ++phase) {
    double speed;
    const Vec3 x = start(phase / 4 * dt, speed);
    std::vector<double> tops;
    if (method.name == "paper" || method.name == "consistent") {
      Simulation sim(p, plate(100), {ball(x, real(R), {0, 0, real(speed)})});
      tops = apexes(
          [&] {
            sim.run(1), ++count;
            const Particle a = sim.particles()[0];
            return std::make_pair(double(a.x.z), double(a.v.z));
          },
          dt, exact.size());
    } else {
      OneContact<double> c(p, true);
      c.i = {{0, 0, double(x.z)}, {0, 0, speed}, {}, R};
      const Method m = method.name == "RK4" ? Method::rk4 : Method::velocity_verlet;
      tops = apexes(
          [&] {
            c.step(m, dt);
            return std::make_pair(c.i.x.z, c.i.v.z);
          },
          dt, exact.size());
      count += c.evaluations;
    }
    for (size_t k = 0; k < exact.size(); ++k)
      sum += std::pow((tops[k] - exact[k].apex) / (h0 - R), 2);
  }
  return std::sqrt(sum / (4 * double(exact.size())));
}
/// Height over time at a small and at the default step, beside the exact apexes.
static void tracks(const Arguments& run) {
  Csv csv(run.out / "track.csv", "en,dt_over_eq50,t_s,height_m");
  Csv exact(run.out / "bounces.csv",
            "en,bounce,t_in_s,v_in_m_s,v_out_m_s,contact_s,apex_m,t_apex_s");
  for (const double en : {1.0, 0.9, 0.7, 0.5}) {
    int k = 0;
    for (const Bounce& b : reference(en))
      exact.row(en, ++k, b.t_in, b.v_in, b.v_out, b.t_contact, b.apex,
                b.t_in + b.t_contact + b.v_out / g);
    for (const double step : {2.0, 1.0}) {
      Parameters p = drop(en);
      p.dt *= real(step);
      Simulation sim(p, plate(100), {ball({0, 0, real(h0)}, real(R))});
      for (; double(sim.time()) < 2.2; sim.run(1))
        csv.row(en, step, double(sim.time()), double(sim.particles()[0].x.z));
    }
  }
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  tracks(run);
  Work work(run.out);
  double worst = 0, slower = 0;
  for (const double en : {1.0, 0.9, 0.7, 0.5}) {
    const std::vector<Bounce> exact = reference(en);
    if (en < 1) slower = std::max(slower, 1 - exact.back().v_out / exact.back().v_in / en);
    long count = 0;
    worst = std::max(worst, apex_error(en, {"consistent", 1.0 / 64}, exact, count));
  }
  metrics("apex", worst);
  metrics("slower_than_en", slower);
  const std::vector<Bounce> exact = reference(0.7);
  std::vector<double> steps, errors;
  double apart = 0;
  for (const std::string name : {"consistent", "paper", "velocity Verlet", "RK4"})
    for (double step = 2; step > (run.quick ? 1.0 / 80 : 1.0 / 400); step /= 2) {
      const Timer timer;
      long count = 0;
      const double error = apex_error(0.7, {name, step}, exact, count);
      work(name, step, double(count), timer.seconds(), error);
      if (name == "consistent") steps.push_back(step), errors.push_back(error);
      const size_t row = size_t(std::lround(std::log2(2 / step)));
      if (name == "paper") apart = std::max(apart, std::abs(error - errors[row]));
    }
  metrics("schemes_apart", apart);
  metrics("error_at_eq50", errors[1]);
  const auto cut = [](const std::vector<double>& a) {  // from a quarter of Eq. (50) to 1/64
    return std::vector<double>(a.begin() + 3, a.begin() + 8);
  };
  metrics("order_defect", std::abs(order(cut(steps), cut(errors)) - 1));
}
