// Exercise 06: the function to write, and what it is given.
#pragma once
#include "vec.hpp"

/// A contact in one time step, as the sliding spring sees it.
struct Contact {
  Vec3 n;         // unit normal, from j to i
  Vec3 vs;        // sliding velocity of i over j, perpendicular to n [L/T]
  double fn;      // normal force along n [ML/T^2]; negative at the end of a contact: it attracts
  double ks, cs;  // stiffness [M/T^2] and damping [M/T] of the spring
};

/// The friction force on i in one time step dt [T]. us: the spring [L], as the last step left it,
/// zero in a new contact; leave it as the next step needs it. Eqs. (6), (11), (52)-(55).
Vec3 sliding_force(Vec3& us, const Contact& contact, double mus, double dt);
