// Case 27: the reference for the oblique impacts that the solver and LAMMPS both compute: the
// stick-slip reference of impact_reference.hpp, sliding friction only. 27_lammps.py does the rest.
#include "impacts.hpp"

using namespace verification;

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  const Parameters p = scene("en = 0.5; mus = 0.3; mur = 0; mut = 0; Rmin = 0.01");
  Csv csv(arguments.out / "reference.csv", "angle_deg,vx,vz,wy");
  for (int angle = 0; angle < 89; angle += 5) {
    const reference::Ball b = reference_on_plate(p, thrown(0.01, 1, angle)).sphere;
    csv.row(angle, b.v.x, b.v.z, b.w.y);
  }
}
