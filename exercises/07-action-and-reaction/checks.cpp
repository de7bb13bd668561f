// Exercise 07: what the grader may evaluate.
#include "check.hpp"
#include "exercise.hpp"

namespace {
/// total() for the grader: the number of bodies; per contact i, j and 12 numbers of loads.
std::vector<double> total_of_list(const std::vector<double>& in) {
  std::vector<Pair> pairs;
  for (std::size_t k = 1; k + 14 <= in.size(); k += 14) {
    const double* from = &in[k];
    const int i = check::take<int>(from), j = check::take<int>(from);
    pairs.push_back({i, j, check::take<Loads>(from)});
  }
  std::vector<double> out;
  for (const Load& load : total(static_cast<int>(in[0]), pairs)) check::give(load, out);
  return out;
}
}  // namespace

int main(int, char** files) {
  return check::serve(files, {check::function("both_sides", both_sides),
                              check::function("total", total_of_list)});
}
