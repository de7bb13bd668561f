// Case 10: friction only takes energy. Map of the energy after one impact on a wall over that
// before it: angle x mu x e_n x step x phase of the step, for both schemes.
#include <map>

#include "impacts.hpp"

using namespace verification;

const double R = 0.01, speed = 1;  // m, m/s
const std::vector<double> frictions = {0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3};
const std::vector<double> restitutions = {1, 0.9, 0.7, 0.5, 0.4, 0.2};
const std::vector<double> divisors = {1, 2, 5, 10, 100};

/// Ends of an impact without friction: closed form for e_n = 1, and twice that for the damped ones.
double longest(double e_n, double vn) {
  const double m = 4000 * pi / 3 * R * R * R, K = 4.0 / 3 * 1e6 / (1 - 0.09) * std::sqrt(R);
  const double deepest = std::pow(1.25 * m * vn * vn / K, 0.4);
  return 2.943 * deepest / vn * (e_n < 1 ? 1.2 + 0.35 * (1 - e_n) : 1.1);
}
/// The largest energy ratio over the phases of a step.
double worst_ratio(const Parameters& p, double angle, int phases) {
  const reference::Ball in = thrown(R, speed, angle);
  const double duration = longest(double(p.en), -in.v.z);
  double worst = 0;
  for (int k = 1; k <= phases; ++k)
    worst = std::max(
        worst, energy(solver_on_plate(p, in, duration, k / double(phases)).sphere) / energy(in));
  return worst;
}
/// Largest ratio of each step over all else, and over all else with mu <= 1.
struct Worst {
  std::map<double, double> all{}, usual{};
};
struct Map {
  std::string scheme, rolling;  // rolling: a setting of mu_r
  double angle_step;
  int phases;
};
/// Steps of 1/100 of the default one: only where a gain is to be feared, and for one phase.
bool is_fine(double divisor) { return divisor > 20; }
Worst scan(Csv& csv, const Map& map) {
  Worst worst;
  for (const double e_n : restitutions)
    for (const double mu : frictions)
      for (const double divisor : divisors) {
        if (is_fine(divisor) && map.rolling != "0") continue;
        Parameters p = scene("Rmin = 0.01; scheme = " + map.scheme + "; mur = " + map.rolling +
                             setting("en", real(e_n)) + setting("mus", real(mu)));
        p.dt /= real(divisor);
        const double first = is_fine(divisor) ? 60 : 2;
        for (double angle = first; angle < 90; angle += map.angle_step) {
          const double ratio = worst_ratio(p, angle, is_fine(divisor) ? 1 : map.phases);
          csv.row(map.scheme, map.rolling, e_n, mu, divisor, angle, ratio);
          worst.all[divisor] = std::max(worst.all[divisor], ratio);
          if (mu <= 1) worst.usual[divisor] = std::max(worst.usual[divisor], ratio);
        }
      }
  return worst;
}

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  Metrics metrics(arguments.out);
  Csv csv(arguments.out / "map.csv", "scheme,mu_r,e_n,mu,divisor,angle_deg,energy_ratio");
  const double step = arguments.quick ? 12 : 3;
  const int phases = arguments.quick ? 2 : 3;
  Worst consistent = scan(csv, {"consistent", "0", step, phases});
  Worst rolling = scan(csv, {"consistent", "0.3", step, phases});
  Worst paper = scan(csv, {"paper", "0", step, phases});
  Worst paper_rolling = scan(csv, {"paper", "0.3", step, phases});
  metrics("gain_dt0", consistent.all[1] - 1), metrics("gain_dt0_usual", consistent.usual[1] - 1);
  metrics("gain_dt0_2", consistent.all[2] - 1);
  metrics("ratio_dt0_5", consistent.all[5]), metrics("ratio_dt0_10", consistent.all[10]);
  metrics("ratio_dt0_100", consistent.all[100]), metrics("gain_rolling_dt0", rolling.all[1] - 1);
  metrics("paper_dt0", paper.all[1]), metrics("paper_rolling_dt0", paper_rolling.all[1]);
  metrics("paper_dt0_10", paper.all[10]), metrics("paper_dt0_100", paper.all[100]);
}
