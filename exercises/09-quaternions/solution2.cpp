// Exercise 09, written differently: components, a rotation without quaternions, one rotation vector
// after the other.
#include <initializer_list>

#include "exercise.hpp"

Quaternion product(const Quaternion& p, const Quaternion& q) {
  const double a = p.s, b = p.v.x, c = p.v.y, d = p.v.z;
  const double e = q.s, f = q.v.x, g = q.v.y, h = q.v.z;
  Quaternion pq{};
  pq.s = a * e - b * f - c * g - d * h;
  pq.v.x = a * f + b * e + c * h - d * g;
  pq.v.y = a * g - b * h + c * e + d * f;
  pq.v.z = a * h + b * g - c * f + d * e;
  return pq;
}

Vec3 rotated(const Quaternion& q, const Vec3& a) {
  const double lengthwise = q.s * q.s - square(q.v);
  return lengthwise * a + (2 * dot(q.v, a)) * q.v + (2 * q.s) * cross(q.v, a);
}

Quaternion turned(const Quaternion& q, const Vec3& w, const Vec3& alpha, double dt) {
  Quaternion now = q;
  for (const Vec3& half : {(0.5 * dt) * w, (0.25 * dt * dt) * alpha}) {
    const double angle = std::sqrt(square(half));
    const double shrink = angle > 0 ? std::sin(angle) / angle : 1;
    now = product({std::cos(angle), shrink * half}, now);
  }
  return now;
}
