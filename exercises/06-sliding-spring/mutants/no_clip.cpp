// loses: limits slip slide_to_roll gross_sliding no_gain oblique_impact
// No limit: the contact sticks for ever.
#include "exercise.hpp"

Vec3 sliding_force(Vec3& us, const Contact& contact, double, double dt) {
  const Vec3 n = contact.n;
  const Vec3 flat = us - dot(us, n) * n;
  if (square(flat) > 0) us = (norm(us) / norm(flat)) * flat;                    // Eq. (52)
  else us = {0, 0, 0};
  us = us + dt * contact.vs;                                                    // Eq. (53)
  Vec3 fs = -(contact.ks * us) - contact.cs * contact.vs;                       // Eq. (6)
  return fs;
}
