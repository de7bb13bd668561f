// The same bits for every number of threads.
#ifdef _OPENMP
#include <omp.h>

#include "test_support.hpp"

using namespace tinydem;

/// Particles after a run in short pieces, which spawning and new lists interrupt.
static vector<Particle> after_run(int threads, const Parameters& p, const vector<Particle>& initial, int steps) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Simulation s(p, open_box(real(0.6), 1, real(-0.6)), initial);
  for (int k = 0; k < steps; k += 10) s.run(10);
  omp_set_num_threads(before);
  CHECK(s.slabs.size() > 1);
  CHECK(s.rebuilds > 1);
  CHECK(s.steps == steps);  // counted once, whoever moves the particles
  CHECK(s.summary().contacts > s.size() / 10);
  return s.particles();
}
TEST_CASE("exact: settling and spawning give the same bits for 1, 2, 3 and 8 threads") {
  const Parameters p = scene("g = 0,0,-9.81; Nspawn = 20; Nmax = 3700; smin = -0.2,-0.2,0.2; smax = 0.2,0.2,0.4; "
                             "Rmin = 0.005");
  const auto one = after_run(1, p, swarm(15), 60);
  CHECK(one.size() == 3700);
  for (const int threads : {2, 3, 8}) CHECK(same_bits(one, after_run(threads, p, swarm(15), 60)));
}
TEST_CASE("exact: eight slabs give the same bits for 1, 2, 3 and 8 threads") {
  const Parameters p = scene("Rmin = 0.005");
  const auto gas = swarm(41);
  const auto one = after_run(1, p, gas, 20);
  for (const int threads : {2, 3, 8}) CHECK(same_bits(one, after_run(threads, p, gas, 20)));
}
#endif
