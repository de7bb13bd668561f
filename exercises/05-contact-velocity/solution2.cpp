// Exercise 05, written differently: the velocities of two material points at the contact.
#include "exercise.hpp"

namespace {
/// Velocity of the point p of a rigid body.
Vec3 velocity_at(const Sphere& body, const Vec3& p) { return body.v + cross(body.w, p - body.x); }
}  // namespace

Meeting contact_velocity(const Sphere& i, const Sphere& j) {
  const double distance = norm(i.x - j.x);
  const double ri = (distance + i.R - j.R) / 2, rj = distance - ri;
  const Vec3 line = {(i.x.x - j.x.x) / distance, (i.x.y - j.x.y) / distance,
                     (i.x.z - j.x.z) / distance};
  const Vec3 point = j.x + rj * line;
  const Vec3 u = velocity_at(i, point) - velocity_at(j, point);
  const double along = u.x * line.x + u.y * line.y + u.z * line.z;
  return {ri, rj, along, cross(line, cross(u, line))};
}
