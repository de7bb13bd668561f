// Exercise 09: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

int main(int, char** files) {
  return check::serve(files, {check::function("product", product),
                              check::function("rotated", rotated),
                              check::function("turned", turned)});
}
