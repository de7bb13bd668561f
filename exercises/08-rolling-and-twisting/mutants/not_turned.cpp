// loses: limits rolling
// No Eq. (52) at all.
#include "exercise.hpp"

Spin relative_spin(const Contact& c, const Vec3& wi, const Vec3& wj) {
  const Vec3 w = wi - wj;                                                       // Eq. (38)
  const double r = 1 / (1 / c.ri + 1 / c.rj);
  return {r * cross(w, c.n), c.Rstar * dot(w, c.n)};                            // Eqs. (36, 37)
}

Vec3 resisting_torque(Springs& u, const Contact& c, const Spin& v, const Coefficients& mu,
                      double dt) {
  u.ur = u.ur + dt * v.vr;                                                      // Eq. (53)
  u.ut = u.ut + dt * v.vt;
  Vec3 fr = -(c.kn * u.ur) - c.cn * v.vr;                                       // Eq. (34)
  double ft = -c.ks * u.ut - c.cs * v.vt;                                       // Eq. (35)
  const double load = std::abs(c.fn);
  const double most_r = mu.mur * load;                                          // Eq. (39)
  const double most_t = 2.0 / 3 * mu.mus * load;                                // Eqs. (40, 41)
  if (norm(fr) > most_r) {
    fr = (most_r / norm(fr)) * fr;                                              // Eq. (54)
    u.ur = (-1 / c.kn) * fr;                                                    // Eq. (55)
  }
  if (std::abs(ft) > most_t) {
    ft = std::copysign(most_t, ft);                                             // Eq. (54)
    u.ut = -ft / c.ks;                                                          // Eq. (55)
  }
  return c.Rstar * cross(c.n, fr) + (c.Rstar * ft) * c.n;                       // Eqs. (32, 33)
}
