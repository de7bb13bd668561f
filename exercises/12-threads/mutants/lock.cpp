// loses: one_writer same_bits
// A lock protects the sums, but not their order.
#include "exercise.hpp"

#include <mutex>
static std::mutex door;

void sum_forces(const Packing& packing, int threads, Forces& forces) {
  const int count = static_cast<int>(packing.pairs.size());
  team(threads, [&](int t) {
    for (int k = t; k < count; k += threads) {
      const Pair pair = packing.pairs[k];
      const Vec3 f = pair_force(packing, pair);
      const std::lock_guard<std::mutex> lock(door);
      forces.add(pair.i, f);
      forces.add(pair.j, -f);
    }
  });
}
