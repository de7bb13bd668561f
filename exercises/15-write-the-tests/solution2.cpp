// Exercise 15, written differently: most of it with whole motions and what they conserve.
#include "exercise.hpp"

namespace {

const double R = 0.01, pi = 3.14159265358979;
double mass(double radius) { return 1000 * 4.0 / 3 * pi * std::pow(radius, 3); }
double Rstar(double a, double b) { return a * b / (a + b); }
const double E_star = 1e6 / 1.82, G_star = 1e6 / 8.84;

/// Force on the first of two spheres in one small step, from where they are at rest but for v and w.
Vec3 first_force(const std::string& text, const std::vector<Particle>& start, Vec3* torque = nullptr) {
  const double dt = 1e-6;
  Simulation s(scene(text + "; en = 1; dt = 1e-6"), {}, start);
  s.run(1);
  const Particle a = s.particles()[0];
  const double m = mass(start[0].R) / dt;
  if (torque != nullptr) *torque = 0.4 * m * start[0].R * start[0].R * (a.w - start[0].w);
  return m * (a.v - start[0].v);
}
double hertz(double E, double Rs, double delta) {
  return 4.0 / 3 * E * std::sqrt(Rs) * std::pow(delta, 1.5);
}
void near(const std::string& what, double measured, double expected, double share) {
  expect(what, measured, expected, share * std::abs(expected));
}

}  // namespace

TEST(hertz_force_over_radii_and_overlaps) {
  for (const double other : {0.01, 0.02, 0.004})
    for (const double delta : {1e-5, 3e-4})
      near("force", first_force("mus = 0; mur = 0", {ball({0, 0, 0}, R), ball({0, R + other - delta, 0}, other)}).y,
           -hertz(E_star, Rstar(R, other), delta), 1e-6);
}
TEST(a_sphere_rests_on_a_floor) {
  const double rest = std::pow(mass(R) * 9.81 / hertz(2 * E_star, R, 1), 2.0 / 3);
  Simulation s(scene("g = 0,0,-9.81; en = 0.2; mus = 0"), flat_floor(), {ball({0, 0, R}, R)});
  s.run(4000);
  near("overlap", R - s.particles()[0].x.z, rest, 1e-6);
}
TEST(bounces_lose_en_squared) {
  Simulation s(scene("en = 0.8; mus = 0; mur = 0; dt = 2e-6"), flat_floor(), {ball({0, 0, R}, R, {0, 0, -1})});
  s.run(8000);
  expect("speed after the bounce", s.particles()[0].v.z, 0.8, 0.01);
}
TEST(tangential_spring) {
  const double delta = 2e-4, v = 0.05, shift = v * 1e-6;
  const Vec3 f = first_force("mus = 90; mur = 0; mut = 0", {ball({0, 0, 0}, R, {0, 0, v}), ball({0, 2 * R - delta, 0}, R)});
  near("force", f.z, -8 * G_star * std::sqrt(R / 2 * delta) * shift, 1e-4);
}
TEST(sliding_friction_is_mus_times_load) {
  const double delta = 2e-4;
  const Vec3 f = first_force("mus = 0.25; mur = 0; mut = 0", {ball({0, 0, 0}, R, {0, 0, 500}), ball({0, 2 * R - delta, 0}, R)});
  near("friction", f.z, -0.25 * hertz(E_star, R / 2, delta), 1e-4);
}
TEST(rolls_with_five_sevenths) {
  const double rest = std::pow(mass(R) * 9.81 / hertz(2 * E_star, R, 1), 2.0 / 3);
  Simulation s(scene("g = 0,0,-9.81; mus = 0.5; mur = 0; mut = 0"), flat_floor(), {ball({0, 0, R - rest}, R, {0, 2, 0})});
  s.run(3000);
  near("speed", s.particles()[0].v.y, 10.0 / 7, 0.003);
  near("spin", -s.particles()[0].w.x * R, 10.0 / 7, 0.003);
}
TEST(surfaces_that_move_alike_do_not_rub) {
  const double delta = 1e-4;
  const Vec3 f = first_force("mus = 1; mur = 0; mut = 0",
      {ball({0, 0, 0}, R, {}, {0, 0, 200}), ball({2 * R - delta, 0, 0}, R, {}, {0, 0, -200})});
  expect("friction", f.y, 0, 1e-9);
}
TEST(torques_of_a_pair) {
  const double delta = 1e-4, other = 0.003, load = hertz(E_star, Rstar(R, other), delta);
  Vec3 t;
  first_force("mus = 0.2; mur = 0; mut = 0", {ball({0, 0, 0}, other, {0, 300, 0}), ball({R + other - delta, 0, 0}, R)}, &t);
  near("torque on a small sphere", t.z, 0.2 * load * (other - delta / 2) * -1, 1e-3);
  Simulation s(scene("mus = 0.2; mur = 0; mut = 0; en = 1; dt = 1e-6"), {},
               {ball({0, 0, 0}, other, {0, 300, 0}), ball({R + other - delta, 0, 0}, R)});
  s.run(1);
  near("torque on a large one", 0.4e6 * mass(R) * R * R * s.particles()[1].w.z, -0.2 * load * (R - delta / 2), 1e-3);
}
TEST(equal_spins_do_not_roll) {
  Vec3 t;
  first_force("mus = 0; mur = 1; mut = 0", {ball({0, 0, 0}, R, {}, {0, 0, 80}), ball({0.0199, 0, 0}, R, {}, {0, 0, 80})}, &t);
  expect("torque", t.z, 0, 1e-12);
}
TEST(rolling_torque_is_mur_times_load) {
  const double delta = 1e-4;
  Vec3 t;
  first_force("mus = 0; mur = 0.1; mut = 0", {ball({0, 0, 0}, R, {}, {0, 0, 4e4}), ball({2 * R - delta, 0, 0}, R)}, &t);
  near("torque", t.z, -0.1 * hertz(E_star, R / 2, delta) * R / 2, 1e-4);
}
TEST(one_step_of_free_fall) {
  Simulation s(scene("g = 0,0,-10; dt = 0.01"), {}, {ball({0, 0, 0}, R, {0, 0, 0.5})});
  s.run(1);
  expect("z", s.particles()[0].x.z, 0.01 * 0.4, 1e-15);
}
TEST(speed_of_fall_in_a_viscous_fluid) {
  Simulation s(scene("g = 0,0,-10; eta = 2; dt = 0.001"), {}, {ball({0, 0, 0}, R)});
  s.run(5000);
  near("speed", -s.particles()[0].v.z, 10 * 2 * 1000 * R * R / (9 * 2), 1e-9);
}
TEST(a_spin_about_a_fixed_axis_leaves_that_axis_alone) {
  Particle a = ball({0, 0, 0}, R, {}, {0, 2, 0});
  a.q = {0.8, 0, 0, 0.6};
  Simulation s(scene("dt = 0.001"), {}, {a});
  s.run(300);  // by 0.6 about y: q = (cos 0.3, 0, sin 0.3, 0) (0.8, 0, 0, 0.6)
  const auto q = s.particles()[0].q;
  expect("q0", q[0], 0.8 * std::cos(0.3), 1e-9);
  expect("q1", q[1], 0.6 * std::sin(0.3), 1e-9);
  expect("q2", q[2], 0.8 * std::sin(0.3), 1e-9);
  expect("q3", q[3], 0.6 * std::cos(0.3), 1e-9);
}
