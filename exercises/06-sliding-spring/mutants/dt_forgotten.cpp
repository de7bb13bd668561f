// loses: stick slip turning slide_to_roll oblique_impact
// The spring advances by v, not by dt v.
#include "exercise.hpp"

Vec3 sliding_force(Vec3& us, const Contact& contact, double mus, double) {
  const Vec3 n = contact.n;
  const Vec3 flat = us - dot(us, n) * n;
  if (square(flat) > 0) us = (norm(us) / norm(flat)) * flat;                    // Eq. (52)
  else us = {0, 0, 0};
  us = us + contact.vs;                                                         // Eq. (53)
  Vec3 fs = -(contact.ks * us) - contact.cs * contact.vs;                       // Eq. (6)
  const double limit = mus * std::abs(contact.fn);                              // Eq. (11)
  if (norm(fs) > limit) {
    fs = (limit / norm(fs)) * fs;                                               // Eq. (54)
    us = (-1 / contact.ks) * fs;                                                // Eq. (55)
  }
  return fs;
}
