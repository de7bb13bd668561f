// Exercise 01: the function to write, and what it is given.
#pragma once
#include "vec.hpp"

/// An elastic sphere.
struct Sphere {
  Vec3 x;          // centre [L]
  double R, E, nu;  // radius [L], Young's modulus [M/LT^2], Poisson's ratio
};

/// The elastic normal force of Hertz on sphere i from sphere j [ML/T^2]: a vector that points from
/// j to i, and zero unless the spheres overlap. Eqs. (5), (7)-(10), (12), (14), (15), (17).
Vec3 hertz_force(const Sphere& i, const Sphere& j);
