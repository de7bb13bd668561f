// loses: cost
// All distances are calculated from copies; touch() is asked where they are small.
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
  std::vector<Vec3> x;
  std::vector<double> R;
  for (int i = 0; i < s.count(); ++i) x.push_back(s.x(i)), R.push_back(s.R(i));
  std::vector<Pair> found;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j)
      if (norm(x[i] - x[j]) < R[i] + R[j] && s.touch(int(i), int(j)))
        found.push_back({int(i), int(j)});
  return found;
}
