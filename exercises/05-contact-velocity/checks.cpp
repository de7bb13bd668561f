// Exercise 05: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("contact_velocity", contact_velocity)});
}
