// loses: cost
// All pairs are tested.
// around, so that it meets those before it only: every pair once, the smaller number first.
#include "exercise.hpp"

#include <algorithm>
#include <array>
#include <map>

Cell cell_of(const Vec3& x, double size) {
  const auto whole = [size](double a) { return static_cast<int>(std::floor(a / size)); };
  return {whole(x.x), whole(x.y), whole(x.z)};
}

std::vector<Pair> touching_pairs(const Spheres& s) {
  std::vector<Pair> found;
  for (int i = 0; i < s.count(); ++i)
    for (int j = i + 1; j < s.count(); ++j)
      if (s.touch(i, j)) found.push_back({i, j});
  return found;
}
