// loses: shared same_bits
// A copy of all sums per thread, added up in the end: rounded differently by other teams, and the
// more threads there are, the more copies have to be added.
#include "exercise.hpp"

void sum_forces(const Packing& packing, int threads, Forces& forces) {
  const int count = static_cast<int>(packing.pairs.size()), n = forces.size();
  std::vector<std::vector<Vec3>> mine(threads, std::vector<Vec3>(n));
  team(threads, [&](int t) {
    for (int k = t; k < count; k += threads) {
      const Pair pair = packing.pairs[k];
      const Vec3 f = pair_force(packing, pair);
      mine[t][pair.i] = mine[t][pair.i] + f;
      mine[t][pair.j] = mine[t][pair.j] - f;
    }
  });
  team(threads, [&](int t) {
    for (int i = t; i < n; i += threads)
      for (int other = 0; other < threads; ++other) forces.add(i, mine[other][i]);
  });
}
