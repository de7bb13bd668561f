// Case 11: surfaces that do not slide on each other feel no friction. Two meshed gears (spins that
// cancel at the contact), and two spheres that turn about one axis like one body.
#include "impacts.hpp"

using namespace verification;

const double Ri = 0.004, Rj = 0.0097;  // m
const Vec3 n{0.48, 0.6, 0.64};         // from i to j, a unit vector
const Vec3 axis{10, -20, 50};          // 1/s

struct Pair {
  Particle i, j;
};
Pair after(const Simulation& s) {
  const auto all = s.particles();
  return {all[0], all[1]};
}
/// Two spheres with overlap delta that turn like gears; wrong = -1: like wheels on one road.
Pair gears(double delta, double wrong = 1) {
  const double ri = Ri - delta / 2, rj = Rj - delta / 2;
  const Vec3 spin = cross(n, axis), x = (Ri + Rj - delta) * n;
  return {ball({}, Ri, {}, rj / ri * spin), ball(x, Rj, {}, -wrong * spin)};
}
/// Two spheres that turn about the origin like one body.
Pair one_body(double delta) {
  const Vec3 x = (Ri + Rj - delta) * n;
  return {ball({}, Ri, {}, axis), ball(x, Rj, cross(axis, x), axis)};
}
/// Largest change of a spin in one step, relative to the change of the velocities over the smaller
/// radius: friction over normal force.
double friction_felt(const Parameters& p, const Pair& before) {
  Simulation s(p, {}, {before.i, before.j});
  s.run(1);
  const Pair now = after(s);
  const double push = norm(now.i.v - before.i.v) / Ri;
  return std::max(norm(now.i.w - before.i.w), norm(now.j.w - before.j.w)) / push;
}

/// Spins of equal meshed gears through a head-on impact: the lever arms stay equal, so no friction
/// may act at any time. Returns the largest relative change.
double impact_of_gears(Csv& csv, const std::string& scheme) {
  Simulation s(scene("mur = 0; Rmin = 0.004; scheme = " + scheme), {},
               {ball({}, Ri, n, cross(n, axis)), ball(1.95 * Ri * n, Ri, -n, -1 * cross(n, axis))});
  double worst = 0;
  for (int k = 0; k < 60; ++k) {
    const Pair now = after(s);
    const double change = norm(now.i.w - cross(n, axis)) / norm(cross(n, axis));
    worst = std::max(worst, change);
    csv.row(scheme, "impact of meshed gears", double(k) * double(s.p.dt), change);
    s.run(1);
  }
  return s.contacts().empty() ? worst : 1;
}
/// One step from many overlaps.
double worst_over_overlaps(Csv& csv, const std::string& scheme, bool meshed) {
  double worst = 0;
  const Parameters p = scene((meshed ? "mur = 0; scheme = " : "scheme = ") + scheme);
  for (double share = 0.001; share < 0.5; share *= 1.3) {
    const double delta = share * Ri;
    const double felt = friction_felt(p, meshed ? gears(delta) : one_body(delta));
    csv.row(scheme, meshed ? "meshed gears" : "one body", share, felt);
    worst = std::max(worst, felt);
  }
  return worst;
}
/// Two bodies that turn together carry their springs along, Eq. (52): a spring that leans out of
/// the tangent plane by some angle must be laid into it with its length. Largest relative error of
/// the sliding force -k_s u and of the rolling torque R* n x (-k_n u).
double turned_springs(Csv& csv) {
  double worst = 0;
  const double delta = Ri / 10, length = 1e-5;
  for (const char* scheme : schemes)
    for (double lean = 0; lean < 85; lean += 5) {
      OneContact<double> c(scene(std::string("mus = 1e9; mur = 1e9; scheme = ") + scheme), false);
      c.i = {(Ri + Rj - delta) * n, {}, {}, Ri}, c.j = {{}, {}, {}, Rj};
      const Vec3 along = 1 / norm(cross(n, axis)) * cross(n, axis);  // in the tangent plane
      const double a = lean * pi / 180;
      const Vec3 u = length * (std::cos(a) * along + std::sin(a) * n);
      const double E = double(c.p.E), nu = double(c.p.nu), Rstar = Ri * Rj / (Ri + Rj);
      const double area = std::sqrt(Rstar * delta);
      const double ks = 2 * E / ((2 - nu) * (1 + nu)) * area,
                   kn = 2 * E / (3 * (1 - nu * nu)) * area;
      c.u = {u, {}, 0};
      const double sliding = norm(c.look().fs + ks * length * along) / (ks * length);
      c.u = {{}, u, 0};
      const Vec3 torque = -Rstar * kn * length * cross(n, along);
      const double rolling = norm(c.look().ti - torque) / norm(torque);
      csv.row(scheme, lean, sliding, rolling);
      worst = std::max({worst, sliding, rolling});
    }
  return worst;
}

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  Metrics metrics(arguments.out);
  Csv overlaps(arguments.out / "overlaps.csv", "scheme,motion,overlap_over_R,friction_felt");
  Csv impact(arguments.out / "impact.csv", "scheme,motion,time_s,spin_change");
  double gear = 0, body = 0, hit = 0;
  for (const char* scheme : schemes) {
    gear = std::max(gear, worst_over_overlaps(overlaps, scheme, true));
    body = std::max(body, worst_over_overlaps(overlaps, scheme, false));
    hit = std::max(hit, impact_of_gears(impact, scheme));
  }
  metrics("gears", gear), metrics("one_body", body), metrics("impact", hit);
  Csv springs(arguments.out / "springs.csv", "scheme,lean_deg,sliding,rolling");
  metrics("turned_springs", turned_springs(springs));
  const Parameters p = scene("mur = 0");
  for (double share = 0.001; share < 0.5; share *= 1.3)
    overlaps.row("consistent", "wheels that rub", share, friction_felt(p, gears(share * Ri, -1)));
  metrics("wheels_that_rub", friction_felt(p, gears(Ri / 10, -1)));
}
