// Case 9: an impact that slides from beginning to end. Friction is mu |f_n| all the time, so its
// impulse follows from the normal motion alone.
//
// Normal motion: with y = delta^(5/4) and d(tau) = delta^(1/4) dt the contact is a linear
// oscillator of damping ratio beta. The force vanishes at the velocity e_c v_n and pulls until e_n
// v_n:
//   e_c = exp(-2 beta acos(beta)/sqrt(1 - beta^2)),     e_n = exp(-pi beta/sqrt(1 - beta^2)).
// The impulse of |f_n| is m v_n (1 + e_c) while it pushes and m v_n (e_c - e_n) while it pulls, so
//   |dv_x| = mu v_n (1 + 2 e_c - e_n).
#include "impacts.hpp"

using namespace verification;

const double R = 0.01, speed = 1;  // m, m/s
const int phases = 8;

double change_of_vx(double mu, double vn, double e_n) {
  const double log_e = std::log(e_n), beta = -log_e / std::sqrt(log_e * log_e + pi * pi);
  const double e_c = std::exp(-2 * beta * std::acos(beta) / std::sqrt(1 - beta * beta));
  return -mu * vn * (1 + 2 * e_c - e_n);
}
struct Slide {
  double angle, mu, e_n;
  reference::Ball in() const { return thrown(R, speed, angle); }
  double expected() const { return change_of_vx(mu, -in().v.z, e_n); }
  Parameters parameters(const std::string& scheme, double divisor) const {
    Parameters p = scene("mur = 0; mut = 0; Rmin = 0.01; scheme = " + scheme + setting("mus", mu) +
                         setting("en", e_n));
    p.dt /= real(divisor);
    return p;
  }
  double duration() const { return reference_on_plate(parameters("consistent", 1), in()).duration; }
};
/// Mean and range over phases of the impulse of friction over its closed form; worst energy ratio.
struct Result {
  double mean = 0, low = 1e9, high = -1e9, rms = 0, energy = 0;
};
template <class F> Result measure(const Slide& s, const F& run) {
  Result r;
  const double duration = s.duration();
  for (int k = 1; k <= phases; ++k) {
    const reference::Ball out = run(duration, double(k) / phases).sphere;
    const double ratio = (out.v.x - s.in().v.x) / s.expected();
    r.mean += ratio / phases, r.low = std::min(r.low, ratio), r.high = std::max(r.high, ratio);
    r.rms += (ratio - 1) * (ratio - 1) / phases;
    r.energy = std::max(r.energy, energy(out) / energy(s.in()));
  }
  r.rms = std::sqrt(r.rms);
  return r;
}
Result solve(const Slide& s, const std::string& scheme, double divisor) {
  const Parameters p = s.parameters(scheme, divisor);
  return measure(s, [&](double d, double phase) { return solver_on_plate(p, s.in(), d, phase); });
}
Result solve(const Slide& s, Method method, double divisor) {
  const Parameters p = s.parameters("consistent", divisor);
  return measure(
      s, [&](double d, double phase) { return other_on_plate(p, s.in(), d, phase, method); });
}

/// Impulse over e_n at two steps: the closed form as a curve, the solver as points.
double write_impulses(const Arguments& arguments) {
  Csv csv(arguments.out / "impulse.csv", "e_n,method,divisor,dv_x_over_mu_v_n,closed_form");
  double worst = 0;
  for (const double e_n : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
    for (const char* scheme : schemes)
      for (const double divisor : {1.0, 100.0}) {
        const Slide s{80, 0.2, e_n};
        const Result r = solve(s, scheme, divisor);
        const double closed = -s.expected() / (s.mu * -s.in().v.z);
        csv.row(e_n, scheme, divisor, r.mean * closed, closed);
        if (divisor > 1 && scheme == schemes[0]) worst = std::max(worst, r.rms);
      }
  return worst;
}
void write_steps(const Arguments& arguments) {
  Csv csv(arguments.out / "steps.csv", "angle_deg,mu,method,divisor,mean,low,high,energy_ratio");
  Work work(arguments.out);
  for (const Slide& s : {Slide{70, 0.1, 0.5}, Slide{85, 0.5, 0.5}})
    for (double divisor = 1; divisor <= 256; divisor *= 2) {
      const double steps = s.duration() / double(s.parameters("consistent", divisor).dt);
      for (const char* scheme : schemes) {
        const Timer timer;
        const Result r = solve(s, scheme, divisor);
        csv.row(s.angle, s.mu, scheme, divisor, r.mean, r.low, r.high, r.energy);
        if (s.angle < 80) work(scheme, 1 / divisor, steps, timer.seconds() / phases, r.rms);
      }
      if (s.angle > 80) continue;
      for (const Method m : {Method::velocity_verlet, Method::rk4}) {
        const Timer timer;
        const Result r = solve(s, m, divisor);
        work(name(m), 1 / divisor, steps * (m == Method::rk4 ? 4 : 1), timer.seconds() / phases,
             r.rms);
      }
    }
}

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  Metrics metrics(arguments.out);
  metrics("impulse_dt0_100", write_impulses(arguments));
  const Slide slow{70, 0.1, 0.5}, grazing{85, 0.5, 0.5};
  metrics("impulse_dt0", solve(slow, "consistent", 1).rms);
  std::vector<double> steps, errors;
  for (const double d : {4.0, 16.0, 64.0})
    steps.push_back(1 / d), errors.push_back(solve(slow, "consistent", d).rms);
  metrics("order", order(steps, errors));
  metrics("paper_dt0", 1 - solve(slow, "paper", 1).mean);
  metrics("paper_dt0_10", 1 - solve(slow, "paper", 10).mean);
  metrics("paper_dt0_100", 1 - solve(slow, "paper", 100).mean);
  metrics("paper_energy_85deg_dt0", solve(grazing, "paper", 1).energy);
  metrics("paper_energy_85deg_dt0_100", solve(grazing, "paper", 100).energy);
  metrics("consistent_energy_85deg", solve(grazing, "consistent", 1).energy);
  if (!arguments.quick) write_steps(arguments);
}
