// loses: shared
// Every thread computes all forces, and keeps those of its spheres.
#include "exercise.hpp"

void sum_forces(const Packing& packing, int threads, Forces& forces) {
  team(threads, [&](int t) {
    for (const Pair& pair : packing.pairs) {
      const Vec3 f = pair_force(packing, pair);
      if (pair.i % threads == t) forces.add(pair.i, f);
      if (pair.j % threads == t) forces.add(pair.j, -f);
    }
  });
}
