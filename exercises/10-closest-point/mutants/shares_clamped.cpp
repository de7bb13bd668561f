// loses: regions nothing_closer names brute_force
// The shares of ab and ac are clamped one after the other.
#include "exercise.hpp"

#include <algorithm>

Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a;
  if (square(e) == 0) return a;
  const double share = dot(p - a, e) / square(e);
  return a + std::clamp(share, 0.0, 1.0) * e;
}

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 e = b - a, f = c - a;
  const double ee = square(e), ef = dot(e, f), ff = square(f), det = ee * ff - ef * ef;
  if (det == 0) {
    Vec3 best = closest_on_edge(p, a, b);
    for (const Vec3& q : {closest_on_edge(p, b, c), closest_on_edge(p, c, a)})
      if (square(p - q) < square(p - best)) best = q;
    return best;
  }
  const double s = (dot(p - a, e) * ff - dot(p - a, f) * ef) / det;
  const double t = (dot(p - a, f) * ee - dot(p - a, e) * ef) / det;
  const double u = std::clamp(s, 0.0, 1.0);
  return a + u * e + std::clamp(t, 0.0, 1 - u) * f;
}

Vec3 closest_on_rectangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3&,
                          const Vec3& d) {
  const Vec3 q = closest_on_edge(p, a, b);
  return closest_on_edge(p, q, q + (d - a));
}
