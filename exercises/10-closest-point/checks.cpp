// Exercise 10: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("closest_on_edge", closest_on_edge),
                              check::function("closest_on_triangle", closest_on_triangle),
                              check::function("closest_on_rectangle", closest_on_rectangle)});
}
