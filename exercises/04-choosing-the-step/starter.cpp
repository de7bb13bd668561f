// Exercise 04: choosing the time step. Write the four functions; README.md says what they do.
#include "exercise.hpp"

double default_step(const Material& material, const Sizes& sizes) {
  (void)material, (void)sizes;  // not used yet: remove this line
  return 0;                     // TODO: Eq. (50)
}

double contact_time(const Material& material, double R, double v) {
  (void)material, (void)R, (void)v;
  return 0;  // TODO: E*, R*, m* of two equal spheres; the deepest overlap; hertz_time
}

double restitution(double en, double steps, double phase) {
  (void)en, (void)steps, (void)phase;
  return 0;  // TODO: the model impact, step by step, until the overlap is gone
}

double fewest_steps(double en, double error) {
  (void)en, (void)error;
  return 0;  // TODO: try 4, 5, 6, ... steps
}
