// Exercise 07, written differently: levers, one body after the other; body by body in the list.
#include "exercise.hpp"

namespace {
Vec3 negative(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
Vec3 sum_of(std::initializer_list<Vec3> all) {
  Vec3 s;
  for (const Vec3& a : all) s = {s.x + a.x, s.y + a.y, s.z + a.z};
  return s;
}
/// The load on the sphere whose centre lies at `lever` from the contact point, seen from there.
Load one_side(const Vec3& lever, const Vec3& normal, const Vec3& sliding, const Vec3& couple) {
  return {sum_of({normal, sliding}), sum_of({cross(negative(lever), sliding), couple})};
}
}  // namespace

Loads both_sides(const Contact& c, const Friction& f) {
  const Vec3 couple = c.Rstar * sum_of({cross(c.n, f.fr), f.ft * c.n});
  const Vec3 lever_i = c.ri * c.n, lever_j = -c.rj * c.n;
  return {one_side(lever_i, f.fn, f.fs, couple),
          one_side(lever_j, negative(f.fn), negative(f.fs), negative(couple))};
}

std::vector<Load> total(int bodies, const std::vector<Pair>& pairs) {
  std::vector<Load> result;
  for (int body = 0; body < bodies; ++body) {
    Load here{};
    for (const Pair& pair : pairs) {
      for (int side = 0; side < 2; ++side) {
        if ((side == 0 ? pair.i : pair.j) != body) continue;
        const Load& add = side == 0 ? pair.loads.i : pair.loads.j;
        here.f = sum_of({here.f, add.f});
        here.t = sum_of({here.t, add.t});
      }
    }
    result.push_back(here);
  }
  return result;
}
