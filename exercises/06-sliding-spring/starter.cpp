// Exercise 06: the sliding spring. Write the function; README.md says what it has to do.
#include "exercise.hpp"

Vec3 sliding_force(Vec3& us, const Contact& contact, double mus, double dt) {
  // TODO: turn us into the plane perpendicular to n, at its old length, Eq. (52)
  // TODO: advance us, Eq. (53); then the trial force, Eq. (6)
  // TODO: if the trial force is above the limit of Eq. (11): shorten it, Eq. (54), and give us the
  //       length that belongs to it, Eq. (55)
  (void)us, (void)contact, (void)mus, (void)dt;  // not used yet: remove this line
  return {0, 0, 0};
}
