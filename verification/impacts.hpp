// Impacts with the solver, to be set beside those of impact_reference.hpp.
#pragma once
#include "impact_reference.hpp"
#include "one_contact.hpp"
#include "support.hpp"

namespace verification {
const char* const schemes[] = {"consistent", "paper"};

inline reference::Triple triple(const Vec3& a) { return {double(a.x), double(a.y), double(a.z)}; }
inline Vec3 vec3(const reference::Triple& a) { return {real(a.x), real(a.y), real(a.z)}; }
inline reference::Matter matter(const Parameters& p) {
  return {double(p.E),   double(p.nu),  double(p.rho), double(p.en),
          double(p.mus), double(p.mur), double(p.mut)};
}
/// A sphere that hits the plate at `angle` from the normal, in the plane y = 0.
inline reference::Ball thrown(double R, double speed, double angle_deg) {
  const double angle = angle_deg * pi / 180;
  return {R, {speed * std::sin(angle), 0, -speed * std::cos(angle)}, {}};
}
/// What a sphere looks like after the reference impact on a plate.
struct Rebound {
  reference::Ball sphere;
  double duration;
};
inline Rebound reference_on_plate(const Parameters& p, const reference::Ball& in,
                                  double least = 1e-9) {
  reference::Impact impact(matter(p), in, {0, {}, {}}, {0, 0, 1});
  impact.least = least;
  impact.run();
  return {{in.R, impact.vi(), impact.wi()}, impact.t};
}
/// The same impact by the solver with step p.dt; `phase` in (0, 1] is the share of the step that
/// the sphere travels before it touches. The run is over when the bodies have parted.
inline Rebound solver_on_plate(const Parameters& p, const reference::Ball& in, double duration,
                               double phase = 1) {
  const double gap = -in.v.z * phase * double(p.dt);
  Simulation s = on_plate(p, real(in.R), vec3(in.v), vec3(in.w), real(-gap));
  const long chunk = long(1.05 * duration / double(p.dt)) + 4;
  s.run(chunk);
  for (int k = 0; k < 1000 && !s.contacts().empty(); ++k) s.run(chunk / 20 + 1);
  const Particle a = s.particles()[0];
  return {{in.R, triple(a.v), triple(a.w)}, double(chunk) * double(p.dt)};
}
/// The same by another integrator of the same contact law.
inline Rebound other_on_plate(const Parameters& p, const reference::Ball& in, double duration,
                              double phase, Method method) {
  OneContact<double> c(p, true);
  const double dt = double(p.dt);
  c.i = {
      {0, 0, in.R - in.v.z * phase * dt}, {in.v.x, in.v.y, in.v.z}, {in.w.x, in.w.y, in.w.z}, in.R};
  const long most = long(40 * duration / dt);
  for (long k = 0; k < most && (c.i.v.z < 0 || c.delta() > 0); ++k) c.step(method, dt);
  return {{in.R, {c.i.v.x, c.i.v.y, c.i.v.z}, {c.i.w.x, c.i.w.y, c.i.w.z}}, duration};
}
/// Error of the rebound: that of the velocity and, as the velocity R w of the surface, of the spin.
inline double rebound_error(const reference::Ball& a, const reference::Ball& b) {
  using namespace reference;
  const Triple v = a.v - b.v, w = a.R * (a.w - b.w);
  return std::sqrt(dot(v, v) + dot(w, w));
}
/// How much the reference depends on the instant of the first release after sliding has reversed,
/// which the model leaves open: the largest distance between three choices of it.
inline double ambiguity(const Parameters& p, const reference::Ball& in) {
  const Rebound first = reference_on_plate(p, in);
  double spread = 0;
  for (const double least : {1.7e-9, 1e-6})
    spread = std::max(spread, rebound_error(reference_on_plate(p, in, least).sphere, first.sphere));
  return spread;
}
/// Kinetic and rotational energy per mass.
inline double energy(const reference::Ball& a) {
  return reference::dot(a.v, a.v) / 2 + a.R * a.R * reference::dot(a.w, a.w) / 5;
}
}  // namespace verification
