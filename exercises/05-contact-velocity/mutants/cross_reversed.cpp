// loses: with_spin turning_together rolling marks
// The factors of the vector product are swapped.
#include "exercise.hpp"

Meeting contact_velocity(const Sphere& i, const Sphere& j) {
  const Vec3 d = i.x - j.x;                                                     // Eq. (8)
  const double delta = i.R + j.R - norm(d);                                     // Eq. (7)
  const Vec3 n = (1 / norm(d)) * d;                                             // Eq. (9)
  Meeting m{};
  m.ri = i.R - delta / 2;                                                       // Eq. (29)
  m.rj = j.R - delta / 2;                                                       // Eq. (30)
  const Vec3 v = i.v - j.v + cross(m.ri * i.w + m.rj * j.w, n);                 // Eq. (26)
  m.vn = dot(v, n);                                                             // Eq. (27)
  m.vs = v - m.vn * n;                                                          // Eq. (28)
  return m;
}
