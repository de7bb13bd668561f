// Exercise 02: damping and restitution. Write the three functions; README.md says what they do.
#include "exercise.hpp"

double damping_factor(double en) {
  (void)en;  // not used yet: remove this line
  return 0;  // TODO: Eq. (21); what are the limits for en = 0 and en = 1?
}

double damping(double kn, double mi, double mj, double en) {
  (void)kn, (void)mi, (void)mj, (void)en;
  return 0;  // TODO: the effective mass mstar, Eq. (20), then Eq. (18)
}

double normal_force(double delta, double vn, double kn, double cn) {
  (void)delta, (void)vn, (void)kn, (void)cn;
  return 0;  // TODO: Eqs. (5), (10) along n; nothing when the spheres are apart
}
