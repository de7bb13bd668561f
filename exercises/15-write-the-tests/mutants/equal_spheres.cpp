// loses: torque_on_the_other
// All spheres of one size.
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
  const double R = 0.01, S = 0.01, v = 1;
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
TEST(first_step_of_the_sliding_spring) {
  const double d = 1e-4, v = 0.1, dt = 1e-5, R = 0.01;
  Simulation s(scene("en = 1; mus = 50; mur = 0; mut = 0; dt = 1e-5"), {},
               {ball({0, 0, 0}, R, {0, v, 0}), ball({2 * R - d, 0, 0}, R)});
  s.run(1);
  const double ks = 8 * Gs * std::sqrt(R / 2 * d);
  expect("force", -mass(R) * (s.particles()[0].v.y - v) / dt / (ks * v * dt), 1, 1e-6);
}
TEST(slide_then_roll) {
  const double R = 0.01, k = 4.0 / 3 * 2 * Es * std::sqrt(R);
  const double rest = std::pow(mass(R) * 9.81 / k, 2.0 / 3);
  Simulation s(scene("g = 0,0,-9.81; mus = 0.3; mur = 0; mut = 0; en = 0.5"), flat_floor(),
               {ball({0, 0, R - rest}, R, {1, 0, 0})});
  s.run(200);
  expect("speed while it slides", s.particles()[0].v.x, 1 - 0.3 * 9.81 * s.time(), 0.002);
  s.run(2000);
  expect("speed when it rolls", s.particles()[0].v.x, 5.0 / 7, 0.002);
}
TEST(gears_do_not_rub) {
  const double R = 0.01, d = 1e-4;
  Simulation s(scene("en = 1; mus = 1; mur = 0; mut = 0; dt = 1e-5"), {},
               {ball({0, 0, 0}, R, {}, {0, 0, 30}), ball({2 * R - d, 0, 0}, R, {}, {0, 0, -30})});
  s.run(20);
  expect("spin", s.particles()[0].w.z, 30, 1e-9);
}
TEST(angular_momentum_of_unequal_spheres) {
  Simulation s(scene("en = 0.7; mus = 0.4; mur = 0; mut = 0; dt = 1e-6"), {},
               {ball({0, 0, 0}, 0.01, {1, 0.7, 0}, {20, -10, 5}), ball({0.0201, 0, 0}, 0.01)});
  const auto total = [&s] {
    Vec3 L;
    for (const Particle& a : s.particles())
      L += mass(a.R) * cross(a.x, a.v) + 0.4 * mass(a.R) * a.R * a.R * a.w;
    return L;
  };
  const Vec3 before = total();
  s.run(2000);
  expect("change of L", norm(total() - before) / norm(before), 0, 1e-4);
}
TEST(a_pair_that_turns_together_has_no_rolling_friction) {
  const double R = 0.01;
  Simulation s(scene("en = 1; mus = 0; mur = 1; mut = 0; dt = 1e-5"), {},
               {ball({0, 0, 0}, R, {}, {0, 0, 30}), ball({0.0199, 0, 0}, R, {}, {0, 0, 30})});
  s.run(20);
  expect("spin", s.particles()[0].w.z, 30, 1e-9);
}
TEST(rolling_friction_has_a_limit) {
  const double R = 0.01, d = 1e-4, dt = 1e-7;
  Simulation s(scene("en = 1; mus = 0; mur = 0.2; mut = 0; dt = 1e-7"), {},
               {ball({0, 0, 0}, R, {}, {0, 0, 1e5}), ball({2 * R - d, 0, 0}, R)});
  s.run(1);
  const double load = 4.0 / 3 * Es * std::sqrt(R / 2 * d) * d;
  const double torque = (1e5 - s.particles()[0].w.z) / dt * 0.4 * mass(R) * R * R;
  expect("torque", torque / (0.2 * load * R / 2), 1, 1e-4);
}
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
