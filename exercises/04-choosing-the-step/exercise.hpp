// Exercise 04: the functions to write, and what they are given.
#pragma once
#include "vec.hpp"

struct Material {
  double E, nu, rho;  // Young's modulus [M/LT^2], Poisson's ratio, mass density [M/L^3]
};
struct Sizes {
  double Rmin, Rmax;  // smallest and largest radius [L]
};
/// An elastic Hertz contact lasts this many times (deepest overlap / speed): 4/5 sqrt(pi)
/// Gamma(2/5) / Gamma(9/10).
const double hertz_time = 2.9432751843247047;

/// The default time step of the solver [T], Eq. (50).
double default_step(const Material& material, const Sizes& sizes);
/// How long two equal spheres of radius R [L] touch that meet head-on with the relative speed v
/// [L/T], without damping [T].
double contact_time(const Material& material, double R, double v);
/// Rebound speed / impact speed of the model impact in README.md, with the restitution en, in
/// `steps` time steps per elastic contact time. phase: part of a step between first touch and its
/// end.
double restitution(double en, double steps, double phase);
/// The smallest whole number of steps, 4 or more, whose error of the restitution is not above
/// `error`: the root of the mean square over the phases 1/16, 2/16, ... 1.
double fewest_steps(double en, double error);
