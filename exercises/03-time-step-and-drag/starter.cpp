// Exercise 03: one time step. Write the function; README.md says what it has to do.
#include "exercise.hpp"

Motion step(const Motion& old, const Vec3& f, const Vec3& t, const Grain& grain,
            const Surroundings& around, double dt) {
  // TODO: the mass m and the moment of inertia I of a solid sphere, below Eq. (2)
  // TODO: the drag rates c and gamma, Eqs. (3), (4)
  // TODO: the accelerations a and alpha, Eqs. (42), (43)
  // TODO: the new velocity, position and angular velocity, Eqs. (44)-(46); mind the order
  (void)f, (void)t, (void)grain, (void)around, (void)dt;  // not used yet: remove this line
  return old;
}
