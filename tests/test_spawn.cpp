// Particles that are spawned: where, how large, how often, and never in each other.
#include "test_support.hpp"

using namespace tinydem;

TEST_CASE("exact: spawned particles lie in the box, have radii in range, and touch nothing") {
  const Parameters p = scene("g = 0,0,-9.81; Nspawn = 10; Nmax = 300; Rmin = 0.002; Rmax = 0.008; v0 = 1,0,-2; "
                             "w0 = 1,2,3; smin = -0.06,-0.05,0; smax = 0.04,0.03,0.06; Rmesh = 0.005");
  Simulation s(p, open_box(real(0.07), 1, real(-0.06)), swarm(3));
  int spawned = 0, wrong = 0, overlaps = 0, forgotten = 0, waited = 0;
  while (s.steps < 3000 && s.size() < p.Nmax) {
    const int before = s.size();
    const real waiting = s.spawn_radius;
    s.run(1);
    const auto all = s.particles();
    if (waiting > 0) {  // a radius that found no room is the next one
      ++waited;
      forgotten += s.size() > before ? all[size_t(before)].R != waiting : s.spawn_radius != waiting;
    }
    for (size_t i = size_t(before); i < all.size(); ++i) {
      const Particle& a = all[i];
      ++spawned;
      wrong += !(a.R >= p.Rmin && a.R <= p.Rmax && a.x.x >= p.smin.x && a.x.x <= p.smax.x && a.x.y >= p.smin.y &&
                 a.x.y <= p.smax.y && a.x.z >= p.smin.z && a.x.z <= p.smax.z);
      wrong += norm(a.v - p.v0) + norm(a.w - p.w0) > 0;
      for (size_t j = 0; j < i; ++j) overlaps += norm(all[j].x - a.x) < all[j].R + a.R;
      for (const Element& e : s.mesh.elements) overlaps += norm(closest_point(s.mesh, e, a.x) - a.x) < a.R + p.Rmesh[0];
    }
  }
  CHECK(spawned > 200);
  CHECK(wrong == 0);
  CHECK(overlaps == 0);
  CHECK(forgotten == 0);
  CHECK(waited > 100);
  CHECK(s.size() <= p.Nmax);
}
TEST_CASE("exact: attempts per step, the largest number of particles, a box without volume") {
  struct Case {
    string settings;
    int after_one_step, after_many;
  };
  const Case cases[] = {{"Nspawn = 0; Nmax = 9", 0, 0},
                        {"Nspawn = 3; Nmax = 9", 3, 9},
                        {"Nspawn = 100; Nmax = 9", 9, 9},
                        {"Nspawn = 3; Nmax = 9; smin = 5,5,5; smax = 5,5,5", 1, 1}};
  for (const Case& c : cases) {
    Simulation s(scene("v0 = 0,0,0; Rmin = 0.01; smin = -50,-50,-50; smax = 50,50,50; " + c.settings));
    CHECK(s.size() == 0);
    s.run(1);
    CHECK(s.size() == c.after_one_step);
    s.run(30);
    CHECK(s.size() == c.after_many);
  }
}
TEST_CASE("exact: places and radii are spread evenly, and the seed decides") {
  const string settings = "Nspawn = 20000; Nmax = 10000; Rmin = 1e-6; Rmax = 3e-6; ";
  Simulation s(scene(settings));
  s.run(1);
  REQUIRE(s.size() == 10000);
  real sum[4] = {}, squares[4] = {};
  for (const Particle& a : s.particles()) {
    const Vec3 place = a.x - s.p.smin, box = s.p.smax - s.p.smin;  // as fractions of their ranges
    const real u[] = {place.x / box.x, place.y / box.y, place.z / box.z, (a.R - s.p.Rmin) / (s.p.Rmax - s.p.Rmin)};
    for (int k = 0; k < 4; ++k) sum[k] += u[k] / 10000, squares[k] += u[k] * u[k] / 10000;
  }
  for (int k = 0; k < 4; ++k) {
    CHECK(std::abs(sum[k] - 0.5) < 0.012);        // sampling error 0.003
    CHECK(std::abs(squares[k] - 1. / 3) < 0.012);  // sampling error 0.003
  }
  Simulation same(scene(settings)), other(scene(settings + "seed = 2"));
  same.run(1), other.run(1);
  CHECK(same_bits(s.particles(), same.particles()));
  CHECK(!same_bits(s.particles(), other.particles()));
}
