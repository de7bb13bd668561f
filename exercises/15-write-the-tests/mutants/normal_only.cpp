// loses: tangential_stiffness sliding_limit spring_in_slip contact_velocity torque_on_the_other rolling_velocity rolling_limit drag orientation right_solver
// Collisions without friction.
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

TEST(deepest_overlap_of_unequal_spheres) {
  const double R = 0.01, S = 0.005, v = 1;
  const double Rs = R * S / (R + S), ms = mass(R) * mass(S) / (mass(R) + mass(S));
  const double k = 4.0 / 3 * Es * std::sqrt(Rs);
  const double want = std::pow(5 * ms * v * v / (4 * k), 0.4);
  const double d = deepest({}, {ball({0, 0, 0}, R, {v, 0, 0}), ball({R + S + 1e-6, 0, 0}, S)});
  expect("deepest overlap", d / want, 1, 0.01);
}
TEST(deepest_overlap_at_a_wall) {
  const double R = 0.01, k = 4.0 / 3 * 2 * Es * std::sqrt(R);
  const double d = deepest(flat_floor(), {ball({0, 0, R + 1e-6}, R, {0, 0, -1})});
  expect("deepest overlap", d / std::pow(5 * mass(R) / (4 * k), 0.4), 1, 0.01);
}
TEST(restitution) {
  for (const char* en : {"0.3", "0.6", "0.9"}) {
    Simulation s(scene(std::string("mus = 0; mur = 0; en = ") + en + fine(0.02)), {},
                 {ball({0, 0, 0}, 0.01, {1, 0, 0}), ball({0.0201, 0, 0}, 0.01)});
    s.run(1000);
    const auto all = s.particles();
    expect("restitution", all[1].v.x - all[0].v.x, std::stod(en), 0.02);
  }
}
TEST(a_throw_step_by_step) {
  Simulation s(scene("g = 0,0,-9.81; dt = 0.001"), {}, {ball({0, 0, 0}, 0.01, {1, 0, 2})});
  s.run(100);
  expect("height", s.particles()[0].x.z, 2 * 0.1 - 9.81 * 1e-6 * 100 * 101 / 2, 1e-12);
}
