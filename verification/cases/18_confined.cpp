// Spheres that move on a line or in a plane never leave it, not even in the last bit.
//
// No force of the model points out of a plane in which all centres, all velocities and all mesh
// elements are symmetric, if spins are perpendicular to it; on a line, spins must point along it. A
// term that is only nearly zero would leave the plane by rounding errors and grow.
#include <random>

#include "support.hpp"

using namespace verification;

struct Confined {
  std::string name;
  Vec3 place, spin;  // 1 for the components that may differ from zero
};
struct Tally {
  long departures = 0, pairs = 0, walls = 0, runs = 0;
};
static Vec3 along(const Vec3& a, const Vec3& axes) {
  return {a.x * axes.x, a.y * axes.y, a.z * axes.z};
}
static const Vec3 centre{real(0.123), real(-0.0456), real(0.789)};

/// Walls across every axis along which particles can move: points, edges, triangles or rectangles.
static Mesh box(const Confined& c, double size, int corners) {
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Mesh mesh;
  for (size_t k = 0; k < 3; ++k)
    for (const double side : {-size, size}) {
      if (dot(axes[k], c.place) == 0) continue;
      const Vec3 a = axes[(k + 1) % 3], b = axes[(k + 2) % 3],
                 middle = centre + real(side) * axes[k];
      const Vec3 corner = middle - real(1.7) * a - real(0.9) * b;
      const int n = int(mesh.vertices.size());
      if (corners == 1) mesh.vertices.push_back(middle);
      if (corners == 2)
        for (const double s : {-1.7, 1.3}) mesh.vertices.push_back(middle + real(s) * a);
      if (corners > 2)
        for (const Vec3& v : {corner, corner + 3 * a, corner + 3 * (a + b), corner + 3 * b})
          mesh.vertices.push_back(v);
      mesh.elements.push_back({corners, {n, n + 1, n + 2, n + 3}, 0});
    }
  return mesh;
}
/// Thirty spheres that fly together with random velocities and spins.
static tinydem::vector<Particle> cloud(const Confined& c, double size) {
  std::mt19937_64 bits(4);
  const auto random = [&](double low, double high) {
    return real(low + (high - low) * double(bits() >> 11) * 0x1p-53);
  };
  const auto vector = [&](double a) { return Vec3{random(-a, a), random(-a, a), random(-a, a)}; };
  tinydem::vector<Particle> all;
  while (all.size() < 30) {
    const Vec3 x = along(vector(size - 0.02), c.place);
    bool free = true;
    for (const Particle& a : all) free = free && norm(a.x - centre - x) > real(0.015);
    if (!free) continue;
    all.push_back(ball(centre + x, random(0.004, 0.007),
                       real(c.name.size() > 1 ? -5 : 3) * x + along(vector(2), c.place),
                       along(vector(100), c.spin)));
  }
  return all;
}
static void check(const Confined& c, Simulation& sim, long looks, Tally& tally) {
  const auto before = sim.particles();
  for (long k = 0; k < looks; ++k) {
    sim.run(5);
    for (const auto& contact : sim.contacts()) ++(contact.j < 0 ? tally.walls : tally.pairs);
  }
  const auto after = sim.particles();
  for (size_t i = 0; i < after.size(); ++i)
    for (real Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const bool moved = after[i].x.*axis != before[i].x.*axis || after[i].v.*axis != 0;
      if (c.place.*axis == 0) tally.departures += moved;
      if (c.spin.*axis == 0) tally.departures += after[i].w.*axis != 0;
    }
  ++tally.runs;
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  Csv csv(run.out / "confined.csv",
          "where,walls,scheme,departures,particle_contacts,wall_contacts");
  const Confined cases[] = {{"x", {1, 0, 0}, {1, 0, 0}},  {"y", {0, 1, 0}, {0, 1, 0}},
                            {"z", {0, 0, 1}, {0, 0, 1}},  {"xy", {1, 1, 0}, {0, 0, 1}},
                            {"yz", {0, 1, 1}, {1, 0, 0}}, {"zx", {1, 0, 1}, {0, 1, 0}}};
  const char* const kinds[] = {"", "point", "edge", "triangle", "rectangle"};
  long departures = 0, fewest = 1000000;
  for (int corners = 1; corners <= 4; ++corners)
    for (const std::string scheme : {"consistent", "paper"}) {
      long met = 0, hit = 0;
      for (const Confined& c : cases) {
        const double size = c.name.size() > 1 ? 0.1 : 0.4;
        Tally t;
        Simulation sim(scene("eta = 1e-3; en = 0.95; Rmesh = 0.01; scheme = " + scheme),
                       box(c, size, corners), cloud(c, size));
        check(c, sim, run.quick ? 600 : 2000, t);
        csv.row(c.name, kinds[corners], scheme, t.departures, t.pairs, t.walls);
        departures += t.departures, met += t.pairs, hit += t.walls;
      }
      fewest = std::min({fewest, met, hit});
    }
  metrics("departures", double(departures));
  metrics("contacts", double(fewest));
}
