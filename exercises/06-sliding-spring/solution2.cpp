// Exercise 06, written differently: components by hand, and one factor that is 1 in stick.
#include "exercise.hpp"

namespace {
/// Length of (x, y, z).
double length(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

/// The vector a without its part along the unit vector n, but as long as before.
Vec3 laid_down(Vec3 a, const Vec3& n) {
  const double before = length(a.x, a.y, a.z), up = a.x * n.x + a.y * n.y + a.z * n.z;
  a.x -= up * n.x, a.y -= up * n.y, a.z -= up * n.z;
  const double after = length(a.x, a.y, a.z);
  const double longer = after > 0 ? before / after : 0;
  return {longer * a.x, longer * a.y, longer * a.z};
}
}  // namespace

Vec3 sliding_force(Vec3& us, const Contact& contact, double mus, double dt) {
  const double k = contact.ks, c = contact.cs, most = mus * std::fabs(contact.fn);
  const Vec3 v = contact.vs, u = laid_down(us, contact.n);
  const double x = k * (u.x + v.x * dt) + c * v.x;
  const double y = k * (u.y + v.y * dt) + c * v.y;
  const double z = k * (u.z + v.z * dt) + c * v.z;
  const double trial = length(x, y, z);
  if (trial <= most) {
    us = {u.x + v.x * dt, u.y + v.y * dt, u.z + v.z * dt};
    return {-x, -y, -z};
  }
  const double share = most / trial;
  us = {share * x / k, share * y / k, share * z / k};
  return {-share * x, -share * y, -share * z};
}
