// loses: stick slip turning slide_to_roll gross_sliding no_gain oblique_impact
// Eqs. (53)-(55) as printed: advanced afterwards, in static steps only; dashpot in the reset.
#include "exercise.hpp"

Vec3 sliding_force(Vec3& us, const Contact& contact, double mus, double dt) {
  const Vec3 n = contact.n;
  const Vec3 flat = us - dot(us, n) * n;
  if (square(flat) > 0) us = (norm(us) / norm(flat)) * flat;                    // Eq. (52)
  else us = {0, 0, 0};
  Vec3 fs = -(contact.ks * us) - contact.cs * contact.vs;                       // Eq. (6)
  const double limit = mus * std::abs(contact.fn);                              // Eq. (11)
  if (norm(fs) > limit) {
    fs = (limit / norm(fs)) * fs;                                               // Eq. (54)
    us = (-1 / contact.ks) * (fs + contact.cs * contact.vs);                    // Eq. (55)
  } else us = us + dt * contact.vs;                                             // Eq. (53)
  return fs;
}
