// loses: everything
// A bracket is missing.
#include "exercise.hpp"

void sum_forces(const Packing& packing, int threads, Forces& forces) {
  const int count = static_cast<int>(packing.pairs.size()), n = forces.size();
  std::vector<Vec3> of_pair(packing.pairs.size());
  std::vector<std::vector<int>> mine(static_cast<std::size_t>(n));  // pairs of each sphere
  for (int k = 0; k < count; ++k) {
    mine[packing.pairs[k].i].push_back(k);
    mine[packing.pairs[k].j].push_back(k);
  }
  team(threads, [&](int t) {
    for (int k = t; k < count; k += threads) of_pair[k] = pair_force(packing, packing.pairs[k]);
  });
  team(threads, [&](int t) {
    for (int i = t; i < n; i += threads)
      for (const int k : mine[i])
        forces.add(i, packing.pairs[k].i == i ? of_pair[k] : -of_pair[k]);
  };
}
