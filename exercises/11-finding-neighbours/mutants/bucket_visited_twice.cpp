// loses: few escaped pairs sizes shift turn renumber cost
// A table of buckets; two of the 27 cells may share one, which is searched twice.
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
  const int buckets = s.count() + 1;
  std::vector<std::vector<int>> table(static_cast<std::size_t>(buckets));
  const auto bucket = [buckets](int x, int y, int z) {
    const unsigned h = 73856093u * unsigned(x) ^ 19349663u * unsigned(y) ^ 83492791u * unsigned(z);
    return h % unsigned(buckets);
  };
  std::vector<Pair> found;
  for (int i = 0; i < s.count(); ++i) {
    const Cell c = cell_of(s.x(i), size);
    for (int x = c.i - 1; x <= c.i + 1; ++x)
      for (int y = c.j - 1; y <= c.j + 1; ++y)
        for (int z = c.k - 1; z <= c.k + 1; ++z)
          for (const int j : table[bucket(x, y, z)])
            if (s.touch(j, i)) found.push_back({j, i});
    table[bucket(c.i, c.j, c.k)].push_back(i);
  }
  return found;
}
