// Exercise 10, written differently: shares of the sides; the triangle asks for the region of p, one
// after the other, with products of p with the sides.
#include "exercise.hpp"

#include <cmath>

namespace {
/// x / y, between 0 and 1; 0 where y is 0.
double part(double x, double y) {
  if (!(y > 0) || x <= 0) return 0;
  return x < y ? x / y : 1;
}
Vec3 mix(const Vec3& a, double s, const Vec3& ab) {
  return {a.x + s * ab.x, a.y + s * ab.y, a.z + s * ab.z};
}
}  // namespace

Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  return mix(a, part(dot(ab, p - a), dot(ab, ab)), ab);
}

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  // p - a = s ab + t ac + something perpendicular: two equations for s and t.
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac);
  const double pb = dot(ap, ab), pc = dot(ap, ac), det = bb * cc - bc * bc;
  const double s = pb * cc - pc * bc, t = pc * bb - pb * bc;  // times det
  if (det > 0 && s >= 0 && t >= 0 && s + t <= det) return mix(mix(a, s / det, ab), t / det, ac);
  Vec3 found = closest_on_edge(p, a, b);
  double least = norm(found - p);
  const auto compete = [&](const Vec3& q) {
    const double distance = norm(q - p);
    if (distance < least) found = q, least = distance;
  };
  compete(closest_on_edge(p, a, c));
  compete(closest_on_edge(p, b, c));
  return found;
}

Vec3 closest_on_rectangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3&,
                          const Vec3& d) {
  const Vec3 ab = b - a, ad = d - a, ap = p - a;
  return mix(mix(a, part(dot(ap, ab), dot(ab, ab)), ab), part(dot(ap, ad), dot(ad, ad)), ad);
}
