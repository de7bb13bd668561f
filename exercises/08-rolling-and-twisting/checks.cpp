// Exercise 08: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("relative_spin", relative_spin),
                              check::function("resisting_torque", resisting_torque)});
}
