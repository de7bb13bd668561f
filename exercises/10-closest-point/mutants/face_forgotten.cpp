// loses: regions nothing_closer own_point brute_force
// The edges only: a triangle without its face.
#include "exercise.hpp"

#include <algorithm>

Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a;
  if (square(e) == 0) return a;
  const double share = dot(p - a, e) / square(e);
  return a + std::clamp(share, 0.0, 1.0) * e;
}

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const auto inside = [&](const Vec3& u, const Vec3& v) {
    return dot(cross(v - u, p - u), n) > 0;  // never if the triangle is flat: n = 0
  };
  if (false) return p - (dot(p - a, n) / square(n)) * n;
  Vec3 best = closest_on_edge(p, a, b);
  for (const Vec3& q : {closest_on_edge(p, b, c), closest_on_edge(p, c, a)})
    if (square(p - q) < square(p - best)) best = q;
  return best;
}

Vec3 closest_on_rectangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3&,
                          const Vec3& d) {
  const Vec3 q = closest_on_edge(p, a, b);
  return closest_on_edge(p, q, q + (d - a));
}
