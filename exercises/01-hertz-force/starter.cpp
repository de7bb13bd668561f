// Exercise 01: the Hertz force. Write the function; README.md says what it has to do.
#include "exercise.hpp"

Vec3 hertz_force(const Sphere& i, const Sphere& j) {
  // TODO: the overlap delta, Eqs. (7), (8)
  // TODO: the direction n, Eq. (9)
  // TODO: the effective modulus Estar, Eq. (15), and the effective radius Rstar, Eq. (17)
  // TODO: the contact radius a, Eq. (14), the stiffness kn, Eq. (12), the force, Eqs. (5), (10)
  (void)i, (void)j;  // these two are not used yet: remove this line
  return {0, 0, 0};
}
