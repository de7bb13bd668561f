// Writes the table OBLIQUE of reference.py: impacts of a sphere on a plate, integrated by GSL, as
// in verification case 08. From this folder:
//
//   g++ -std=c++17 -O2 -I../../verification oblique.cpp -o oblique -lgsl -lgslcblas && ./oblique
//
// A line holds e_n, mu, the angle in degrees, and after the impact v_t and R w, over the speed
// before it; E = 1 MPa, nu = 0.3, rho = 1000 kg/m^3, R = 1 cm, 1 m/s. Impacts for which the model
// has more than one answer are left out (there are none here). Four more are not in the table:
// their errors fall with the step as well, but not evenly.
#include <cstdio>

#include "impact_reference.hpp"

using namespace reference;

int main() {
  const double pi = std::acos(-1.0), R = 0.01;
  for (const double en : {0.6, 1.0})
    for (const double mu : {0.1, 0.3})
      for (int angle = 10; angle < 90; angle += 10) {
        const double sin = std::sin(angle * pi / 180), cos = std::cos(angle * pi / 180);
        Ball first{}, out{};
        double open = 0;  // the model leaves open when a reversed slip is released: by how much?
        for (const double least : {1e-9, 1.7e-9, 1e-7, 1e-6, 1e-5}) {
          Impact impact({1e6, 0.3, 1000, en, mu, 0, 0}, {R, {sin, 0, -cos}, {}}, {0}, {0, 0, 1});
          impact.least = least;
          impact.run();
          out = {R, impact.vi(), impact.wi()};
          if (open == 0) first = out, open = 1e-12;
          open = std::max(open, norm(out.v - first.v) + R * norm(out.w - first.w));
        }
        if (open > 1e-4) continue;
        std::printf("    (%g, %g, %d, %.9f, %.9f),\n", en, mu, angle, first.v.x, -R * first.w.y);
      }
}
