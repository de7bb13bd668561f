// The states that are timed: particles in a box, how they are made, kept in a file and read back.
#pragma once
#include <cstdint>
#include <cstring>
#include <functional>

#include "tinydem.hpp"

namespace bench {
using namespace tinydem;

/// Particles in a box [0, L] x [0, L] x [0, H] (a monolayer: y = 0), and how they came about.
struct State {
  double L = 0, H = 0, Rmin = 0, Rmax = 0;  // box, radii [L]
  double steps = 0, unrest = 0;  // steps of settling; kinetic energy left, as a share of sum m g R
  tinydem::vector<Particle> particles{};
};
const char magic[9] = "TDBENCH1";

/// Writes a state: magic, number of particles (64 bits), L, H, Rmin, Rmax, steps, unrest, then 14
/// doubles per particle (position, radius, velocity, quaternion, angular velocity).
inline void write(const string& path, const State& s) {
  std::ofstream file(path, std::ios::binary);
  const std::int64_t n = count(s.particles);
  const double head[] = {s.L, s.H, s.Rmin, s.Rmax, s.steps, s.unrest};
  file.write(magic, 8).write(reinterpret_cast<const char*>(&n), 8);
  file.write(reinterpret_cast<const char*>(head), sizeof head);
  for (const Particle& a : s.particles) {
    double row[14];
    for (int k = 0; k < 14; ++k) row[k] = double((&a.x.x)[k]);
    file.write(reinterpret_cast<const char*>(row), sizeof row);
  }
  if (!file.flush()) throw RunError(path + ": cannot be written");
}
/// Reads what write() wrote; throws InputError for anything else.
inline State read(const string& path) {
  std::ifstream file(path, std::ios::binary);
  State s;
  char word[8] = {};
  double head[6], row[14];
  std::int64_t n = 0;
  file.read(word, 8).read(reinterpret_cast<char*>(&n), 8);
  file.read(reinterpret_cast<char*>(head), sizeof head);
  if (!file || std::memcmp(word, magic, 8) != 0)
    throw InputError(path + ": is no state of the bench; remove it and run ./dem bench again");
  s.L = head[0], s.H = head[1], s.Rmin = head[2], s.Rmax = head[3], s.steps = head[4];
  s.unrest = head[5];
  s.particles.resize(size_t(n));
  for (Particle& a : s.particles) {
    file.read(reinterpret_cast<char*>(row), sizeof row);
    for (int k = 0; k < 14; ++k) (&a.x.x)[k] = real(row[k]);
  }
  if (!file) throw InputError(path + ": is shorter than its " + to_string(n) + " particles");
  return s;
}

// --------------------------------------------------------------------------------------- meshes

/// Two triangles per square on n x n squares of edge h, the lower corner at (x, y, z).
inline void tile(Mesh& m, int n, real h, Vec3 corner, int group) {
  const int first = count(m.vertices);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      m.vertices.push_back(corner + Vec3{real(i) * h, real(j) * h, 0});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = first + i * (n + 1) + j, b = a + n + 1;
      m.elements.push_back({3, {a, b, a + 1, 0}, group});
      m.elements.push_back({3, {b, b + 1, a + 1, 0}, group});
    }
}
inline void rectangle(Mesh& m, Vec3 a, Vec3 ab, Vec3 ad, int group) {
  const int k = count(m.vertices);
  for (const Vec3& p : {a, a + ab, a + ab + ad, a + ad}) m.vertices.push_back(p);
  m.elements.push_back({4, {k, k + 1, k + 2, k + 3}, group});
}
/// The walls of a state; group 0 is the floor, group 1 the rest. `kind`: none; box (open above);
/// closed; slot (monolayer between x = 0 and x = L); hopper (a square hole in the middle of the
/// floor, a quarter of L wide, and a ground far below); far (box, and 10^5 triangles out of reach);
/// fine (box, the floor of 10^5 triangles).
inline Mesh walls(const string& kind, const State& s) {
  const char* const kinds[] = {"none", "box", "closed", "slot", "hopper", "far", "fine"};
  if (std::find(std::begin(kinds), std::end(kinds), kind) == std::end(kinds))
    throw InputError("mesh = '" + kind + "' must be none, box, closed, slot, hopper, far or fine");
  const real L = real(s.L), H = real(s.H), hole = L / 4, rim = (L - hole) / 2;
  const Vec3 X{L, 0, 0}, Y{0, L, 0}, Z{0, 0, H};
  const int fineness = 224;  // 2 x 224^2 = 100 352 triangles
  Mesh m;
  if (kind == "none") return m;
  if (kind == "slot") {
    for (const Vec3& side : {Vec3{}, X}) rectangle(m, side + real(-0.5) * Y, Y, Z, 1);
    return rectangle(m, real(-0.5) * Y, X, Y, 0), m;
  }
  if (kind == "fine") tile(m, fineness, L / fineness, {}, 0);
  else if (kind == "hopper") {
    rectangle(m, {}, X, {0, rim, 0}, 0), rectangle(m, {0, L - rim, 0}, X, {0, rim, 0}, 0);
    rectangle(m, {0, rim, 0}, {rim, 0, 0}, {0, hole, 0}, 0);
    rectangle(m, {L - rim, rim, 0}, {rim, 0, 0}, {0, hole, 0}, 0);
    rectangle(m, {-L, -L, -L}, {3 * L, 0, 0}, {0, 3 * L, 0}, 1);
  } else rectangle(m, {}, X, Y, 0);
  rectangle(m, {}, X, Z, 1), rectangle(m, Y, X, Z, 1);
  rectangle(m, {}, Y, Z, 1), rectangle(m, X, Y, Z, 1);
  if (kind == "closed") rectangle(m, Z, X, Y, 1);
  if (kind == "far") tile(m, fineness, L / fineness, {0, 0, -100 * L}, 1);
  return m;
}

// ------------------------------------------------------------------------------------- particles

/// The same numbers on every machine and in every precision.
struct Dice {
  std::mt19937_64 random{1};
  double uniform() { return double(random() >> 11) * 0x1p-53; }  // [0, 1)
  double between(double a, double b) { return a + (b - a) * uniform(); }
};
/// N spheres on a cubic lattice that is 1 % wider than the largest of them, n x n in a layer, each
/// off its place by up to a hundredth of a radius, with velocities of up to 0.25 m/s sideways.
inline State lattice(int N, const std::function<double(Dice&)>& radius, double Rmax, int n) {
  State s;
  Dice dice;
  const double edge = 2.02 * Rmax;
  s.L = n * edge, s.H = 3 * s.L, s.Rmax = Rmax;
  for (int k = 0; k < N; ++k) {
    Particle a;
    a.R = real(radius(dice));
    const int place[] = {k % n, k / n % n, k / n / n};
    for (int c = 0; c < 3; ++c)
      (&a.x.x)[c] = real((place[c] + 0.5) * edge + 0.01 * Rmax * (dice.uniform() - 0.5));
    a.v = {real(dice.between(-0.25, 0.25)), real(dice.between(-0.25, 0.25)), 0};
    s.particles.push_back(a);
  }
  s.H = std::max(s.H, (N / n / n + 2) * edge);
  return s;
}
/// N spheres of 1 mm on a lattice, and in its midst 7 of 10 mm instead of those in their way.
inline State among_large(int N) {
  const double R = 0.01, r = 0.001;
  const int n = int(std::ceil(std::cbrt(N + 14000)));
  State s = lattice(n * n * n * 2, [&](Dice&) { return r; }, r, n);
  tinydem::vector<Particle> all;
  for (int k = 0; k < 7; ++k) {
    const double half = s.L / 2, place[] = {half * (k % 2), half * (k / 2 % 2), half * (k / 4)};
    Particle a;
    a.x = {real(place[0] + half / 2), real(place[1] + half / 2), real(place[2] + half / 2)};
    a.R = real(R), all.push_back(a);
  }
  for (const Particle& a : s.particles) {
    const bool free = std::all_of(all.begin(), all.begin() + 7, [&](const Particle& b) {
      return square(a.x - b.x) > square(a.R + b.R);
    });
    if (free && count(all) < N + 7) all.push_back(a);
  }
  s.particles = all, s.Rmax = R;
  return s;
}
/// Spheres of the given radii, the largest first, each at a random free place of a box that they
/// fill to `share`, twice as high as wide.
inline State scatter(tinydem::vector<double> radii, double share) {
  std::sort(radii.begin(), radii.end(), std::greater<>());
  double volume = 0;
  for (const double R : radii) volume += 4 * double(pi) / 3 * R * R * R;
  State s;
  Dice dice;
  s.L = std::cbrt(volume / share / 2), s.H = 2 * s.L, s.Rmax = radii[0];
  const double cell = 2 * radii.back();  // a sphere is entered in every cell that it may cover
  const int n = int(s.L / cell) + 1, nz = int(s.H / cell) + 1;
  tinydem::vector<tinydem::vector<int>> cells(size_t(n) * size_t(n) * size_t(nz));
  const auto visit = [&](const Particle& a, const auto& f) {
    const auto index = [&](real x, int most) { return std::clamp(int(double(x) / cell), 0, most); };
    const real r = a.R;
    for (int i = index(a.x.x - r, n - 1); i <= index(a.x.x + r, n - 1); ++i)
      for (int j = index(a.x.y - r, n - 1); j <= index(a.x.y + r, n - 1); ++j)
        for (int k = index(a.x.z - r, nz - 1); k <= index(a.x.z + r, nz - 1); ++k)
          f(cells[(size_t(i) * size_t(n) + size_t(j)) * size_t(nz) + size_t(k)]);
  };
  for (size_t k = 0, tries = 0; k < radii.size(); ++tries) {
    if (tries > 1000 * (k + 1)) throw RunError("no room for all spheres; fill a smaller share");
    Particle a;
    a.R = real(radii[k]);
    const auto place = [&](double edge) { return real(dice.between(radii[k], edge - radii[k])); };
    a.x = {place(s.L), place(s.L), place(s.H)};
    bool free = true;
    visit(a, [&](const auto& here) {
      for (const int j : here) {
        const Particle& b = s.particles[j];
        free = free && square(a.x - b.x) > square(a.R + b.R);
      }
    });
    if (!free) continue;
    visit(a, [&](auto& here) { here.push_back(int(k)); });
    s.particles.push_back(a), ++k;
  }
  return s;
}
/// A settled packing repeated m times in x and y (every other one mirrored, so that walls meet
/// walls) and stacked until there are N particles; the topmost are left out. m = 0: about a cube.
inline State stacked(const State& block, int N, int m = 0) {
  State s = block;
  if (m == 0) m = std::max(1, int(std::lround(std::cbrt(N / count(block.particles)))));
  double top = 0;
  for (const Particle& a : block.particles) top = std::max(top, double(a.x.z + a.R));
  s.particles.clear(), s.L = m * block.L, s.H = 3 * s.L;
  for (int layer = 0; count(s.particles) < N; ++layer)
    for (int k = 0; k < m * m; ++k)
      for (Particle a : block.particles) {
        const bool flip_x = k % m % 2, flip_y = k / m % 2;
        const real L = real(block.L);
        a.x.x = real(k % m) * L + (flip_x ? L - a.x.x : a.x.x);
        a.x.y = real(k / m) * L + (flip_y ? L - a.x.y : a.x.y);
        a.x.z += real(layer * top), a.v = a.w = {};
        s.particles.push_back(a);
      }
  std::stable_sort(s.particles.begin(), s.particles.end(),
                   [](const Particle& a, const Particle& b) { return a.x.z < b.x.z; });
  s.particles.resize(size_t(N));
  return s;
}
/// A state that has not settled yet, by name. Radii in metres: packing 5 mm; poly 3.5 to 7 mm;
/// monolayer and gas 5 mm; ratio: N of 1 mm and 7 of 10 mm; broad: 1 to 10 mm, number ~ R^-4.
inline State loose(const string& kind, int N) {
  const int cube = int(std::ceil(std::cbrt(N))), square = int(std::ceil(std::sqrt(N)));
  const auto same = [](Dice&) { return 0.005; };
  State s;
  if (kind == "packing") s = lattice(N, same, 0.005, cube);
  else if (kind == "poly")
    s = lattice(N, [](Dice& d) { return d.between(0.0035, 0.007); }, 0.007, cube);
  else if (kind == "monolayer") {
    s = lattice(N, same, 0.005, square);
    for (Particle& a : s.particles) a.x = {a.x.x, 0, a.x.y}, a.v = {a.v.x, 0, a.v.y};
  } else if (kind == "ratio") s = among_large(N);
  else if (kind == "gas" || kind == "broad") {
    tinydem::vector<double> radii(size_t(N), kind == "gas" ? 0.005 : 0.001);
    Dice dice;
    if (kind == "broad")  // p(R) ~ R^-4: the same volume of spheres in every octave of radii
      for (double& R : radii) R = 0.001 / std::cbrt(1 - dice.uniform() * (1 - 1e-3));
    s = scatter(radii, kind == "gas" ? 0.05 : 0.3);
    if (kind == "gas")
      for (Particle& a : s.particles)
        a.v = {real(dice.between(-1, 1)), real(dice.between(-1, 1)), real(dice.between(-1, 1))};
  } else
    throw InputError("state '" + kind +
                     "' must be packing, poly, monolayer, gas, ratio or broad");
  s.Rmin = s.Rmax;
  for (const Particle& a : s.particles) s.Rmin = std::min(s.Rmin, double(a.R));
  return s;
}
}  // namespace bench
