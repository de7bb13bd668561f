// Exercise 12: threads without races. Write the function; README.md says what it has to do.
#include "exercise.hpp"

void sum_forces(const Packing& packing, int threads, Forces& forces) {
  // TODO: team(threads, ...) with a lambda that does the share of thread t
  // TODO: no two threads may add to the same sphere in one team(); a second team() may follow
  // TODO: the order in which a sphere gets its forces must not depend on `threads`
  (void)packing, (void)threads, (void)forces;  // not used yet: remove this line
}
