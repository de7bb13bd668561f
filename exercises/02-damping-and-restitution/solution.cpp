// Exercise 02: damping and restitution, equation by equation.
#include "exercise.hpp"

double damping_factor(double en) {
  const double ratio = pi / std::log(en);  // -0 for en = 0, -inf for en = 1: both limits are right
  return 1 / std::sqrt(1 + ratio * ratio);                                      // Eq. (21)
}

double damping(double kn, double mi, double mj, double en) {
  const double mstar = 1 / (1 / mi + 1 / mj);                                   // Eq. (20)
  return std::sqrt(5 * mstar * kn) * damping_factor(en);                        // Eq. (18)
}

double normal_force(double delta, double vn, double kn, double cn) {
  if (delta <= 0) return 0;
  return kn * delta - cn * vn;                                                  // Eqs. (5, 10)
}
