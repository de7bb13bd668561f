// loses: contact_radius elastic_modulus effective_radius stiffness_of_walls damping tangential_stiffness sliding_limit spring_in_slip contact_velocity torque_on_the_other rolling_velocity rolling_limit right_solver
// Tests of spheres that never touch, and too few of them.
#include "exercise.hpp"

using tinydem::norm, tinydem::pi;

namespace {

double mass(double R) { return 4 * pi / 3 * 1000 * R * R * R; }
const double Es = 1e6 / (2 * (1 - 0.3 * 0.3)), Gs = 1e6 / (4 * 1.7 * 1.3);  // of the default material

/// Time steps a fraction of Eq. (50) for R = 0.01.
std::string fine(double share) {
  return "; dt = " + std::to_string(share * 0.01 * std::sqrt(1000 * 0.91 / 1e6));
}
/// The largest overlap in a head-on collision without damping.
double deepest(const Mesh& mesh, const std::vector<Particle>& start) {
  Simulation s(scene("en = 1; mus = 0; mur = 0" + fine(0.01)), mesh, start);
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    s.run(1);
    for (const auto& c : s.contacts()) most = std::max(most, double(c.delta));
  }
  return most;
}

}  // namespace

TEST(a_throw_step_by_step) {
  Simulation s(scene("g = 0,0,-9.81; dt = 0.001"), {}, {ball({0, 0, 0}, 0.01, {1, 0, 2})});
  s.run(100);
  expect("height", s.particles()[0].x.z, 2 * 0.1 - 9.81 * 1e-6 * 100 * 101 / 2, 1e-12);
}
TEST(drag_step_by_step) {
  Simulation s(scene("eta = 0.5; dt = 0.001"), {}, {ball({0, 0, 0}, 0.02, {1, 0, 0})});
  s.run(100);
  expect("speed", s.particles()[0].v.x,
         std::pow(1 - 0.001 * 4.5 * 0.5 / (1000 * 0.02 * 0.02), 100), 1e-12);
}
TEST(a_quarter_turn_after_another) {
  Particle a = ball({0, 0, 0}, 0.01, {}, {0, 0, 1});
  const double h = std::sqrt(0.5);
  a.q = {h, h, 0, 0};  // a quarter turn about x; then one about z, in the frame at rest
  Simulation s(scene("dt = 0.01570796326794896619"), {}, {a});
  s.run(100);
  const auto q = s.particles()[0].q;
  const double want[] = {0.5, 0.5, 0.5, 0.5};
  for (int k = 0; k < 4; ++k) expect("q", q[static_cast<std::size_t>(k)], want[k], 1e-9);
}
