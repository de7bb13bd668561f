// Spheres on top of each other: overlaps under the weight above, and an oscillation between two
// plates.
//
// Statics: a contact that carries the weight W has the overlap (W/K)^(2/3), K = 4/3 E* sqrt(R*).
// Dynamics (MFIX DEM03 with Hertz's force): two spheres between plates that are closer than two
// diameters. With l, m, u for lower plate, middle, upper plate, every contact pushes with
// K d^(3/2) + beta sqrt(5 m* K) d^(1/4) d', Eqs. (5, 12, 18), where d' is the rate of the overlap
// d.
#include "support.hpp"

using namespace verification;

static double hertz(const Parameters& p, double Rstar, bool wall) {
  const double nu = double(p.nu);
  return 4 * double(p.E) / (3 * (wall ? 1 : 2) * (1 - nu * nu)) * std::sqrt(Rstar);
}
/// n spheres whose radii alternate, each at its static overlap times `share`.
static std::vector<Particle> tower(const Parameters& p, int n, double share,
                                   std::vector<double>& overlaps) {
  std::vector<double> R, weight;
  for (int k = 0; k < n; ++k) {
    R.push_back(k % 2 ? 0.004 : 0.005);
    weight.push_back(4 * pi / 3 * double(p.rho) * std::pow(R.back(), 3) * -double(p.g.z));
  }
  for (int k = n - 2; k >= 0; --k) weight[size_t(k)] += weight[size_t(k) + 1];
  std::vector<Particle> all;
  double z = 0;
  for (size_t k = 0; k < R.size(); ++k) {
    const double Rstar = k ? R[k] * R[k - 1] / (R[k] + R[k - 1]) : R[k];
    overlaps.push_back(std::pow(weight[k] / hertz(p, Rstar, k == 0), 2.0 / 3));
    z += (k ? R[k - 1] : 0) + R[k] - share * overlaps[k];
    all.push_back(ball({0, 0, real(z)}, real(R[k])));
  }
  return all;
}
static void statics(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "overlaps.csv", "spheres,contact,overlap_exact_m,overlap_m");
  double worst = 0, apart = 0;
  for (const int n : {1, 2, 5, 10, 20, 50, 100}) {
    if (run.quick && n > 20) continue;
    std::vector<double> top[2];
    for (const int paper : {0, 1}) {
      const Parameters p = scene(std::string("g = 0,0,-9.81; Rmin = 0.004; eta = 0.25; scheme = ") +
                                 (paper ? "paper" : "consistent"));
      std::vector<double> exact;
      const std::vector<Particle> start = tower(p, n, 0.95, exact);
      Simulation sim(p, plate(1), tinydem::vector<Particle>(start));
      sim.run(std::lround(2.0 / double(p.dt)));
      const auto end = sim.particles();
      double below = 0, R_below = 0;
      for (int k = 0; k < n; ++k) {
        const double z = double(end[k].x.z), R = double(end[k].R);
        const double overlap = (k ? R_below : 0) + R - (z - below);
        if (!paper) csv.row(n, k, exact[size_t(k)], overlap);
        worst = std::max(worst, std::abs(overlap / exact[size_t(k)] - 1));
        below = z, R_below = R, top[paper].push_back(z);
      }
    }
    for (size_t k = 0; k < top[0].size(); ++k)
      apart = std::max(apart, std::abs(top[0][k] - top[1][k]));
  }
  metrics("overlap", worst);
  metrics("schemes_apart", apart);
}

static const double R = 0.0005, gap = 0.0018;  // MFIX DEM03: d = 1 mm, plates 3.6 R apart
static Parameters press(double en, const std::string& scheme) {
  return scene("Rmin = 0.0005; rho = 20000; g = 0,0,-9.81; scheme = " + scheme +
               setting("en", real(en)));
}
/// The heights of both spheres at equally spaced moments in 10 ms, by GSL.
static std::vector<double> reference(double en, int moments) {
  const Parameters p = press(en, "consistent");
  const double m = 4 * pi / 3 * double(p.rho) * R * R * R, logen = std::log(en);
  const double beta = en < 1 ? 1 / std::sqrt(1 + pi * pi / (logen * logen)) : 0;
  const auto push = [&](double d, double rate, bool wall) {
    const double K = hertz(p, wall ? R : R / 2, wall), mstar = wall ? m : m / 2;
    return d > 0 ? K * std::pow(d, 1.5) + beta * std::sqrt(5 * mstar * K) * std::pow(d, 0.25) * rate
                 : 0;
  };
  Ode ode(
      [&](double, const double* y, double* dy) {  // y: heights, velocities
        const double lower = push(R - y[0], -y[2], true);
        const double middle = push(2 * R - (y[1] - y[0]), y[2] - y[3], false);
        const double upper = push(R - (gap - y[1]), y[3], true);
        dy[0] = y[2], dy[1] = y[3];
        dy[2] = (lower - middle) / m - 9.81, dy[3] = (middle - upper) / m - 9.81;
      },
      {R, R, 1, 1});
  std::vector<double> y{0.9 * R, 2.7 * R, 0, 0}, heights;
  double t = 0;
  for (int k = 1; k <= moments; ++k) {
    ode.advance(t, y, k * 0.01 / moments);
    heights.push_back(y[0]), heights.push_back(y[1]);
  }
  return heights;
}
/// Two spheres between the plates z = 0 and z = gap; n steps in each of 50 intervals.
static std::vector<double> solver(const Parameters& p, long n) {
  Mesh mesh = plate(1), lid = plate(1);
  for (Vec3& a : lid.vertices) a.z = real(gap), mesh.vertices.push_back(a);
  mesh.elements.push_back({4, {4, 5, 6, 7}, 0});
  Simulation sim(p, mesh,
                 {ball({0, 0, real(0.9 * R)}, real(R)), ball({0, 0, real(2.7 * R)}, real(R))});
  std::vector<double> heights;
  for (int k = 0; k < 50; ++k) {
    sim.run(n);
    for (const Particle& a : sim.particles()) heights.push_back(double(a.x.z));
  }
  return heights;
}
static void dynamics(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "press.csv", "en,t_s,lower_m,upper_m");
  Csv fine(run.out / "press_exact.csv", "en,t_s,lower_m,upper_m");
  Csv errors(run.out / "press_errors.csv", "en,dt_over_eq50,error");
  Work work(run.out);
  for (const double en : {1.0, 0.5}) {
    const std::vector<double> exact = reference(en, 50), curve = reference(en, 1000);
    double range = 0;  // of the motion
    for (size_t k = 0; k < curve.size(); k += 2) {
      fine.row(en, 5e-6 * double(k + 2), curve[k], curve[k + 1]);
      range = std::max(range, std::abs(curve[k] - 0.9 * R));
    }
    std::vector<double> steps, error;
    for (const std::string scheme : {"consistent", "paper"})
      for (long n = 2; n <= (run.quick ? 256 : 4096); n *= 2) {
        Parameters p = press(en, scheme);
        const double step = 0.0002 / double(n) / eq50(p, R);
        p.dt = real(0.0002 / double(n));
        const Timer timer;
        const std::vector<double> z = solver(p, n);
        double worst = 0;
        for (size_t k = 0; k < z.size(); ++k)
          worst = std::max(worst, std::abs(z[k] - exact[k]) / range);
        if (en < 1) work(scheme, step, 150 * double(n), timer.seconds(), worst);
        if (scheme == "paper") continue;
        errors.row(en, step, worst);
        for (size_t k = 0; n == 4 && k < z.size(); k += 2)
          csv.row(en, 0.0001 * double(k + 2), z[k], z[k + 1]);
        if (n == 64) metrics(en < 1 ? "press_damped" : "press_elastic", worst);
        if (n >= 32) steps.push_back(step), error.push_back(worst);
      }
    metrics(en < 1 ? "order_defect_damped" : "order_defect_elastic",
            std::abs(order(steps, error) - 1));
  }
}
int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  statics(run, metrics);
  dynamics(run, metrics);
}
