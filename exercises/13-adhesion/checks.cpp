// Exercise 13: the answer is a copy of the solver; include/simulate.cpp runs it.
#include "check.hpp"

std::vector<double> simulate(const std::vector<double>& numbers);

int main(int, char** files) {
  return check::serve(files, {check::function("simulate", simulate)});
}
