// Case 8: a sphere hits a plate at an angle. The rebound of the solver beside that of the
// stick-slip reference, over angle, restitution, friction, Poisson's ratio and rolling friction.
#include "impacts.hpp"

using namespace verification;

const double R = 0.01, speed = 1;  // m, m/s: an overlap of 10 % of the radius at normal impact
const std::string elastic = "en = 1; mus = 0.3; mur = 0; mut = 0; Rmin = 0.01";
const std::string sliding = "en = 0.5; mus = 0.3; mur = 0; Rmin = 0.01";
const std::string rolling = "en = 0.5; mus = 0.3; mur = 0.3; Rmin = 0.01";  // defaults of Table 2

/// The impacts of one material: angles, and what the reference says about them.
struct Fan {
  std::string material{};
  std::vector<double> angles{};
  std::vector<Rebound> reference{};
  std::vector<bool> robust{};
  double mean_duration = 0;
  Fan(const std::string& text, double step_deg = 5) : material(text) {
    for (double a = step_deg; a < 89; a += step_deg) {
      const double open = ambiguity(scene(material), thrown(R, speed, a));
      robust.push_back(open < 1e-4 * speed);
      angles.push_back(a);
      reference.push_back(reference_on_plate(scene(material), thrown(R, speed, a)));
      mean_duration += reference.back().duration;
    }
    mean_duration /= double(angles.size());
  }
  Parameters parameters(const std::string& scheme, double divisor) const {
    Parameters p = scene(material + "; scheme = " + scheme);
    p.dt /= real(divisor);
    return p;
  }
};
const int phases = 4;
/// RMS over sub-step phases, and over the angles for which the model has one answer, of the error
/// of the rebound, over the impact speed; `run` makes an impact.
template <class F> double rms_error(const Fan& fan, const F& run) {
  double sum = 0;
  long n = 0;
  for (size_t k = 0; k < fan.angles.size(); ++k)
    for (int phase = 1; fan.robust[k] && phase <= phases; ++phase, ++n) {
      const reference::Ball in = thrown(R, speed, fan.angles[k]);
      const Rebound out = run(in, fan.reference[k].duration, double(phase) / phases);
      const double e = rebound_error(out.sphere, fan.reference[k].sphere) / speed;
      sum += e * e;
    }
  return std::sqrt(sum / double(n));
}
double solver_error(const Fan& fan, const std::string& scheme, double divisor) {
  const Parameters p = fan.parameters(scheme, divisor);
  return rms_error(fan, [&](const reference::Ball& in, double duration, double phase) {
    return solver_on_plate(p, in, duration, phase);
  });
}
double other_error(const Fan& fan, Method method, double divisor) {
  const Parameters p = fan.parameters("consistent", divisor);
  return rms_error(fan, [&](const reference::Ball& in, double duration, double phase) {
    return other_on_plate(p, in, duration, phase, method);
  });
}

/// The reference itself against numbers of an event-driven integration by another program, for the
/// elastic material: angle, v_x, spin w_y.
double reference_error() {
  const double table[][3] = {
      {5, 0.08313346518687345, 0.9121770051784601}, {15, 0.2274897399314478, 7.443693934341431},
      {30, 0.3164607986878462, 43.85906055198855},  {45, 0.41447669312072866, 70.50663210221249},
      {60, 0.5673094018932212, 72.83159645426045},  {75, 0.8106343992274285, 38.25762916880818}};
  double worst = 0;
  for (const auto& row : table) {
    const Rebound r = reference_on_plate(scene(elastic), thrown(R, speed, row[0]));
    worst = std::max(worst, std::abs(r.sphere.v.x - row[1]) / speed);
    worst = std::max(worst, R * std::abs(r.sphere.w.y - row[2]) / speed);
  }
  return worst;
}

/// Rebound angle and spin over the impact angle; solver: mean and range over phases.
void write_sweep(Csv& csv, const Fan& fan) {
  const Parameters p = scene(fan.material);
  const auto tilt = [](const reference::Ball& s) { return std::atan2(s.v.x, s.v.z) * 180 / pi; };
  const auto row = [&](const std::string& method, double divisor, double angle,
                       const std::vector<Rebound>& all) {
    double mean = 0, low = 1e9, high = -1e9, spin = 0, spin_low = 1e9, spin_high = -1e9;
    for (const Rebound& r : all) {
      const double a = tilt(r.sphere), w = R * r.sphere.w.y / speed;
      mean += a / double(all.size()), low = std::min(low, a), high = std::max(high, a);
      spin += w / double(all.size()), spin_low = std::min(spin_low, w);
      spin_high = std::max(spin_high, w);
    }
    csv.row(p.en, p.mur, method, divisor, angle, mean, low, high, spin, spin_low, spin_high);
  };
  for (size_t k = 0; k < fan.angles.size(); ++k) {
    row("reference", 0, fan.angles[k], {fan.reference[k]});
    for (const char* scheme : schemes)
      for (const double divisor : {1.0, 64.0}) {
        std::vector<Rebound> all;
        for (int phase = 1; phase <= phases; ++phase)
          all.push_back(solver_on_plate(fan.parameters(scheme, divisor),
                                        thrown(R, speed, fan.angles[k]), fan.reference[k].duration,
                                        double(phase) / phases));
        row(scheme, divisor, fan.angles[k], all);
      }
  }
}

/// Errors over steps for one material; returns those of the solver by scheme and step.
void write_convergence(Csv& csv, Work* work, const Fan& fan, int halvings) {
  const Parameters p = scene(fan.material);
  const double impacts = double(fan.angles.size()) * phases;
  const auto put = [&](const std::string& method, double divisor, double error, double seconds) {
    const double evaluations =
        fan.mean_duration / double(p.dt) * divisor * (method == "RK4" ? 4 : 1);
    csv.row(p.en, p.mur, method, divisor, evaluations, error);
    if (work) (*work)(method, 1 / divisor, evaluations, seconds / impacts, error);
  };
  for (int k = 0; k <= halvings; ++k) {
    const double divisor = std::pow(2.0, k);
    for (const char* scheme : schemes) {
      const Timer timer;
      const double error = solver_error(fan, scheme, divisor);
      put(scheme, divisor, error, timer.seconds());
    }
    if (!work) continue;
    for (const Method method : {Method::velocity_verlet, Method::rk4}) {
      const Timer timer;
      const double error = other_error(fan, method, divisor);
      put(name(method), divisor, error, timer.seconds());
    }
  }
}

/// Energy after one impact over that before it, over where in a step the sphere touches.
void write_energies(const Arguments& arguments, Metrics& metrics) {
  struct Row {
    const char *name, *text;
    double radius, angle, v;
  };
  const Row rows[] = {
      {"paper: sliding only", "mur = 0; mut = 0; Rmin = 0.01; scheme = paper", 0.01, 62, 1},
      {"paper: rolling too", "Rmin = 0.01; scheme = paper", 0.01, 62, 1},
      {"paper: R = 5 Rmin", "mur = 0; mut = 0; Rmin = 0.002; scheme = paper", 0.01, 62, 1},
      {"consistent: sliding only", "mur = 0; mut = 0; Rmin = 0.01", 0.01, 62, 1},
      {"paper: sliding only at 3 m/s", "mur = 0; mut = 0; Rmin = 0.01; scheme = paper", 0.01, 45,
       3},
      {"consistent: sliding only at 3 m/s", "mur = 0; mut = 0; Rmin = 0.01", 0.01, 45, 3}};
  Csv csv(arguments.out / "energy.csv", "name,angle_deg,phase,energy_ratio");
  double worst[6] = {};
  for (size_t r = 0; r < 6; ++r) {
    const Parameters p = scene(std::string("en = 1; mus = 1; ") + rows[r].text);
    const reference::Ball in = thrown(rows[r].radius, rows[r].v, rows[r].angle);
    const double duration = reference_on_plate(p, in).duration;
    for (int k = 1; k <= 64; ++k) {
      const double ratio = energy(solver_on_plate(p, in, duration, k / 64.0).sphere) / energy(in);
      csv.row(rows[r].name, rows[r].angle, k / 64.0, ratio);
      worst[r] = std::max(worst[r], ratio);
    }
  }
  metrics("paper_energy_62deg", worst[0]), metrics("paper_energy_62deg_rolling", worst[1]);
  metrics("paper_energy_62deg_fine", worst[2]), metrics("consistent_energy_62deg", worst[3]);
  metrics("paper_energy_45deg", worst[4]), metrics("consistent_energy_45deg", worst[5]);
}

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  Metrics metrics(arguments.out);
  const Fan fans[] = {Fan(elastic), Fan(sliding), Fan(rolling)};
  metrics("reference_against_table", reference_error());
  Csv sweep(arguments.out / "sweep.csv",
            "e_n,mu_r,method,divisor,angle_deg,rebound_deg,rebound_low_deg,rebound_high_deg,spin,"
            "spin_low,spin_high");
  Csv convergence(arguments.out / "convergence.csv",
                  "e_n,mu_r,method,divisor,force_evaluations,error");
  Work work(arguments.out);
  const char* names[] = {"elastic", "sliding", "rolling"};
  for (size_t k = 0; k < 3; ++k) {
    if (!arguments.quick) {
      write_sweep(sweep, fans[k]);
      write_convergence(convergence, k == 2 ? &work : nullptr, fans[k], 8);
    }
    metrics(std::string(names[k]) + "_dt0", solver_error(fans[k], "consistent", 1));
    metrics(std::string(names[k]) + "_dt0_64", solver_error(fans[k], "consistent", 64));
    metrics(std::string(names[k]) + "_paper_dt0_64", solver_error(fans[k], "paper", 64));
  }
  const std::vector<double> divisors = {2, 8, 32};
  std::vector<double> steps, errors;
  for (const double d : divisors)
    steps.push_back(1 / d), errors.push_back(solver_error(fans[0], "consistent", d));
  metrics("elastic_order", order(steps, errors));
  double worst = 0;
  for (const char* nu : {"-0.5", "0", "0.2", "0.5"})
    for (const char* mus : {"0.1", "0.6"})
      worst = std::max(
          worst,
          solver_error(
              Fan("en = 0.8; mur = 0; Rmin = 0.01; nu = " + std::string(nu) + "; mus = " + mus, 15),
              "consistent", 16));
  metrics("poisson_dt0_16", worst);
  write_energies(arguments, metrics);
}
