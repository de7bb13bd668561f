// loses: escaped
// An array of all cells between the outermost spheres.
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
  if (s.count() == 0) return {};
  double size = 0;
  for (int i = 0; i < s.count(); ++i) size = std::max(size, 2 * s.R(i));
  std::array<long, 3> low{{1 << 30, 1 << 30, 1 << 30}}, high{{-(1 << 30), -(1 << 30), -(1 << 30)}};
  std::vector<std::array<long, 3>> at;
  for (int i = 0; i < s.count(); ++i) {
    const Cell c = cell_of(s.x(i), size);
    at.push_back({{c.i, c.j, c.k}});
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at.back()[k] - 1);
      high[k] = std::max(high[k], at.back()[k] + 2);
    }
  }
  const auto place = [&](long x, long y, long z) {
    return static_cast<std::size_t>(((z - low[2]) * (high[1] - low[1]) + y - low[1]) *
                                        (high[0] - low[0]) + x - low[0]);
  };
  std::vector<std::vector<int>> cells(place(low[0], low[1], high[2]));
  std::vector<Pair> found;
  for (int i = 0; i < s.count(); ++i) {
    const auto c = at[static_cast<std::size_t>(i)];
    for (long x = c[0] - 1; x <= c[0] + 1; ++x)
      for (long y = c[1] - 1; y <= c[1] + 1; ++y)
        for (long z = c[2] - 1; z <= c[2] + 1; ++z)
          for (const int j : cells[place(x, y, z)])
            if (s.touch(j, i)) found.push_back({j, i});
    cells[place(c[0], c[1], c[2])].push_back(i);
  }
  return found;
}
