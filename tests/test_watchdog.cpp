// A run that cannot go on ends with an error that names the particle; it never goes on with NaN.
#include "test_support.hpp"

using namespace tinydem;

static const real R = real(0.01);
static bool has(const string& text, const string& part) { return text.find(part) != string::npos; }

/// What a simulation says about particles that it cannot start with.
static string refusal(const vector<Particle>& initial, const Mesh& mesh = {}) {
  try {
    Simulation(scene(""), mesh, initial);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}
TEST_CASE("exact: particles that coincide or overlap by more than a radius are refused") {
  const Mesh point = one_element({{0, 0, 0}});  // Rmesh = 0.002
  struct Case {
    real distance;
    bool wall, refused;
  };
  const Case cases[] = {{0, false, true},          {real(0.99) * R, false, true},  {real(1.01) * R, false, false},
                        {real(0.0019), true, true}, {0, true, true},               {real(0.0021), true, false}};
  for (const Case& c : cases) {
    vector<Particle> all = {ball({3, 0, 0}, R), ball({0, 0, c.distance}, R)};
    if (!c.wall) all.push_back(ball({0, 0, 0}, R));
    const string message = refusal(all, c.wall ? point : Mesh());
    CAPTURE(message);
    CHECK(message.empty() == !c.refused);
    if (c.refused) CHECK(has(message, "particle 2"));
    if (c.refused) CHECK(has(message, c.wall ? "mesh element 0" : "particle 3"));
    CHECK(!has(message, "nan"));
  }
  // All of them are named together.
  const string both = refusal({ball({}, R), ball({}, R), ball({1, 0, 0}, R), ball({1, 0, 0}, 2 * R)});
  CHECK(has(both, "particle 1"));
  CHECK(has(both, "particle 3"));
}

/// What a run says in which the particles become too fast, and when.
static string failure(Simulation s, long steps) {
  try {
    s.run(steps);
  } catch (const RunError& e) {
    return e.what();
  }
  return "";
}
TEST_CASE("exact: a run stops at a particle that is too fast, too deep in another one, or not a number") {
  const Parameters p = scene("E = 1e3; dt = 1e-4");  // soft
  const real fast = R / p.dt;
  const real nan = std::numeric_limits<real>::quiet_NaN(), inf = std::numeric_limits<real>::infinity();
  const Particle far = ball({9, 9, 9}, R);
  const auto pair = [&](real v) { return vector<Particle>{far, ball({0, 0, 2 * R}, R, {0, 0, -v}), ball({}, R, {0, 0, v})}; };
  const Mesh point = one_element({{0, 0, 0}});
  struct Case {
    string expected;
    vector<Particle> particles;
    Mesh mesh;
  };
  const Case cases[] = {
      {"", {far, ball({}, R, {0, 0, real(0.99) * fast})}, {}},
      {"particle 2 moved more than its radius", {far, ball({}, R, {0, 0, real(1.01) * fast})}, {}},
      {"overlaps another by more than a radius", pair(real(0.4) * fast), {}},
      {"particle 2 passes through a mesh element",
       {far, ball({0, 0, real(1.2) * R}, R, {0, 0, real(-0.6) * fast})}, point}};
  for (const Case& c : cases) {
    const string message = failure(Simulation(p, c.mesh, c.particles), 5);
    CAPTURE(c.expected);
    CAPTURE(message);
    CHECK(message.empty() == c.expected.empty());
    CHECK(has(message, c.expected));
    if (!message.empty()) CHECK(has(message, "try a smaller --dt"));
  }
  for (const real bad : {inf, nan}) {
    CHECK_THROWS_AS(Simulation(p, {}, {far, ball({}, R, {0, bad, 0})}), InputError);
    CHECK_THROWS_AS(Simulation(p, {}, {far, ball({}, R, {}, {0, 0, bad})}), InputError);
    Simulation moving(p, {}, {far, ball({}, R)}), spinning = moving;
    moving.grains[1].v.y = bad, spinning.grains[1].w.y = bad;
    CHECK(has(failure(moving, 5), "moved more than its radius"));
    CHECK(has(failure(spinning, 5), "spins too fast"));
  }
}
TEST_CASE("exact: a run that failed stays failed") {
  const Parameters p = scene("");
  Simulation s(p, {}, {ball({}, R, {0, 0, 2 * R / p.dt})});
  CHECK_THROWS_AS(s.run(10), RunError);
  CHECK_THROWS_AS(s.run(10), RunError);
  CHECK(s.steps == 1);
}

/// Does a run with this sphere end in an error, or with the sphere where it came from? `height` is above the wall.
template <class F> static bool kept_or_stopped(Simulation s, real side, const F& height, int& stopped) {
  for (int k = 0; k < 60; ++k)
    try {
      s.run(1);
      if (side * height(s) < 0) return false;
    } catch (const RunError&) { return ++stopped, true; }
  return true;
}
TEST_CASE("exact: no sphere gets through a wall without thickness unnoticed, from either side, at any speed and phase") {
  const Mesh plate = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  Mesh fan{{{}}, {}};
  for (int k = 0; k < 6; ++k) {
    fan.vertices.push_back({std::cos(k * pi / 3), std::sin(k * pi / 3), 0});
    fan.elements.push_back({3, {0, 1 + k, 1 + (k + 1) % 6, 0}, 0});
  }
  int stopped = 0, runs = 0;
  for (const char* E : {"1e3", "1e7", "1e9"})
    for (const real side : {1, -1})
      for (const bool onto_vertex : {false, true})
        for (int share = 2; share <= 100; share += 7)
          for (int phase = 0; phase < 10; ++phase) {
            const Parameters p = scene(string("Rmin = 0.01; Rmesh = 0; dt = 2e-5; E = ") + E);
            const real v = real(share) / 100 * R / p.dt, d = R * (1 + real(phase * share) / 1000 + real(1e-3));
            const Particle a = ball({0, 0, side * d}, R, {onto_vertex ? 0 : v / 2, 0, -side * v * real(0.86)});
            const bool good = kept_or_stopped(Simulation(p, onto_vertex ? fan : plate, {a}), side,
                                              [](const Simulation& s) { return s.particles()[0].x.z; }, stopped);
            CHECK(good);
            ++runs;
          }
  CHECK(stopped > runs / 4);  // both happen
  CHECK(stopped < runs * 9 / 10);
}
TEST_CASE("exact: no wall gets past a sphere unnoticed, however fast it moves") {
  const Mesh plate = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  int stopped = 0, runs = 0;
  for (const real side : {1, -1})
    for (int share = 2; share <= 400; share += 7)
      for (const int meets : {0, 1}) {  // the sphere comes towards it
        Parameters p = scene("Rmin = 0.01; Rmesh = 0; E = 1e6");
        const real v = real(share) / 100 * R / p.dt;
        p.motion = "0 translate 0,0," + std::to_string(side * v);
        const Particle a = ball({0, 0, side * real(1.7) * R}, R, {0, 0, -side * v * real(meets)});
        CHECK(kept_or_stopped(Simulation(p, plate, {a}), side, [&](const Simulation& s) {
          return s.particles()[0].x.z - side * v * s.time(); }, stopped));
        ++runs;
      }
  CHECK(stopped > runs / 2);
  CHECK(stopped < runs);
}
TEST_CASE("exact: a sphere that a heavy one hammers against a thin wall does not get through unnoticed") {
  const Mesh plate = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  int stopped = 0, runs = 0;
  for (const char* E : {"1e4", "1e6"})
    for (const real big : {1, 5, 20})
      for (int share = 1; share <= 60; share += 6) {
        const Parameters p = scene(string("Rmin = 0.01; Rmax = 1; Rmesh = 0; E = ") + E);
        const real v = real(share) / 100 * R / p.dt;
        const vector<Particle> both = {ball({0, 0, real(0.999) * R}, R), ball({0, 0, (real(2.02) + big) * R}, big * R, {0, 0, -v})};
        CHECK(kept_or_stopped(Simulation(p, plate, both), 1, [](const Simulation& s) { return s.particles()[0].x.z; }, stopped));
        ++runs;
      }
  CHECK(stopped > runs / 4);
  CHECK(stopped < runs);
}
TEST_CASE("exact: centres that come to coincide, and numbers that stop being finite, end the run in the same step") {
  const Parameters p = scene("E = 1e6; mus = 0; mur = 0");
  const real nan = std::numeric_limits<real>::quiet_NaN(), inf = std::numeric_limits<real>::infinity();
  const vector<Particle> three = {ball({9, 0, 0}, R), ball({}, R), ball({0, 0, real(2.5) * R}, R)};
  Simulation coincident(p, {}, three);
  coincident.grains[2].x = coincident.grains[1].x, coincident.stale = true;
  CHECK(has(failure(coincident, 1), "overlaps another by more than a radius"));
  const Mesh point = one_element({{0, 0, -R}});
  Simulation on_point(p, point, three);
  for (Grain& g : on_point.grains) if (norm(g.x) < R) g.x = {0, 0, -R};
  on_point.stale = true;
  CHECK(has(failure(on_point, 1), "particle 2 passes through a mesh element"));
  for (const real bad : {nan, inf, -inf})
    for (int number = 0; number < 6; ++number) {  // of velocity and spin; a position is finite if all velocities were
      Simulation s(scene("E = 1e6; mus = 0; mur = 0; w0 = 1,0,0"), {}, three);  // else nobody asks for spins
      Grain& g = s.grains[1];
      (number < 3 ? (&g.v.x)[number] : (&g.w.x)[number - 3]) = bad;
      CAPTURE(number);
      CAPTURE(bad);
      CHECK(has(failure(s, 1), number < 3 ? "particle 2 moved more than its radius" : "particle 2 spins too fast"));
    }
}
