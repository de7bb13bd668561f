// loses: limits rebound order cheapest no_memory
// The impact ends at its deepest overlap.
#include "exercise.hpp"

double default_step(const Material& material, const Sizes& sizes) {
  const double slowness2 = material.rho * (1 - material.nu * material.nu) / material.E;
  return sizes.Rmin * std::sqrt(slowness2);                                     // Eq. (50)
}

double contact_time(const Material& material, double R, double v) {
  const double Estar = material.E / (2 * (1 - material.nu * material.nu));      // Eq. (22)
  const double Rstar = R / 2;                                                   // Eq. (17)
  const double mstar = 2.0 / 3.0 * pi * material.rho * R * R * R;               // Eq. (24)
  const double deepest = std::pow(15 * mstar * v * v / (16 * Estar * std::sqrt(Rstar)), 0.4);
  return hertz_time * deepest / v;
}

double restitution(double en, double steps, double phase) {
  const double ratio = pi / std::log(en);
  const double beta = 1 / std::sqrt(1 + ratio * ratio);                         // Eq. (21)
  const double dt = hertz_time * std::pow(1.25, 0.4) / steps;
  double v = -1, delta = phase * dt;
  while (v < 0) {
    const double kn = std::sqrt(delta), cn = std::sqrt(5 * kn) * beta;          // Eq. (18)
    v += dt * (kn * delta - cn * v);                                            // Eq. (44)
    delta -= dt * v;                                                            // Eq. (45)
  }
  return v;
}

double fewest_steps(double en, double error) {
  for (int steps = 4;; ++steps) {
    double sum = 0;
    for (int k = 1; k <= 16; ++k) {
      const double off = restitution(en, steps, k / 16.0) - en;
      sum += off * off;
    }
    if (std::sqrt(sum / 16) <= error) return steps;
  }
}
