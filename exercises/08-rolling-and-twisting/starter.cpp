// Exercise 08: rolling and twisting friction. Write both functions; README.md says what they do.
#include "exercise.hpp"

Spin relative_spin(const Contact& c, const Vec3& wi, const Vec3& wj) {
  // TODO: the relative angular velocity, Eq. (38), and its two parts, Eqs. (36) and (37)
  (void)c, (void)wi, (void)wj;  // not used yet: remove this line
  return {};
}

Vec3 resisting_torque(Springs& u, const Contact& c, const Spin& v, const Coefficients& mu,
                      double dt) {
  // TODO: rolling: turn, advance, trial force, limit, as in exercise 06, with kn, cn and mu_r
  // TODO: twisting: the same with numbers in place of vectors, ks, cs and mu_t; nothing to turn
  // TODO: the torques, Eqs. (32) and (33)
  (void)u, (void)c, (void)v, (void)mu, (void)dt;  // not used yet: remove this line
  return {0, 0, 0};
}
