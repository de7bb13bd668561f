// Mesh groups that vibrate, translate and rotate.
#ifdef _OPENMP
#include <omp.h>
#endif

#include "test_support.hpp"

using namespace tinydem;

static Parameters moving(const string& motion, const string& text = "") {
  Parameters p = scene(text);
  p.motion = motion, p.Rmesh = {real(0.01), real(0.02), 0};
  return p;
}
/// A triangle, a rectangle, an edge and a point of each group.
static Mesh shapes() {
  Random random(5);
  Mesh m;
  for (int group = 0; group < 3; ++group) {
    const int first = count(m.vertices);
    const Vec3 a = random.vector(1), u = random.direction(), v = random.direction(), w = cross(u, v);
    m.vertices.insert(m.vertices.end(), {a, a + u, a + u + w, a + w, random.vector(1)});
    m.elements.push_back({4, {first, first + 1, first + 2, first + 3}, group});
    m.elements.push_back({3, {first, first + 2, first + 4, 0}, group});
    m.elements.push_back({2, {first + 1, first + 4, 0, 0}, group});
    m.elements.push_back({1, {first + 4, 0, 0, 0}, group});
  }
  return m;
}
static const char* const all_kinds = "0 vibrate 0.1,0.2,-0.3 2.5 0.7; 1 translate -1,0.5,2; 2 rotate 0.3,-0.2,0.1 1,2,-3";

TEST_CASE("exact: elements are where the motion puts them, and their surface has its velocity") {
  Simulation s(moving(all_kinds, "dt = 0.01"), shapes());
  Random random(6);
  Largest place, velocity;  // last measured: 4.2e-15, 9.3e-10 (a difference over 2e-6 s)
  for (s.steps = 0; s.steps < 200; s.steps += 7) {
    const real t = s.time();
    const auto at = [&](int group, const Vec3& x, real time) {
      if (group == 0) return x + (std::sin(5 * pi * time + real(0.7)) - std::sin(real(0.7))) * Vec3{real(0.1), real(0.2), real(-0.3)};
      if (group == 1) return x + time * Vec3{-1, real(0.5), 2};
      const Vec3 P{real(0.3), real(-0.2), real(0.1)}, w{1, 2, -3}, n = 1 / norm(w) * w, r = x - P;  // Rodrigues
      const real angle = norm(w) * time;
      return P + std::cos(angle) * r + std::sin(angle) * cross(n, r) + (1 - std::cos(angle)) * dot(n, r) * n;
    };
    Mesh there = s.mesh;
    for (int v = 0; v < count(there.vertices); ++v) there.vertices[v] = at(v / 5, s.mesh.vertices[v], t);
    s.move_mesh();
    for (int e = 0; e < count(s.mesh.elements); ++e) {
      const Vec3 c = random.vector(2);
      const Body<real> wall = s.wall(e, c);
      place(wall.x, closest_point(there, there.elements[e], c), 1);
      if (s.mesh.elements[e].n != 1) continue;  // a point of the mesh stays the closest one
      const real h = real(1e-6);
      const Vec3 x = s.mesh.corner(s.mesh.elements[e], 0);
      const int group = s.mesh.elements[e].group;
      const real middle = t - s.p.dt / 2;  // the velocity of a particle is that of the middle of a step
      const Vec3 way = at(group, x, t) - at(group, x, middle);
      velocity(s.wall(e, c, 2 / s.p.dt * way).v, 1 / (2 * h) * (at(group, x, middle + h) - at(group, x, middle - h)), 1);
    }
  }
  CHECK(place.error < 2e-14);
  CHECK(velocity.error < 1e-8);
}
TEST_CASE("closed form: an elastic sphere leaves a piston at twice its speed, and none is missed") {
  Largest speed;  // last measured: 1.5e-6
  for (const real V : {real(0.1), real(1), real(3)}) {
    vector<Particle> row;
    for (int k = 0; k < 20; ++k) row.push_back(ball({real(0.1) * real(k % 5), real(0.1) * real(k / 5), real(0.011) + V * real(0.01) * real(k + 1)}, real(0.01)));
    const Mesh plate = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    Parameters p = moving("0 translate 0,0," + to_string(V), "en = 1; E = 1e7; mus = 0; mur = 0; dt = 5e-6; Rmin = 0.01");
    p.Rmesh[0] = real(0.001);
    Simulation s(p, plate, row);
    s.run(long(real(0.26) / p.dt));
    for (const Particle& a : s.particles()) speed(a.v, {0, 0, 2 * V}, V);
    CHECK(s.rebuilds < 2000);
  }
  CHECK(speed.error < 1e-5);
}
// Eqs. (26-28)
TEST_CASE("exact: an impact on a belt is the impact on a resting plate, seen from the belt") {
  const Vec3 V{real(0.7), real(-0.4), real(0.2)};
  const Mesh plate = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const Vec3 x{0, 0, real(0.0205)}, v{1, real(0.3), -2}, w{20, -30, 40};
  for (const char* scheme : {"consistent", "paper"}) {
    Parameters p = moving("", "Rmin = 0.01");
    p.scheme = scheme;
    Simulation rest(p, plate, {ball(x, real(0.01), v, w)});
    p.motion = "0 translate 0.7,-0.4,0.2";
    Simulation belt(p, plate, {ball(x, real(0.01), v + V, w)});
    rest.run(300), belt.run(300);
    const Particle a = rest.particles()[0], b = belt.particles()[0];
    CHECK(a.v.z > 0);
    Largest change;  // last measured: 9.4e-14
    change(b.v - V, a.v, norm(v)), change(b.w, a.w, norm(w)), change(b.x - belt.time() * V, a.x, real(0.01));
    CHECK(change.error < 8e-13);
  }
}
// Eq. (51): in the frame that turns with the contact
TEST_CASE("exact: on a turntable the history of a contact turns with the table") {
  // A sphere that is pinned to the table by a deep overlap and moves with it keeps its springs, seen from the table.
  const Mesh table = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const real W = 2, r = real(0.1);
  Parameters p = moving("0 rotate 0,0,0 0,0,2", "g = 0,0,-10; Rmin = 0.01; mus = 1; mur = 1; mut = 1");
  p.Rmesh[0] = 0;
  const real half = W * p.dt / 2;  // the angle of half a step
  Simulation s(p, table, {ball({r, 0, real(0.0099)}, real(0.01), W * r * Vec3{std::sin(half), std::cos(half), 0}, {0, 0, W})});
  s.run(long(pi / W / p.dt));  // half a turn
  const Contact c = s.contacts().at(0);
  const Particle a = s.particles()[0];
  const Vec3 inward = -1 / norm(Vec3{a.x.x, a.x.y, 0}) * Vec3{a.x.x, a.x.y, 0};
  CHECK(a.x.x < real(-0.09));                                          // it went along
  CHECK(abs(norm(Vec3{a.x.x, a.x.y, 0}) - r) < real(0.005) * r);       // it did not slip: 8.9e-4
  const real needed = W * W * r * 4 / 3 * pi * 1000 * real(1e-6);      // centripetal force
  CHECK(abs(dot(c.fs, inward) - needed) < real(5e-3) * needed);        // last measured: 8.9e-4
  const real lag = dot(c.fs, cross(inward, Vec3{0, 0, 1})) / needed;   // springs are those of the last step
  CHECK(abs(lag - 2 * half) < real(1e-6));
}
TEST_CASE("exact: motion is refused unless it is complete, in range and given once for a group") {
  for (const char* motion : {"0", "0 vibrate", "0 vibrate 0,0,1", "0 vibrate 0,0 1", "0 vibrate 0,0,1 1 0 0", "0 vibrate 0,0,1 nan",
                             "0 translate 0,0,inf", "0 translate 1", "0 translate 0,0,1 1", "0 rotate 0,0,0", "0 rotate 0,0,0 1", "3 translate 0,0,1",
                             "-1 translate 0,0,1", "0.5 translate 0,0,1", "x translate 0,0,1", "0 fly 0,0,1", "0 translate 0,0,1; 0 rotate 0,0,0 0,0,1"}) {
    CAPTURE(motion);
    string message;
    try { resolve({{"motion", motion, "file:7"}}); } catch (const InputError& e) { message = e.what(); }
    CHECK(message.find("file:7: motion = '" + string(motion) + "' must be") == 0);
  }
  CHECK(resolve({{"motion", "0 translate 0,0,1; 2 vibrate 1,0,0 5;", "test"}}).motion.size() > 0);
}
#ifdef _OPENMP
TEST_CASE("exact: moving walls give the same bits for 1, 2, 3 and 8 threads") {
  const auto after = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    Parameters p = scene("g = 0,0,-9.81; Rmin = 0.005; Nspawn = 20; Nmax = 3700; smin = -0.2,-0.2,0.2; smax = 0.2,0.2,0.4");
    p.motion = "0 rotate 0,0,0 3,1,0";
    auto outward = swarm(15);
    for (Particle& a : outward) a.v = -a.v;
    Simulation s(p, open_box(real(0.18), real(0.3), real(-0.18)), outward);
    for (int k = 0; k < 60; k += 10) s.run(10);
    omp_set_num_threads(before);
    CHECK(s.slabs.size() > 1);
    int wall = 0;
    for (const Contact& c : s.contacts()) wall += c.element >= 0;
    CHECK(wall > 20);
    return s.particles();
  };
  const auto one = after(1);
  for (const int threads : {2, 3, 8}) CHECK(same_bits(one, after(threads)));
}
#endif
