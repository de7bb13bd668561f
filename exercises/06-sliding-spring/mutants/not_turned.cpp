// loses: limits turning
// No Eq. (52) at all.
#include "exercise.hpp"

Vec3 sliding_force(Vec3& us, const Contact& contact, double mus, double dt) {
  us = us + dt * contact.vs;                                                    // Eq. (53)
  Vec3 fs = -(contact.ks * us) - contact.cs * contact.vs;                       // Eq. (6)
  const double limit = mus * std::abs(contact.fn);                              // Eq. (11)
  if (norm(fs) > limit) {
    fs = (limit / norm(fs)) * fs;                                               // Eq. (54)
    us = (-1 / contact.ks) * fs;                                                // Eq. (55)
  }
  return fs;
}
