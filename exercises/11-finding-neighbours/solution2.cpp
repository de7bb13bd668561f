// Exercise 11, written differently: the spheres are sorted by cell; of the 26 cells around one, the
// 13 that come later are searched. Memory: a few numbers per sphere, wherever they are.
#include "exercise.hpp"

#include <algorithm>
#include <tuple>

namespace {
struct Entry {
  Cell cell;
  int sphere;
};
std::tuple<int, int, int> key(const Cell& c) { return {c.k, c.j, c.i}; }
bool before(const Entry& a, const Entry& b) {
  return key(a.cell) != key(b.cell) ? key(a.cell) < key(b.cell) : a.sphere < b.sphere;
}
int lower(double a, double size) {
  const double share = a / size;
  const int cut = static_cast<int>(share);  // towards zero
  return share < cut ? cut - 1 : cut;
}
void test(const Spheres& s, int a, int b, std::vector<Pair>& found) {
  if (s.touch(a, b)) found.push_back({std::min(a, b), std::max(a, b)});
}
}  // namespace

Cell cell_of(const Vec3& x, double size) {
  return {lower(x.x, size), lower(x.y, size), lower(x.z, size)};
}

std::vector<Pair> touching_pairs(const Spheres& s) {
  std::vector<double> radii;
  for (int i = 0; i < s.count(); ++i) radii.push_back(s.R(i));
  if (radii.empty()) return {};
  const double edge = 2 * *std::max_element(radii.begin(), radii.end());
  std::vector<Entry> sorted;
  for (int i = 0; i < s.count(); ++i) sorted.push_back({cell_of(s.x(i), edge), i});
  std::sort(sorted.begin(), sorted.end(), before);

  std::vector<Pair> found;
  for (auto a = sorted.begin(); a != sorted.end(); ++a) {
    for (auto b = a + 1; b != sorted.end() && key(b->cell) == key(a->cell); ++b)
      test(s, a->sphere, b->sphere, found);
    for (int n = 14; n < 27; ++n) {  // 13 is the cell itself
      const Cell c{a->cell.i + n % 3 - 1, a->cell.j + n / 3 % 3 - 1, a->cell.k + n / 9 - 1};
      for (auto b = std::lower_bound(a, sorted.end(), Entry{c, 0}, before);
           b != sorted.end() && key(b->cell) == key(c); ++b)
        test(s, a->sphere, b->sphere, found);
    }
  }
  return found;
}
