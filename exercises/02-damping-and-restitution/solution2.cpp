// Exercise 02, written differently: the limits by hand, the reduced mass as a fraction.
#include "exercise.hpp"

double damping_factor(double en) {
  if (en <= 0) return 1;
  const double loss = -std::log(en);
  return loss / std::hypot(pi, loss);
}

double damping(double kn, double mi, double mj, double en) {
  const double critical = std::sqrt(kn * mi * mj / (mi + mj));
  return std::sqrt(5.0) * damping_factor(en) * critical;
}

double normal_force(double delta, double vn, double kn, double cn) {
  const double spring = kn * delta, dashpot = -cn * vn;
  return delta > 0 ? spring + dashpot : 0.0;
}
