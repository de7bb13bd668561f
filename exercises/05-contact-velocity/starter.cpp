// Exercise 05: velocity at the contact point. Write the function; README.md says what it does.
#include "exercise.hpp"

Meeting contact_velocity(const Sphere& i, const Sphere& j) {
  Meeting m{};
  // TODO: the direction n and the overlap delta, Eqs. (7)-(9)
  // TODO: the lever arms m.ri and m.rj, Eqs. (29), (30)
  // TODO: the relative velocity at the contact point, Eq. (26) with a plus
  // TODO: its parts m.vn along n, Eq. (27), and m.vs across, Eq. (28)
  (void)i, (void)j;  // not used yet: remove this line
  return m;
}
