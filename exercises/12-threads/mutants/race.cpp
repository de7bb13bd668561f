// loses: one_writer same_bits
// Pairs are shared out, and nothing protects the sums.
#include "exercise.hpp"

void sum_forces(const Packing& packing, int threads, Forces& forces) {
  const int count = static_cast<int>(packing.pairs.size());
  team(threads, [&](int t) {
    for (int k = t; k < count; k += threads) {
      const Pair pair = packing.pairs[k];
      const Vec3 f = pair_force(packing, pair);
      forces.add(pair.i, f);
      forces.add(pair.j, -f);
    }
  });
}
