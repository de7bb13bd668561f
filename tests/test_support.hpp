// What the tests share: a scene in one string, the largest error of many, random numbers.
//
// The name of a test says what kind it is: `exact` (a value known to rounding), `closed form` (of the
// continuous motion) or `rate` (of convergence). A tolerance stands beside the last measured error
// and is at most ten times as large; `unit_tests -s -tc="*name*"` prints what is measured now.
#pragma once
#include <doctest/doctest.h>

#include <cstring>

#include "tinydem.hpp"

namespace tinydem {

/// Parameters from text like "en = 0.9; mus = 0". Nothing falls and nothing is spawned unless asked.
inline Parameters scene(const string& text) {
  vector<Setting> settings = {{"g", "0,0,0", "test"}, {"Nspawn", "0", "test"}};
  for (const string& line : split(text, ';'))
    if (const auto tokens = split(line, '='); tokens.size() == 2)
      settings.push_back({tokens[0], tokens[1], "test"});
  return resolve(settings);
}
inline Particle ball(const Vec3& x, real R, const Vec3& v = {}, const Vec3& w = {}) {
  return {x, R, v, {1, 0, 0, 0}, w};
}
/// A mesh of one element of group 0: a point, an edge, a triangle or a rectangle.
inline Mesh one_element(const vector<Vec3>& corners) {
  return {corners, {{int(corners.size()), {0, 1, 2, 3}, 0}}};
}
/// A floor and four walls at a distance a from the z axis.
inline Mesh open_box(real a, real top, real floor = 0) {
  Mesh box;
  for (const real z : {floor, top})
    box.vertices.insert(box.vertices.end(), {{-a, -a, z}, {a, -a, z}, {a, a, z}, {-a, a, z}});
  box.elements = {{4, {0, 1, 2, 3}, 0}};
  for (int k = 0; k < 4; ++k) box.elements.push_back({4, {k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4}, 0});
  return box;
}

/// The largest of many errors; a NaN stays.
struct Largest {
  double error = 0;
  void operator()(double e) {
    if (!(e <= error) && error == error) error = e;
  }
  void operator()(real a, real reference, real scale) {
    (*this)(double(abs(a - reference) / scale));
  }
  void operator()(const Vec3& a, const Vec3& reference, real scale) {
    (*this)(double(norm(a - reference) / scale));
  }
};

/// The same numbers on every machine.
struct Random {
  std::mt19937_64 bits;
  explicit Random(unsigned seed) : bits(seed) {}
  real operator()(real low, real high) { return low + (high - low) * real(double(bits() >> 11) * 0x1p-53); }
  Vec3 vector(real size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
  Vec3 direction() {
    Vec3 a = vector(1);
    while (!(square(a) > real(0.01) && square(a) < 1)) a = vector(1);
    return (1 / norm(a)) * a;
  }
};

/// n^3 spheres on a lattice that fly together and spin: within 200 steps most of them collide.
inline vector<Particle> swarm(int n, unsigned seed = 1) {
  Random random(seed);
  vector<Particle> all;
  for (int k = 0; k < n * n * n; ++k) {
    const real middle = real(n - 1) / 2;
    const Vec3 x = real(0.022) * Vec3{real(k % n) - middle, real(k / n % n) - middle, real(k / n / n) - middle};
    const Vec3 w = random.vector(30), v = -15 * x + random.vector(1);  // in this order with every compiler
    all.push_back(ball(x, random(real(0.007), real(0.01)), v, w));
  }
  return all;
}

inline bool same_bits(const vector<Particle>& a, const vector<Particle>& b) {
  const auto equal = [](Particle p, Particle q) {
    return std::memcmp(&p, &q, sizeof p) == 0;  // 14 numbers without padding
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), equal);
}

}  // namespace tinydem
