// Exercise 08, written differently: one spring for both modes, a vector with both of them in it.
// The sum of a rolling and a twisting spring is one vector: the first part lies in the tangent
// plane, the second points along n. Each part is limited by itself.
#include "exercise.hpp"

namespace {
/// The part of a along the unit vector n, as a number, and the rest.
double up(const Vec3& a, const Vec3& n) { return a.x * n.x + a.y * n.y + a.z * n.z; }
Vec3 rest(const Vec3& a, const Vec3& n) {
  const double along = up(a, n);
  return {a.x - along * n.x, a.y - along * n.y, a.z - along * n.z};
}
/// At most `bound` as a share of `size`: 1 if it is less anyway.
double share(double size, double bound) { return size <= bound ? 1 : bound / size; }

/// A Kelvin-Voigt element of one friction mode.
struct Element {
  double k, c, bound;
};
}  // namespace

Spin relative_spin(const Contact& c, const Vec3& wi, const Vec3& wj) {
  const double x = wi.x - wj.x, y = wi.y - wj.y, z = wi.z - wj.z;
  const double r = c.ri / (1 + c.ri / c.rj);  // also where r_j is infinite
  return {{r * (y * c.n.z - z * c.n.y), r * (z * c.n.x - x * c.n.z), r * (x * c.n.y - y * c.n.x)},
          c.Rstar * (x * c.n.x + y * c.n.y + z * c.n.z)};
}

Vec3 resisting_torque(Springs& u, const Contact& c, const Spin& v, const Coefficients& mu,
                      double dt) {
  const Element roll{c.kn, c.cn, mu.mur * std::fabs(c.fn)};
  const Element twist{c.ks, c.cs, 2 * mu.mus * std::fabs(c.fn) / 3};

  const Vec3 laid = rest(u.ur, c.n);
  const double before = std::sqrt(square(u.ur)), after = std::sqrt(square(laid));
  const double longer = after > 0 ? before / after : 0;
  const Vec3 ur = longer * laid + dt * v.vr;
  const Vec3 against = roll.k * ur + roll.c * v.vr;
  const double sr = share(norm(against), roll.bound);
  u.ur = sr < 1 ? (sr / roll.k) * against : ur;

  const double ut = u.ut + dt * v.vt, back = twist.k * ut + twist.c * v.vt;
  const double st = share(std::fabs(back), twist.bound);
  u.ut = st < 1 ? st * back / twist.k : ut;

  return c.Rstar * (sr * cross(against, c.n) - (st * back) * c.n);
}
