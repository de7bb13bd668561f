// loses: escaped pairs sizes shift turn renumber cost
// 26 of 27 cells: one across an edge is missing.
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
  double size = 0;
  for (int i = 0; i < s.count(); ++i) size = std::max(size, 2 * s.R(i));
  std::map<std::array<int, 3>, std::vector<int>> cells;
  std::vector<Pair> found;
  for (int i = 0; i < s.count(); ++i) {
    const Cell c = cell_of(s.x(i), size);
    for (int x = c.i - 1; x <= c.i + 1; ++x)
      for (int y = c.j - 1; y <= c.j + 1; ++y)
        for (int z = c.k - 1; z <= c.k + 1; ++z) {
          const auto here = cells.find({{x, y, z}});
          if (here == cells.end() || (x > c.i && y > c.j && z == c.k)) continue;
          for (const int j : here->second)
            if (s.touch(j, i)) found.push_back({j, i});
        }
    cells[{{c.i, c.j, c.k}}].push_back(i);
  }
  return found;
}
