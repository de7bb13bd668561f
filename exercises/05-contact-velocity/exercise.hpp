// Exercise 05: the function to write, and what it is given.
#pragma once
#include "vec.hpp"

/// A sphere that moves. A wall is one, too: at the closest point of the wall, with w = 0.
struct Sphere {
  Vec3 x;    // position of the centre [L]
  double R;  // radius [L]
  Vec3 v, w;  // velocity [L/T], angular velocity [1/T]
};
/// How two spheres that touch move at the contact point.
struct Meeting {
  double ri, rj;  // distances of the contact point from the centres of i and j [L]
  double vn;      // relative velocity along n, negative while they approach [L/T]
  Vec3 vs;        // sliding velocity, perpendicular to n [L/T]
};

/// The motion of i relative to j at the contact point, Eqs. (7)-(9), (26)-(30).
Meeting contact_velocity(const Sphere& i, const Sphere& j);
