// Exercise 01, written differently: one power law, components by hand.
#include "exercise.hpp"

namespace {
double compliance(const Sphere& s) { return (1 - std::pow(s.nu, 2)) / s.E; }
}  // namespace

Vec3 hertz_force(const Sphere& i, const Sphere& j) {
  const double dx = i.x.x - j.x.x, dy = i.x.y - j.x.y, dz = i.x.z - j.x.z;
  const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
  const double overlap = (i.R + j.R) - distance;
  Vec3 force;
  if (overlap > 0) {
    const double radius = i.R * j.R / (i.R + j.R), modulus = compliance(i) + compliance(j);
    const double size = 4 * std::sqrt(radius) * std::pow(overlap, 1.5) / (3 * modulus);
    force.x = size * dx / distance;
    force.y = size * dy / distance;
    force.z = size * dz / distance;
  }
  return force;
}
