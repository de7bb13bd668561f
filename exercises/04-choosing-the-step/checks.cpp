// Exercise 04: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("default_step", default_step),
                              check::function("contact_time", contact_time),
                              check::function("restitution", restitution),
                              check::function("fewest_steps", fewest_steps)});
}
