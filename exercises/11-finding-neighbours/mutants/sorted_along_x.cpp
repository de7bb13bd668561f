// loses: cost
// Sorted along one axis: a slice of the crowd for every sphere.
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
  std::vector<std::array<double, 3>> line;  // x, R, number
  double reach = 0;
  for (int i = 0; i < s.count(); ++i) {
    line.push_back({{s.x(i).x, s.R(i), double(i)}});
    reach = std::max(reach, 2 * line.back()[1]);
  }
  std::sort(line.begin(), line.end());
  std::vector<Pair> found;
  for (auto a = line.begin(); a != line.end(); ++a)
    for (auto b = a + 1; b != line.end() && (*b)[0] - (*a)[0] < reach; ++b) {
      const int i = int(std::min((*a)[2], (*b)[2])), j = int(std::max((*a)[2], (*b)[2]));
      if (s.touch(i, j)) found.push_back({i, j});
    }
  return found;
}
