// loses: linear_motion spin terminal_velocity decay order
// R where Eq. (3) has R^2.
#include "exercise.hpp"

Motion step(const Motion& old, const Vec3& f, const Vec3& t, const Grain& grain,
            const Surroundings& around, double dt) {
  const double R = grain.R;
  const double m = 4.0 / 3.0 * pi * grain.rho * R * R * R;
  const double I = 2.0 / 5.0 * m * R * R;
  const double c = 9 * around.eta / (2 * grain.rho * R);                    // Eq. (3)
  const double gamma = 10.0 / 3.0 * c;                                          // Eq. (4)
  const Vec3 a = (1 / m) * f + around.g - c * old.v;                            // Eq. (42)
  const Vec3 alpha = (1 / I) * t - gamma * old.w;                               // Eq. (43)
  Motion now;
  now.v = old.v + dt * a;                                                       // Eq. (44)
  now.x = old.x + dt * now.v;                                                   // Eq. (45)
  now.w = old.w + dt * alpha;                                                   // Eq. (46)
  return now;
}
