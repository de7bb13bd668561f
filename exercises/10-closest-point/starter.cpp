// Exercise 10: closest points. Write the three functions; README.md says what they have to do.
#include "exercise.hpp"

Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  // TODO: the foot of p on the line through a and b, but not beyond its ends
  (void)p, (void)a, (void)b;  // not used yet: remove this line
  return {0, 0, 0};
}

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  // TODO: is the foot of p on the plane inside the triangle? Else it is on one of the three edges
  (void)p, (void)a, (void)b, (void)c;  // not used yet: remove this line
  return {0, 0, 0};
}

Vec3 closest_on_rectangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d) {
  // TODO: the two directions are independent of each other
  (void)p, (void)a, (void)b, (void)c, (void)d;  // not used yet: remove this line
  return {0, 0, 0};
}
