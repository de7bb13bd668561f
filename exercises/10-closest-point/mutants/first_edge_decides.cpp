// loses: degenerate regions nothing_closer names brute_force
// The first edge that has p on its outer side: wrong at obtuse angles.
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
  if (inside(a, b) && inside(b, c) && inside(c, a)) return p - (dot(p - a, n) / square(n)) * n;
  if (!inside(a, b)) return closest_on_edge(p, a, b);
  if (!inside(b, c)) return closest_on_edge(p, b, c);
  return closest_on_edge(p, c, a);
}

Vec3 closest_on_rectangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3&,
                          const Vec3& d) {
  const Vec3 q = closest_on_edge(p, a, b);
  return closest_on_edge(p, q, q + (d - a));
}
