// Exercise 07: action and reaction. Write the functions; README.md says what they have to do.
#include "exercise.hpp"

Loads both_sides(const Contact& c, const Friction& f) {
  Loads r{};
  // TODO: the torques of sliding, rolling and twisting on i, Eqs. (31)-(33)
  // TODO: force and torque on i, Eqs. (1), (2)
  // TODO: force and torque on j, Eqs. (56)-(60)
  (void)c, (void)f;  // these two are not used yet: remove this line
  return r;
}

std::vector<Load> total(int bodies, const std::vector<Pair>& pairs) {
  std::vector<Load> sum(static_cast<std::size_t>(bodies));  // all zero
  // TODO: for each pair, add what it does to its bodies
  (void)pairs;  // not used yet: remove this line
  return sum;
}
