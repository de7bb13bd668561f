// A sphere on an incline: when does it rest, roll, slip, and how fast does it accelerate?
//
// Closed form, with r = R - delta/2 and delta from m g cos = kn delta (Eqs. 5, 12, 29): let the
// sphere roll without slip, a = r alpha. Then m a = m g sin - fs and 2/5 m R^2 alpha = r fs - R mur
// m g cos:
//   a_roll = g (sin - R/r mur cos) / (1 + 0.4 R^2/r^2).
// It rests where that is not positive and tan <= mus; it slips where fs = m (g sin - a_roll)
// exceeds mus m g cos; then a = g (sin - mus cos), alpha = 2.5 g cos/R (mus r/R - mur), or 0 if
// negative.
#include "support.hpp"

using namespace verification;

struct Slope {
  double mus, mur, angle;  // [rad]
};
struct Answer {
  double a, alpha;  // steady accelerations [m/s^2, 1/s^2]
  const char* regime;
};
struct Sphere {  // of every incline here
  double R = 0.005, g = 9.81, E = 1e6, nu = 0.3, rho = 1000;
  double delta(double angle) const {
    const double m = 4 * pi / 3 * rho * R * R * R, K = 4 * E / (3 * (1 - nu * nu)) * std::sqrt(R);
    return std::pow(m * g * std::cos(angle) / K, 2.0 / 3);
  }
};
static const Sphere sphere;

static Answer closed_form(const Slope& s) {
  const double R = sphere.R, r = R - sphere.delta(s.angle) / 2, g = sphere.g;
  const double sine = std::sin(s.angle), cosine = std::cos(s.angle);
  const double roll = g * (sine - R / r * s.mur * cosine) / (1 + 0.4 * R * R / (r * r));
  if (roll <= 0 && sine <= s.mus * cosine) return {0, 0, "rest"};
  if (g * sine - std::max(roll, 0.0) <= s.mus * g * cosine) return {roll, roll / r, "roll"};
  return {g * (sine - s.mus * cosine), 2.5 * g * cosine / R * std::max(0.0, s.mus * r / R - s.mur),
          "slip"};
}
/// Time steps as a share of Eq. (50), scheme.
struct Method {
  std::string scheme;
  double step;
};
struct Measured {
  double a, alpha;  // [m/s^2, 1/s^2]
  long steps;
};
/// Gravity seen by an inclined plate.
static Vec3 gravity(double angle) {
  return {real(sphere.g * std::sin(angle)), 0, real(-sphere.g * std::cos(angle))};
}
static Simulation resting(const Slope& s, const Method& m, double tilt) {
  Parameters p = scene("Rmin = 0.005; scheme = " + m.scheme + setting("mus", real(s.mus)) +
                       setting("mur", real(s.mur)));
  p.dt *= real(m.step), p.g = gravity(tilt);
  return on_plate(p, real(sphere.R), {}, {}, real(sphere.delta(tilt)));
}
/// Released from rest at the static overlap; accelerations are means over the last 0.05 s of 0.5 s,
/// when the oscillations of the springs have died out.
static Measured measure(const Slope& s, const Method& m) {
  Simulation sim = resting(s, m, s.angle);
  const long n = std::lround(0.05 / double(sim.p.dt)), all = std::lround(0.5 / double(sim.p.dt));
  sim.run(all - n);
  const Particle a = sim.particles()[0];
  sim.run(n);
  const Particle b = sim.particles()[0];
  const double t = double(n) * double(sim.p.dt);
  return {double(b.v.x - a.v.x) / t, double(b.w.y - a.w.y) / t, all};
}
/// The plate is tilted slowly, within 0.3 s, so that no oscillation reaches the limit before the
/// static load does. Does the sphere move (or slip) 0.1 s later?
static bool moves(const Slope& s, bool slipping) {
  Simulation sim = resting(s, {"consistent", 1}, 0);
  const long n = std::lround(0.3 / 200 / double(sim.p.dt));
  for (double k = 1; k <= 200; ++k) {
    const double share = k / 200, eased = share * share * (3 - 2 * share);
    sim.p.g = gravity(s.angle * eased), sim.run(n);
  }
  sim.run(std::lround(0.1 / double(sim.p.dt)));
  const Particle a = sim.particles()[0];
  const double r = sphere.R - sphere.delta(s.angle) / 2;
  return std::abs(double(a.v.x) - (slipping ? r * double(a.w.y) : 0)) > 1e-5;
}
/// The tangent between low and high where `moved` starts to hold.
template <class F> static double threshold(double low, double high, F moved) {
  for (int k = 0; k < 18; ++k) {
    const double middle = (low + high) / 2;
    (moved(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

static void accelerations(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "accelerations.csv",
          "mu_s,mu_r,angle_deg,regime,a_exact_m_s2,alpha_exact_1_s2,scheme,a_m_s2,alpha_1_s2");
  double worst[2] = {0, 0};
  for (const double mur : {0.0, 0.1, 0.2, 0.6})
    for (int degrees = 2; degrees <= 62; degrees += run.quick ? 10 : 3)
      for (const int paper : {0, 1}) {
        const Slope s{0.3, mur, degrees * pi / 180};
        const Answer e = closed_form(s);
        const Measured a = measure(s, {paper ? "paper" : "consistent", 1});
        const double scale = sphere.g, turn = sphere.g / sphere.R;
        worst[paper] = std::max(
            {worst[paper], std::abs(a.a - e.a) / scale, std::abs(a.alpha - e.alpha) / turn});
        csv.row(s.mus, mur, degrees, e.regime, e.a, e.alpha, paper ? "paper" : "consistent", a.a,
                a.alpha);
      }
  metrics("acceleration_consistent", worst[0]);
  metrics("defect_acceleration_paper", worst[1]);
}
static void thresholds(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "thresholds.csv", "kind,mu_s,mu_r,tan_exact,tan_measured");
  double worst = 0;
  const auto record = [&](const char* kind, const Slope& s, double tangent) {
    const auto moved = [&](double t) {
      return moves({s.mus, s.mur, std::atan(t)}, kind[0] == 's');
    };
    const double measured = threshold(tangent / 2, tangent * 1.5, moved);
    csv.row(kind, s.mus, s.mur, tangent, measured);
    worst = std::max(worst, std::abs(measured - tangent));
  };
  for (const double mus : {0.2, 0.5})
    for (const double mur : {0.05, 0.1, 0.3, 0.6}) {
      if (run.quick && mus * mur != 0.2 * 0.3 && mus * mur != 0.5 * 0.1) continue;
      // the closed form says where; r depends on the angle, hence the search in it
      const auto regime = [&](double t) { return closed_form({mus, mur, std::atan(t)}).regime; };
      const double rest = threshold(0, 3, [&](double t) { return regime(t)[1] != 'e'; });
      record("rest ends", {mus, mur, 0}, rest);
      const double slip = threshold(0, 3, [&](double t) { return regime(t)[0] == 's'; });
      if (slip > 1.01 * rest) record("slip begins", {mus, mur, 0}, slip);
    }
  metrics("threshold_tangent", worst);
}
/// Error of the steady accelerations over the time step; one slope of each regime.
static void work(const Arguments& run, Metrics& metrics) {
  Work csv(run.out);
  Csv each(run.out / "steps.csv", "method,regime,dt_over_eq50,error");
  const Slope slopes[] = {
      {0.3, 0.3, std::atan(0.2)}, {0.3, 0.1, std::atan(0.4)}, {0.3, 0.1, std::atan(1.2)}};
  for (const std::string& scheme : {std::string("consistent"), std::string("paper")})
    for (double step = 4; step > (run.quick ? 0.2 : 0.005); step /= 2) {
      double worst = 0;
      long count = 0;
      const Timer clock;
      for (const Slope& s : slopes) {
        const Answer e = closed_form(s);
        const Measured a = measure(s, {scheme, step});
        const double error = std::max(std::abs(a.a - e.a) / sphere.g,
                                      std::abs(a.alpha - e.alpha) * sphere.R / sphere.g);
        each.row(scheme, e.regime, step, error);
        worst = std::max(worst, error), count += a.steps;
      }
      csv(scheme, step, double(count), clock.seconds(), worst);
      if (scheme == "paper" && step == 0.25) metrics("acceleration_paper_quarter_step", worst);
    }
}

int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  accelerations(run, metrics);
  thresholds(run, metrics);
  work(run, metrics);
}
