// Exercise 02: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("damping_factor", damping_factor),
                              check::function("damping", damping),
                              check::function("normal_force", normal_force)});
}
