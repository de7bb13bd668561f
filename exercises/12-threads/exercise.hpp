// Exercise 12: the function to write, and what it uses.
#pragma once
#include <functional>
#include <vector>

#include "vec.hpp"

/// Two spheres that may touch; i < j.
struct Pair {
  int i, j;
};

/// Spheres of one radius [L]: their centres [L], and every pair once, sorted by i, then by j.
struct Packing {
  std::vector<Vec3> x;
  double R, Estar;  // Estar: Eq. (15) [M/LT^2]
  std::vector<Pair> pairs;
};

/// The force on i in a pair [ML/T^2], Eqs. (5, 12); on j acts the opposite. Zero when they are apart.
Vec3 pair_force(const Packing& packing, const Pair& pair);

/// The sum for each sphere, zero at first. Two threads must not add to the same sphere.
class Forces {
 public:
  explicit Forces(int spheres);
  int size() const { return static_cast<int>(sums.size()); }
  void add(int sphere, const Vec3& force);

 private:
  friend struct Examiner;
  std::vector<Vec3> sums;
  std::vector<long> writer;  // who has added last, and in which call of team()
};

/// Runs work(0), work(1) ... work(threads - 1), each in a thread, and returns when all have ended.
/// They may run in any order and at the same time, so none of them may wait for another.
void team(int threads, const std::function<void(int)>& work);

/// Adds the forces of all pairs to both spheres, by a team of so many threads (1 or more). The sums
/// are the same bits for every number of threads.
void sum_forces(const Packing& packing, int threads, Forces& forces);
