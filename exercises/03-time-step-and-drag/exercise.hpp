// Exercise 03: the function to write, and what it is given.
#pragma once
#include "vec.hpp"

/// How a sphere moves.
struct Motion {
  Vec3 x, v, w;  // position [L], velocity [L/T], angular velocity [1/T]
};
/// The sphere itself, of one material throughout.
struct Grain {
  double R, rho;  // radius [L], mass density [M/L^3]
};
/// Where it moves.
struct Surroundings {
  double eta;  // dynamic viscosity of the fluid [M/LT]; 0: no fluid
  Vec3 g;      // gravitational acceleration [L/T^2]
};

/// The motion of a sphere one time step dt [T] later. f, t: force [ML/T^2] and torque [ML^2/T^2]
/// from its contacts. Semi-implicit Euler with Stokes drag, Eqs. (3), (4), (42)-(46).
Motion step(const Motion& old, const Vec3& f, const Vec3& t, const Grain& grain,
            const Surroundings& around, double dt);
