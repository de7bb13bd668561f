// Exercise 11: the functions to write, and what they are given.
#pragma once
#include <cstddef>
#include <vector>

#include "vec.hpp"

/// A cube of space: numbers of the cell along x, y and z, of any sign.
struct Cell {
  int i, j, k;
};
/// Two spheres that touch, i < j.
struct Pair {
  int i, j;
};

/// The spheres 0 ... count() - 1. What you ask is counted.
class Spheres {
 public:
  int count() const { return static_cast<int>(R_.size()); }
  /// Radius and centre of sphere i [L]. Looking at them counts as one look each.
  double R(int i) const { return ++looks_, R_.at(static_cast<std::size_t>(i)); }
  Vec3 x(int i) const { return ++looks_, x_.at(static_cast<std::size_t>(i)); }
  /// Do spheres i and j touch, Eq. (7)? Asking counts as one test.
  bool touch(int i, int j) const {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const double reach = R_.at(a) + R_.at(b);
    return ++tests_, square(x_.at(a) - x_.at(b)) < reach * reach;
  }

  void add(const Vec3& x, double R) { x_.push_back(x), R_.push_back(R); }
  double looks() const { return looks_; }
  double tests() const { return tests_; }

 private:
  std::vector<Vec3> x_;
  std::vector<double> R_;
  mutable double looks_ = 0, tests_ = 0;
};

/// The cell that holds the point x, among cells with edges of length `size` [L]. Cell (0, 0, 0) has
/// its lower corner at the origin, and a point on the lower face of a cell belongs to it.
Cell cell_of(const Vec3& x, double size);

/// All pairs of spheres that touch, each once, in any order. touch() decides; the number of tests
/// and looks must not grow faster than the number of spheres.
std::vector<Pair> touching_pairs(const Spheres& s);
