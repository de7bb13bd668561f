// Exercise 04, written differently: speed of sound, energy, and all phases side by side.
#include <array>

#include "exercise.hpp"

namespace {
constexpr int phases = 16;

/// An impact in the unit of the model: gap (negative overlap) and its rate.
struct Impact {
  double gap, rate;
  /// One step h; false when it has ended.
  bool advance(double h, double damping) {
    const double root = std::sqrt(-gap);
    rate += h * (-gap * root - damping * std::sqrt(root) * rate);
    gap += h * rate;
    return gap < 0;
  }
};

/// sqrt(5) beta; 0 for en = 1.
double damping_of(double en) {
  const double loss = -std::log(en);
  return std::sqrt(5.0) * loss / std::hypot(pi, loss);
}
double step_of(double steps) { return hertz_time * std::pow(5.0 / 4, 2.0 / 5) / steps; }
}  // namespace

double default_step(const Material& material, const Sizes& sizes) {
  const double modulus = material.E / ((1 - material.nu) * (1 + material.nu));
  const double speed_of_sound = std::sqrt(modulus / material.rho);
  return sizes.Rmin / speed_of_sound;
}

double contact_time(const Material& material, double R, double v) {
  const double mass = material.rho * 4 * pi * R * R * R / 3;
  const double modulus = material.E / (1 - material.nu * material.nu) / 2;
  const double kinetic = mass / 2 * v * v / 2;
  const double elastic_per_overlap = 8 * modulus * std::sqrt(R / 2) / 15;
  return hertz_time / v * std::pow(kinetic / elastic_per_overlap, 1 / 2.5);
}

double restitution(double en, double steps, double phase) {
  const double h = step_of(steps), damping = damping_of(en);
  Impact one{-phase * h, -1};
  while (one.advance(h, damping)) {}
  return one.rate;
}

double fewest_steps(double en, double error) {
  double steps = 3, mean_square = 0;
  do {
    ++steps, mean_square = 0;
    std::array<double, phases> e{};
    for (int k = 0; k < phases; ++k) e[std::size_t(k)] = restitution(en, steps, (k + 1.0) / phases);
    for (const double x : e) mean_square += (x - en) * (x - en) / phases;
  } while (mean_square > error * error);
  return steps;
}
