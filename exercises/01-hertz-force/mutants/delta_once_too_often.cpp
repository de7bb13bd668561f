// loses: equal_spheres unequal_spheres elastic_impact power_law
// delta^(5/2): the exponent of the energy.
#include "exercise.hpp"

Vec3 hertz_force(const Sphere& i, const Sphere& j) {
  const Vec3 d = i.x - j.x;                                                     // Eq. (8)
  const double delta = i.R + j.R - norm(d);                                     // Eq. (7)
  if (delta <= 0) return {0, 0, 0};
  const Vec3 n = (1 / norm(d)) * d;                                             // Eq. (9)
  const double Estar = 1 / ((1 - i.nu * i.nu) / i.E + (1 - j.nu * j.nu) / j.E);  // Eq. (15)
  const double Rstar = 1 / (1 / i.R + 1 / j.R);                                 // Eq. (17)
  const double a = std::sqrt(Rstar * delta);                                    // Eq. (14)
  const double kn = 4.0 / 3.0 * Estar * a;                                      // Eq. (12)
  return (kn * delta * delta) * n;                                              // Eqs. (5, 10)
}
