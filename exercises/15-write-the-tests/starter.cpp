// Exercise 15: write the tests. README.md says which solvers they have to tell from the right one.
#include "exercise.hpp"

TEST(spheres_that_are_apart) {  // an example: it is right, and finds nothing
  Simulation s(scene("en = 0.5"), {}, {ball({0, 0, 0}, 0.01), ball({0.1, 0, 0}, 0.01)});
  s.run(10);
  expect("the second sphere stays where it is", s.particles()[1].x.x, 0.1, 1e-15);
}

// TODO: more tests
