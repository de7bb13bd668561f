// Exercise 15: what a test is made of. You write tests; the solver is in tinydem/.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "tinydem.hpp"

using tinydem::Mesh, tinydem::Parameters, tinydem::Particle, tinydem::Simulation, tinydem::Vec3;

/// A test by name: TEST(free_flight) { ... expect(...) ... }
#define TEST(name)                                             \
  static void name();                                          \
  static const bool name##_is_listed = list_test(#name, name); \
  static void name()
bool list_test(const std::string& name, const std::function<void()>& test);

/// Fails the test if |measured - expected| > tolerance, or if it is not a number. `what` is shown.
void expect(const std::string& what, double measured, double expected, double tolerance);
/// Fails the test if the condition is false.
void expect(const std::string& what, bool condition);

/// Parameters from "en = 0.9; mus = 0". Nothing falls and nothing is spawned unless they say so.
inline Parameters scene(const std::string& text) {
  std::vector<tinydem::Setting> settings = {{"g", "0,0,0", "test"}, {"Nspawn", "0", "test"},
                                            {"Rmesh", "0", "test"}};
  for (const std::string& line : tinydem::split(text, ';'))
    if (const auto words = tinydem::split(line, '='); words.size() == 2)
      settings.push_back({words[0], words[1], "test"});
  return tinydem::resolve(settings);
}
/// A sphere: centre [L], radius [L], velocity [L/T], spin [1/T].
inline Particle ball(const Vec3& x, double R, const Vec3& v = {}, const Vec3& w = {}) {
  Particle a;
  a.x = x, a.R = R, a.v = v, a.w = w;
  return a;
}
/// A large horizontal floor at height z.
inline Mesh flat_floor(double z = 0) {
  Mesh m;
  m.vertices = {{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}};
  m.elements = {{4, {0, 1, 2, 3}, 0}};
  return m;
}
