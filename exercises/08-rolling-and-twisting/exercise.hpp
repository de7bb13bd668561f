// Exercise 08: the functions to write, and what they are given.
#pragma once
#include "vec.hpp"

/// A contact in one time step. A wall has rj = infinity (HUGE_VAL).
struct Contact {
  Vec3 n;                // unit normal, from j to i
  double ri, rj;         // from the centre of i, of j to the contact point [L]
  double Rstar;          // effective radius [L]
  double fn;             // normal force along n [ML/T^2]; negative at the end of a contact
  double kn, cn;         // stiffness [M/T^2] and damping [M/T] of the normal force,
  double ks, cs;         // and of the sliding spring
};
/// How fast two bodies roll over each other and twist against each other [L/T].
struct Spin {
  Vec3 vr;    // rolling velocity, perpendicular to n
  double vt;  // twisting velocity, about n
};
/// What a contact remembers of rolling and twisting [L].
struct Springs {
  Vec3 ur;
  double ut;
};
/// Coefficients of friction for sliding and rolling; that for twisting follows from them, Eq. (41).
struct Coefficients {
  double mus, mur;
};

/// Rolling and twisting velocity of bodies with angular velocities wi, wj [1/T]. Eqs. (36)-(38).
Spin relative_spin(const Contact& c, const Vec3& wi, const Vec3& wj);

/// The torque of rolling and twisting friction together, on i [ML^2/T^2], in one time step dt [T].
/// u: the springs as the last step left them, zero in a new contact; leave them as the next step
/// needs them. Eqs. (32)-(35), (39)-(41), (52)-(55).
Vec3 resisting_torque(Springs& u, const Contact& c, const Spin& v, const Coefficients& mu,
                      double dt);
