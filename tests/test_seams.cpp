// Elements of a mesh that share points: what a contact remembers when the next element takes it over.
// Case 23 of the verification suite has the rest.
#include "test_support.hpp"

using namespace tinydem;

static const real R = real(0.01);
/// Six triangles about the origin in the plane z = 0.
static Mesh fan() {
  Mesh m{{{}}, {}};
  for (int k = 0; k < 6; ++k) {
    m.vertices.push_back({std::cos(k * pi / 3), std::sin(k * pi / 3), 0});
    m.elements.push_back({3, {0, 1 + k, 1 + (k + 1) % 6, 0}, 0});
  }
  return m;
}
TEST_CASE("exact: springs are handed over across an edge, and across a vertex from any triangle to any other") {
  const Mesh plane = one_element({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  Largest change;  // last measured: 3.8e-15
  int handed = 0;
  for (int from = 0; from < 12; ++from)
    for (int way = -5; way <= 5; ++way) {
      const real a = real(0.1 + from) * pi / 6, b = a + pi + real(way) * pi / 8;  // from an angle to another
      const Vec3 start = real(1e-4) * Vec3{std::cos(a), std::sin(a), 0}, end = real(1e-4) * Vec3{std::cos(b), std::sin(b), 0};
      const Parameters p = scene("Rmin = 0.01; mus = 10; mur = 10; Rmesh = 0");
      const Vec3 v = 2 / p.dt / 3 * (end - start);  // the second step takes it to the other side
      const Particle a0 = ball(start - real(0.5) * p.dt * v + Vec3{0, 0, real(0.98) * R}, R, v, {v.y / R, -v.x / R, real(0.1)});
      Simulation whole(p, plane, {a0}), cut(p, fan(), {a0});
      int last[2] = {-1, -2};  // elements of the last two steps
      for (int k = 0; k < 4; ++k) {
        whole.run(1), cut.run(1);
        const auto c = whole.contacts(), d = cut.contacts();
        REQUIRE(c.size() == 1);
        REQUIRE(d.size() == 1);
        if (last[0] == last[1]) change(d[0].us, c[0].us, R), change(d[0].ur, c[0].ur, R), change(d[0].ut, c[0].ut, R);
        change(cut.particles()[0].w, whole.particles()[0].w, norm(v) / R);
        handed += last[0] >= 0 && last[0] != d[0].element;
        last[1] = last[0], last[0] = d[0].element;
      }
    }
  CHECK(handed > 100);
  CHECK(change.error < 2e-14);
}
