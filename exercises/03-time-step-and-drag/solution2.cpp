// Exercise 03, written differently: forces and torques of the fluid, Stokes' formulas themselves.
#include "exercise.hpp"

namespace {
Vec3 friction_of_fluid(const Vec3& v, double R, double eta) { return (-6 * pi * eta * R) * v; }
Vec3 spin_friction(const Vec3& w, double R, double eta) { return (-8 * pi * eta * R * R * R) * w; }
}  // namespace

Motion step(const Motion& old, const Vec3& f, const Vec3& t, const Grain& grain,
            const Surroundings& around, double dt) {
  const double volume = 4 * pi * std::pow(grain.R, 3) / 3, mass = grain.rho * volume;
  const double inertia = 0.4 * mass * std::pow(grain.R, 2);
  const Vec3 force = f + mass * around.g + friction_of_fluid(old.v, grain.R, around.eta);
  const Vec3 torque = t + spin_friction(old.w, grain.R, around.eta);
  const Vec3 v = old.v + (dt / mass) * force;
  return {old.x + dt * v, v, old.w + (dt / inertia) * torque};
}
