// Exercise 07: action and reaction, equation by equation.
#include "exercise.hpp"

Loads both_sides(const Contact& c, const Friction& f) {
  const Vec3 ts = c.ri * cross(f.fs, c.n);                                      // Eq. (31)
  const Vec3 tr = c.Rstar * cross(c.n, f.fr);                                   // Eq. (32)
  const Vec3 tt = (f.ft * c.Rstar) * c.n;                                       // Eq. (33)
  Loads r;
  r.i.f = f.fn + f.fs;                                                          // Eq. (1)
  r.i.t = ts + tr + tt;                                                         // Eq. (2)
  r.j.f = -f.fn - f.fs;                                                         // Eqs. (56, 57)
  r.j.t = (c.rj / c.ri) * ts - tr - tt;                                         // Eqs. (58-60)
  return r;
}

std::vector<Load> total(int bodies, const std::vector<Pair>& pairs) {
  std::vector<Load> sum(static_cast<std::size_t>(bodies));
  for (const Pair& p : pairs) {
    Load& on_i = sum[static_cast<std::size_t>(p.i)];
    Load& on_j = sum[static_cast<std::size_t>(p.j)];
    on_i = {on_i.f + p.loads.i.f, on_i.t + p.loads.i.t};
    on_j = {on_j.f + p.loads.j.f, on_j.t + p.loads.j.t};
  }
  return sum;
}
