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
