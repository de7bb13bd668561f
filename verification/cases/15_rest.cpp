// A sphere at rest stays at rest: static friction of all three modes, under load and after a kick.
//
// Closed forms. On a plate tilted by less than the friction limits the springs carry the weight:
// fs = m g sin, and the torque balance r fs = R* fr with R* = R. So us = fs/ks and ur = (r/R)
// fs/kn; with v = vs + r w, vr = r w the centre has moved by us + ur, and the sphere has turned by
// ur/r. After a kick below the limits nothing slips and the springs come back to zero. They advance
// by dt v before the velocity changes, the centre by dt v after it, the angle by the mean of both:
// so the centre stays dt v0 behind, the angle dt w0/2, exactly. This vanishes with dt.
#include "support.hpp"

using namespace verification;

static const double R = 0.002,
                    g = 9.81;  // the smallest sphere of Table 2, the worst case for Eq. (50)

/// Static normal contact under the load m g cos: overlap and stiffnesses of Eqs. (12, 13).
struct Static {
  double m, delta, kn, ks;
  Static(const Parameters& p, double angle) {
    const double E = double(p.E), nu = double(p.nu);
    m = 4 * pi / 3 * double(p.rho) * R * R * R;
    const double K = 4 * E / (3 * (1 - nu * nu)) * std::sqrt(R);
    delta = std::pow(m * g * std::cos(angle) / K, 2.0 / 3);
    kn = K * std::sqrt(delta), ks = 8 * E / (2 * (2 - nu) * (1 + nu)) * std::sqrt(R * delta);
  }
};
static Parameters plate_scene(const std::string& scheme, double step, double angle = 0) {
  Parameters p = scene("mus = 0.4; mur = 0.4; scheme = " + scheme);
  p.dt *= real(step);
  p.g = {real(g * std::sin(angle)), 0, real(-g * std::cos(angle))};
  return p;
}
/// Angle of the rotation since the start about an axis (0, 1, 2 for x, y, z) [rad].
static double angle(const Particle& a, size_t axis) {
  return 2 * std::atan2(double(a.q[axis + 1]), double(a.q[0]));
}

/// A sphere on a plate that was tilted slowly, within 0.2 s, and has been still for another 0.3 s.
static Simulation tilted(const std::string& scheme, double tilt) {
  Parameters p = plate_scene(scheme, 1);
  Simulation sim = on_plate(p, real(R), {}, {}, real(Static(p, 0).delta));
  const long n = std::lround(0.2 / 100 / double(p.dt));
  for (double k = 1; k <= 100; ++k) {
    const double share = k / 100, eased = share * share * (3 - 2 * share);
    sim.p.g = plate_scene(scheme, 1, tilt * eased).g, sim.run(n);
  }
  sim.run(150 * n);
  return sim;
}
/// Place and angle of a sphere on a tilted plate against the closed form, over the angle.
static void deflection(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "deflection.csv",
          "angle_deg,shift_exact_m,shift_m,turn_exact_rad,turn_rad,spring_s_m,spring_r_m");
  double worst = 0, creep = 0, turn = 0;
  for (int degrees = 2; degrees <= 20; degrees += run.quick ? 9 : 2) {
    const double tilt = degrees * pi / 180;
    const Parameters p = plate_scene("consistent", 1, tilt);
    const Static s(p, tilt);
    const double r = R - s.delta / 2, fs = s.m * g * std::sin(tilt);
    const double us = fs / s.ks, ur = r / R * fs / s.kn;
    Simulation sim = tilted("consistent", tilt);
    const Particle a = sim.particles()[0];
    const auto contact = sim.contacts()[0];
    sim.run(std::lround((run.quick ? 1.0 : 10.0) / double(p.dt)));
    const Particle b = sim.particles()[0];
    const double measured[] = {double(a.x.x), double(contact.us.x), double(contact.ur.x)};
    const double exact[] = {us + ur, us, ur};
    turn = std::max(turn, std::abs(angle(a, 1) * r / ur - 1));
    for (int k = 0; k < 3; ++k)
      worst = std::max(worst, std::abs(measured[k] - exact[k]) / (us + ur));
    creep = std::max(creep, std::abs(double(b.x.x - a.x.x)) / R);
    csv.row(degrees, exact[0], measured[0], ur / r, angle(a, 1), measured[1], measured[2]);
  }
  metrics("deflection", worst);
  metrics("turn", turn);
  metrics("creep", creep);
}

/// A kick in one mode, far below its limit: velocity and spin per mode.
struct Kick {
  const char* mode;
  double v, wy, wz;
};
/// What moves at the end, as a surface speed.
static double motion(const Particle& a) {
  return std::sqrt(double(dot(a.v, a.v)) + R * R * double(dot(a.w, a.w)));
}
/// Speed left after a kick, over the step; where the sphere has gone to.
static void kicks(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "kicks.csv", "mode,scheme,dt_over_eq50,speed_left_m_s,away_m");
  Csv track(run.out / "track.csv", "scheme,t_s,turn_rad");
  const double size = 1e-4;  // surface speed [m/s]
  const Kick all[] = {
      {"slide and roll", size, 0, 0}, {"roll", size, size / R, 0}, {"twist", 0, 0, size / R}};
  double left = 0, away = 0, defect = 0;
  for (const Kick& k : all)
    for (const std::string scheme : {"consistent", "paper"})
      for (double step = 2; step > (run.quick ? 0.2 : 0.05); step /= 2) {
        const Parameters p = plate_scene(scheme, step);
        const Static s(p, 0);
        Simulation sim =
            on_plate(p, real(R), {real(k.v), 0, 0}, {0, real(k.wy), real(k.wz)}, real(s.delta));
        const bool draw = step == 1 && k.wz > 0;
        for (int n = 0; draw && n < 1000; ++n) {
          sim.run(2);
          track.row(scheme, double(sim.time()), angle(sim.particles()[0], 2));
        }
        sim.run(std::lround(1.0 / double(p.dt)));
        const Particle a = sim.particles()[0];
        const double expected = double(p.dt) * (k.v + R * k.wy / 2 + R * k.wz / 2);
        const double far =
            std::abs(double(a.x.x)) + R * std::abs(angle(a, 1)) + R * std::abs(angle(a, 2));
        csv.row(k.mode, scheme, step, motion(a), far);
        if (scheme == "paper" && step == 1) defect = std::max(defect, motion(a));
        if (scheme == "paper") continue;
        left = std::max(left, motion(a));
        away = std::max(away, std::abs(far / expected - 1));
      }
  metrics("speed_left", left / size);
  metrics("place_after_kick", away);
  metrics("defect_speed_paper", defect / size);
}
/// The plate is tilted at once: a damped oscillation of two coupled springs, without slip. Error of
/// the centre at 16 moments, over the static shift.
static void work(const Arguments& run, Metrics& metrics) {
  Work csv(run.out);
  const double tilt = 8 * pi / 180, moment = 4 * eq50(scene(""), R);
  const Parameters p0 = plate_scene("consistent", 1, tilt);
  const Static s(p0, tilt);
  const double r = R - s.delta / 2, I = 0.4 * s.m * R * R, fs0 = s.m * g * std::sin(tilt);
  const double logen = std::log(double(p0.en)), beta = 1 / std::sqrt(1 + pi * pi / (logen * logen));
  const double cn = beta * std::sqrt(5 * s.m * s.kn), cs = beta * std::sqrt(s.m * s.ks / 6);
  const double shift = fs0 / s.ks + r / R * fs0 / s.kn;
  Ode ode(
      [&](double, const double* y, double* dy) {  // y: x, v, R w, us, ur
        const double w = y[2] / R, vs = y[1] - r * w, fs = s.ks * y[3] + cs * vs;
        const double fr = s.kn * y[4] + cn * r * w;
        dy[0] = y[1], dy[1] = (fs0 - fs) / s.m, dy[2] = R * (r * fs - R * fr) / I;
        dy[3] = vs, dy[4] = r * w;
      },
      {shift, 1e-3, 1e-3, shift, shift});
  std::vector<double> exact, y(5), steps, errors;
  double t = 0;
  for (int k = 1; k <= 16; ++k) ode.advance(t, y, k * moment), exact.push_back(y[0]);
  for (const std::string scheme : {"consistent", "paper"})
    for (long n = 1; n <= (run.quick ? 256 : 4096); n *= 2) {  // steps per moment
      Parameters p = plate_scene(scheme, 4 / double(n), tilt);
      const Timer timer;
      Simulation sim = on_plate(p, real(R), {}, {}, real(s.delta));
      double error = 0;
      for (const double x : exact)
        sim.run(n), error = std::max(error, std::abs(double(sim.particles()[0].x.x) - x) / shift);
      csv(scheme, 4 / double(n), double(16 * n), timer.seconds(), error);
      if (scheme == "consistent" && n >= 16)
        steps.push_back(1 / double(n)), errors.push_back(error);
    }
  metrics("order_defect", std::abs(order(steps, errors) - 1));
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  deflection(run, metrics);
  kicks(run, metrics);
  work(run, metrics);
}
