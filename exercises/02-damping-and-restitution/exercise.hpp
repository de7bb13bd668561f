// Exercise 02: the functions to write.
#pragma once
#include <cmath>

#include "vec.hpp"  // pi

/// The damping factor beta for a coefficient of restitution en in [0, 1]. Eq. (21). No dimension.
double damping_factor(double en);

/// The damping coefficient cn [M/T] for a stiffness kn [M/T^2], the masses mi, mj of the two
/// spheres [M], and the coefficient of restitution en. Eqs. (18), (20), (21).
double damping(double kn, double mi, double mj, double en);

/// The normal force on i along n [ML/T^2], where n points from j to i, for an overlap delta [L] and
/// a relative velocity vn = v . n [L/T]: positive vn means that the spheres part. Eqs. (5), (10).
/// Zero unless delta > 0.
double normal_force(double delta, double vn, double kn, double cn);
