// Exercise 01: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("hertz_force", hertz_force)});
}
