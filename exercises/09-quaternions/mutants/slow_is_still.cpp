// loses: at_rest
// A tolerance: slow rotations are left out.
#include "exercise.hpp"

Quaternion product(const Quaternion& p, const Quaternion& q) {                  // Eq. (49)
  return {p.s * q.s - dot(p.v, q.v), p.s * q.v + q.s * p.v + cross(p.v, q.v)};
}

Vec3 rotated(const Quaternion& q, const Vec3& a) {
  const Quaternion back = {q.s, -q.v};
  return product(product(q, {0, a}), back).v;
}

namespace {
/// A rotation about `axis` by twice `half`.
Quaternion rotation(double half, const Vec3& axis) {
  if (norm(axis) < 1e-8) return {1, {0, 0, 0}};
  return {std::cos(half), (std::sin(half) / norm(axis)) * axis};
}
}  // namespace

Quaternion turned(const Quaternion& q, const Vec3& w, const Vec3& alpha, double dt) {
  const Quaternion phi = rotation(dt / 2 * norm(w), w);                         // Eq. (48)
  const Quaternion theta = rotation(dt / 2 * dt / 2 * norm(alpha), alpha);      // Eq. (48)
  return product(theta, product(phi, q));                                       // Eq. (47) [D3]
}
