// Exercise 09: orientations. Write the functions; README.md says what they have to do.
#include "exercise.hpp"

Quaternion product(const Quaternion& p, const Quaternion& q) {
  // TODO: the scalar part and the vectorial part, Eq. (49)
  (void)q;  // not used yet: remove this line
  return p;
}

Vec3 rotated(const Quaternion& q, const Vec3& a) {
  // TODO: q (0, a) q*, with the conjugate q* = (s, -v)
  (void)q;  // not used yet: remove this line
  return a;
}

Quaternion turned(const Quaternion& q, const Vec3& w, const Vec3& alpha, double dt) {
  // TODO: the two rotations of Eq. (47) with the angles of Eq. (48); mind bodies that do not turn
  // TODO: their product with q; mind the sides
  (void)w, (void)alpha, (void)dt;  // not used yet: remove this line
  return q;
}
