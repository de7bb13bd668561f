// loses: limits
// Eq. (21) multiplied out: inf / inf for e_n = 0.
#include "exercise.hpp"

double damping_factor(double en) {
  const double loss = -std::log(en);
  return loss / std::sqrt(pi * pi + loss * loss);                                      // Eq. (21)
}

double damping(double kn, double mi, double mj, double en) {
  const double mstar = 1 / (1 / mi + 1 / mj);                                   // Eq. (20)
  return std::sqrt(5 * mstar * kn) * damping_factor(en);                        // Eq. (18)
}

double normal_force(double delta, double vn, double kn, double cn) {
  if (delta <= 0) return 0;
  return kn * delta - cn * vn;                                                  // Eqs. (5, 10)
}
