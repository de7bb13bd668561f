// Exercise 09: the functions to write, and what they are given.
#pragma once
#include "vec.hpp"

/// A quaternion (s, v): scalar part and vectorial part. As an orientation it has the norm 1, and
/// turns vectors from the frame of the body into that of the laboratory.
struct Quaternion {
  double s;
  Vec3 v;
};

/// The Hamilton product p q, Eq. (49).
Quaternion product(const Quaternion& p, const Quaternion& q);

/// The vector a, fixed in a body of orientation q, as it is seen from the laboratory.
Vec3 rotated(const Quaternion& q, const Vec3& a);

/// The orientation one time step dt [T] later. w, alpha: angular velocity [1/T] at the beginning of
/// the step and angular acceleration [1/T^2], both in the frame of the laboratory. Eqs. (47), (48),
/// with the factors on the side that this frame needs.
Quaternion turned(const Quaternion& q, const Vec3& w, const Vec3& alpha, double dt);
