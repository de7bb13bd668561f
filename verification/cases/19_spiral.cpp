// Orientation: the quaternions of the SPIRAL method, Eqs. (47)-(49).
//
// The rate of a quaternion that turns vectors of the body into the laboratory is q' = w q/2 with w
// in the frame of the laboratory. GSL integrates that for spins w(t) that are known exactly:
//   constant    no torque: q(t) is a rotation by |w| t
//   parallel    drag alone: w(t) = w0 exp(-gamma t); each step turns by dt w + dt^2/2 alpha
//   skew        a sphere that spins on a frictionless plate with rolling resistance only: the
//   torque
//               mur m g R is constant along -x while the sphere also spins about z
//   general     skew, with drag
#include "support.hpp"

using namespace verification;
typedef std::array<double, 4> Quaternion;

static Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
          p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]};
}
static Quaternion turn(double angle, const Vec3& axis) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * double(axis.x), s * double(axis.y), s * double(axis.z)};
}
static Quaternion orientation(const Simulation& sim) {
  const Particle a = sim.particles()[0];
  return {double(a.q[0]), double(a.q[1]), double(a.q[2]), double(a.q[3])};
}
static double size(const Quaternion& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}
/// Angle between two orientations [rad].
static double apart(const Quaternion& p, const Quaternion& q) {
  const Quaternion d = product({p[0], -p[1], -p[2], -p[3]}, q);
  return 2 * std::atan2(std::sqrt(d[1] * d[1] + d[2] * d[2] + d[3] * d[3]), std::abs(d[0]));
}
/// One step of any size with a spin that stays.
static void fast_spin(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "fast.csv", "angle_per_step_rad,error_rad");
  double worst = 0;
  const Vec3 axis{real(0.48), real(-0.6), real(0.64)};
  for (double angle = 1e-6; angle < 50; angle *= 1.3) {
    Simulation sim(scene("dt = 1e-3"), {}, {ball({}, 1, {}, real(angle / 1e-3) * axis)});
    sim.run(100);
    const double error = apart(orientation(sim), turn(100 * angle, axis));
    csv.row(angle, error), worst = std::max(worst, error / std::max(1.0, 100 * angle));
  }
  metrics("fast_spin", worst);
}
/// Two quarter turns, about x and then about y, axes of the laboratory.
static void two_axes(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "two_axes.csv", "scheme,steps,error_deg");
  const Vec3 x{1, 0, 0}, y{0, 1, 0};
  const Quaternion right = product(turn(pi / 2, y), turn(pi / 2, x));
  for (const std::string scheme : {"consistent", "paper"}) {
    double worst = 0;
    for (const long n : {1, 3, 10, 100, 1000}) {
      const Parameters p = scene("dt = 1e-3; scheme = " + scheme);
      const real spin = real(pi / 2 / (double(n) * double(p.dt)));
      Simulation first(p, {}, {ball({}, 1, {}, spin * x)});
      first.run(n);
      Particle a = first.particles()[0];
      a.w = spin * y;
      Simulation second(p, {}, {a});
      second.run(n);
      const double error = 180 / pi * apart(orientation(second), right);
      csv.row(scheme, n, error);
      worst = std::max(worst, scheme == "paper" ? std::abs(error - 120) : error);
    }
    metrics(scheme == "paper" ? "two_axes_paper_minus_120" : "two_axes", worst);
  }
}
static void norm_drift(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "norm.csv", "step,norm_minus_1");
  Simulation sim(scene("dt = 1e-3; mus = 0; mut = 0; mur = 0.1; eta = 1e-7; g = 0,0,-1"),
                 plate(1e6), {ball({0, 0, 1}, 1, {}, {30, -20, 10})});
  const long n = run.quick ? 100000 : 1000000;
  double worst = 0;
  for (long k = 0; k < 50; ++k) {
    sim.run(n / 50);
    const double drift = size(orientation(sim)) - 1;
    csv.row((k + 1) * n / 50, drift);
    worst = std::max(worst, std::abs(drift) / double((k + 1) * n / 50));
  }
  metrics("norm_drift_per_step", worst);
}

/// Spin of the examples: w(t) [1/s].
struct Example {
  std::string name;
  double eta, mur;
};
static const double R = 0.01, g = 10, E = 1e6, rho = 1000, nu = 0.3, end = 0.25;
static const double wx0 = 40, wz0 = 25;
static double drag_rate(double eta) { return 15 * eta / (rho * R * R); }  // Eqs. (3, 4)
static void spin(const Example& e, double t, double* w) {
  const double c = drag_rate(e.eta), decay = c > 0 ? std::exp(-c * t) : 1;
  const double alpha = 2.5 * e.mur * g / R;  // Eqs. (2, 32, 39): R* mur m g over 2/5 m R^2
  w[0] = c > 0 ? (wx0 + alpha / c) * decay - alpha / c : wx0 - alpha * t;
  w[1] = 0, w[2] = wz0 * decay;
}
static Quaternion reference(const Example& e) {
  Ode ode(
      [&](double t, const double* y, double* dy) {
        double w[3];
        spin(e, t, w);
        const Quaternion rate =
            product({0, w[0] / 2, w[1] / 2, w[2] / 2}, {y[0], y[1], y[2], y[3]});
        std::copy(rate.begin(), rate.end(), dy);
      },
      {1, 1, 1, 1});
  double t = 0;
  std::vector<double> y{1, 0, 0, 0};
  ode.advance(t, y, end);
  return {y[0], y[1], y[2], y[3]};
}
/// Error of the orientation at the end, over the step. The dashpot alone is beyond the limit of
/// rolling friction, so the torque is constant from the first step.
static void convergence(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "order.csv", "torque,scheme,dt_s,error_rad");
  Work work(run.out);
  const Example all[] = {{"parallel", 0.05, 0}, {"skew", 0, 0.03}, {"general", 0.03, 0.02}};
  for (const Example& e : all) {
    const Quaternion exact = reference(e);
    for (const std::string scheme : {"consistent", "paper"}) {
      std::vector<double> steps, errors;
      for (long n = 100; n <= (run.quick ? 3200 : 102400); n *= 2) {
        Parameters p = scene("mus = 0; mut = 0; g = 0,0,-10; scheme = " + scheme +
                             setting("mur", real(e.mur)) + setting("eta", real(e.eta)));
        p.dt = real(end / double(n));
        const double m = 4 * pi / 3 * rho * R * R * R;
        const double delta = std::pow(m * g * 3 * (1 - nu * nu) / (4 * E * std::sqrt(R)), 2.0 / 3);
        const Timer timer;
        Simulation sim = on_plate(p, real(R), {}, {real(wx0), 0, real(wz0)}, real(delta));
        sim.run(n);
        const double error = apart(orientation(sim), exact);
        csv.row(e.name, scheme, double(p.dt), error);
        if (e.name == "general")
          work(scheme, double(p.dt) / eq50(p, R), double(n), timer.seconds(), error);
        if (n >= 400) steps.push_back(double(p.dt)), errors.push_back(error);
      }
      const double expected = e.name == "skew" ? 2 : 1;
      if (scheme == "consistent")
        metrics("order_defect_" + e.name, std::abs(order(steps, errors) - expected));
      else if (e.name == "general") metrics("defect_paper", errors.back());
    }
  }
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  fast_spin(run, metrics);
  two_axes(run, metrics);
  norm_drift(run, metrics);
  convergence(run, metrics);
}
