// Case 4: three benchmark impacts on a rigid wall that the literature agrees on (Chung and Ooi,
// Granular Matter 13 (2011) 643): normal impact over e_n, oblique impact over the angle, oblique
// impact of one normal velocity over the tangential one.
#include "impacts.hpp"

using namespace verification;

/// What is written about test 4: aluminium oxide, R = 2.5 mm, 3.9 m/s, e_n = 0.98, mu = 0.092.
struct Published {
  double angle, e_t, spin;
};
const Published published[] = {{5, 0.948, 19},   {10, 0.687, 213}, {15, 0.624, 378},
                               {30, 0.684, 617}, {40, 0.781, 545}, {60, 0.893, 357}};
const double e_t_at_20_deg = 0.616;  // published without its spin
const std::string oxide = "E = 3.8e11; nu = 0.23; rho = 4000; mur = 0; mut = 0; Rmin = 0.0025";
const std::string iron = "E = 1e11; nu = 0.25; rho = 7000; mur = 0; mut = 0; Rmin = 0.0025";
// Test 5: R = 10 um, 5 m/s normal, mu = 0.3. The plateau does not depend on the elastic constants;
// steel is taken.
const std::string steel =
    "E = 2.08e11; nu = 0.3; rho = 7850; en = 1; mus = 0.3; mur = 0; mut = 0; Rmin = 1e-5";
const std::string test4 = oxide + "; en = 0.98; mus = 0.092";
const double R4 = 0.0025, v4 = 3.9, R5 = 1e-5, v5 = 5;
const int phases = 8;

Parameters parameters(const std::string& text, const std::string& scheme, double divisor) {
  Parameters p = scene(text + "; scheme = " + scheme);
  p.dt /= real(divisor);
  return p;
}
/// Of the contact; it depends on the normal velocity alone, as its power -1/5.
double duration(const Parameters& p, const reference::Ball& in) {
  reference::Matter smooth = matter(p);
  smooth.mu_s = smooth.mu_r = smooth.mu_t = 0;
  reference::Impact impact(smooth, {in.R, {0, 0, in.v.z}, {}}, {0, {}, {}}, {0, 0, 1});
  impact.run();
  return impact.t;
}
/// Mean over phases of the step.
Rebound solve(const Parameters& p, const reference::Ball& in) {
  Rebound mean{{in.R, {}, {}}, duration(p, in)};
  for (int k = 1; k <= phases; ++k) {
    const Rebound r = solver_on_plate(p, in, mean.duration, double(k) / phases);
    mean.sphere.v = mean.sphere.v + 1.0 / phases * r.sphere.v;
    mean.sphere.w = mean.sphere.w + 1.0 / phases * r.sphere.w;
  }
  return mean;
}

/// Test 3: largest difference between the measured and the given coefficient of restitution.
double restitution(Csv* csv, const std::string& scheme, double divisor) {
  double worst = 0;
  for (const std::string& material : {oxide, iron})
    for (const double e_n : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      const Parameters p = parameters(material + setting("en", real(e_n)), scheme, divisor);
      const reference::Ball in = thrown(R4, v4, 0);
      const double e = solve(p, in).sphere.v.z / v4;
      worst = std::max(worst, std::abs(e - e_n));
      if (csv) csv->row(material == oxide ? "oxide" : "iron", scheme, divisor, e_n, e);
    }
  return worst;
}
/// Test 4: mean differences from the published tangential restitution (relative) and spin (over the
/// largest one, 617 1/s).
struct Differences {
  double e_t = 0, spin = 0;
};
template <class F> Differences against_published(const F& rebound) {
  Differences d;
  for (const Published& row : published) {
    const reference::Ball in = thrown(R4, v4, row.angle), out = rebound(in).sphere;
    d.e_t += std::abs(out.v.x / in.v.x / row.e_t - 1) / double(std::size(published));
    d.spin += std::abs(std::abs(out.w.y) - row.spin) / 617 / double(std::size(published));
  }
  return d;
}
Differences against_published(const std::string& scheme, double divisor) {
  return against_published([&](const reference::Ball& in) {
    const Parameters p = parameters(test4, scheme, divisor);
    return solve(p, in);
  });
}
/// Rms error of test 4 against the reference, over the published angles and phases.
template <class F> double error_of_test4(const F& run) {
  static const auto exact = [] {
    std::vector<Rebound> all;
    for (const Published& row : published)
      all.push_back(reference_on_plate(scene(test4), thrown(R4, v4, row.angle)));
    return all;
  }();
  double sum = 0;
  for (size_t row = 0; row < exact.size(); ++row) {
    const reference::Ball in = thrown(R4, v4, published[row].angle);
    for (int k = 1; k <= phases; ++k) {
      const Rebound r = run(in, exact[row].duration, double(k) / phases);
      sum += std::pow(rebound_error(r.sphere, exact[row].sphere) / v4, 2);
    }
  }
  return std::sqrt(sum / double(phases * int(std::size(published))));
}
double error_of_test4(const std::string& scheme, double divisor) {
  const Parameters p = parameters(test4, scheme, divisor);
  return error_of_test4([&](const reference::Ball& in, double contact, double phase) {
    return solver_on_plate(p, in, contact, phase);
  });
}
/// Test 5: dimensionless spin and rebound angle of the surface for a dimensionless tangential
/// velocity v_t/(mu v_n).
reference::Ball fifth(double tangential) { return {R5, {0.3 * v5 * tangential, 0, -v5}, {}}; }
double plateau(const std::string& scheme, double divisor) {
  const Parameters p = parameters(steel, scheme, divisor);
  double worst = 0;
  for (const double tangential : {10.0, 12.0, 15.0}) {
    const reference::Ball in = fifth(tangential);
    const Rebound r = solve(p, in);
    worst = std::max(worst, std::abs(R5 * r.sphere.w.y / (0.3 * v5) - 5));
  }
  return worst;
}

void write_curves(const Arguments& arguments) {
  Csv four(arguments.out / "test4.csv", "method,divisor,angle_deg,e_t,spin_per_s");
  Csv five(arguments.out / "test5.csv", "method,divisor,v_t_over_mu_v_n,spin,surface_out");
  Csv table(arguments.out / "published.csv", "angle_deg,e_t,spin_per_s");
  table.row(20, e_t_at_20_deg, "nan");
  for (const Published& row : published) table.row(row.angle, row.e_t, row.spin);
  const auto put = [&](const std::string& method, double divisor, double angle, double tangential,
                       const auto& rebound) {
    const reference::Ball in4 = thrown(R4, v4, angle), in5 = fifth(tangential);
    const reference::Ball a = rebound(test4, in4).sphere, b = rebound(steel, in5).sphere;
    four.row(method, divisor, angle, a.v.x / in4.v.x, a.w.y);
    five.row(method, divisor, tangential, R5 * b.w.y / (0.3 * v5),
             (b.v.x - R5 * b.w.y) / (0.3 * v5));
  };
  for (int k = 1; k <= 57; ++k)
    put("reference", 0, 1.5 * k, 0.2 * k, [](const std::string& text, const reference::Ball& in) {
      return reference_on_plate(scene(text), in);
    });
  for (const char* scheme : schemes)
    for (const double divisor : {1.0, 64.0})
      for (int k = 1; k <= 19; ++k)
        put(scheme, divisor, 4.5 * k, 0.6 * k,
            [&](const std::string& text, const reference::Ball& in) {
              const Parameters p = parameters(text, scheme, divisor);
              return solve(p, in);
            });
}
void write_work(const Arguments& arguments) {
  Work work(arguments.out);
  const double runs = phases * double(std::size(published));
  error_of_test4("consistent", 1);  // solves the reference, which is not to be timed
  const double time = duration(scene(test4), thrown(R4, v4, 30));
  for (double divisor = 1; divisor <= 256; divisor *= 2) {
    const double steps = time / double(parameters(test4, "consistent", divisor).dt);
    for (const char* scheme : schemes) {
      const Timer timer;
      const double error = error_of_test4(scheme, divisor);
      work(scheme, 1 / divisor, steps, timer.seconds() / runs, error);
    }
    for (const Method method : {Method::velocity_verlet, Method::rk4}) {
      const Parameters p = parameters(test4, "consistent", divisor);
      const Timer timer;
      const double error =
          error_of_test4([&](const reference::Ball& in, double contact, double phase) {
            return other_on_plate(p, in, contact, phase, method);
          });
      work(name(method), 1 / divisor, steps * (method == Method::rk4 ? 4 : 1),
           timer.seconds() / runs, error);
    }
  }
}

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  Metrics metrics(arguments.out);
  Csv three(arguments.out / "test3.csv", "material,method,divisor,e_n,measured");
  metrics("test3_dt0", restitution(&three, "consistent", 1));
  metrics("test3_dt0_16", restitution(&three, "consistent", 16));
  restitution(&three, "paper", 1);
  const Differences model = against_published(
      [](const reference::Ball& in) { return reference_on_plate(scene(test4), in); });
  metrics("test4_reference_e_t", model.e_t), metrics("test4_reference_spin", model.spin);
  for (const double divisor : {1.0, 64.0}) {
    const Differences d = against_published("consistent", divisor);
    const std::string end = divisor > 1 ? "_consistent_dt0_64" : "_consistent_dt0";
    metrics("test4_e_t" + end, d.e_t), metrics("test4_spin" + end, d.spin);
  }
  metrics("test4_e_t_paper_dt0", against_published("paper", 1).e_t);
  const reference::Ball at_20_deg = thrown(R4, v4, 20);
  for (const char* scheme : schemes) {
    const Rebound r = solve(parameters(test4, scheme, 64), at_20_deg);
    metrics(std::string("test4_20deg_") + scheme,
            std::abs(r.sphere.v.x / at_20_deg.v.x / e_t_at_20_deg - 1));
  }
  metrics("test4_error_dt0", error_of_test4("consistent", 1));
  metrics("test4_error_dt0_64", error_of_test4("consistent", 64));
  metrics("test5_plateau_dt0", plateau("consistent", 1));
  metrics("test5_plateau_paper_dt0", plateau("paper", 1));
  if (!arguments.quick) write_curves(arguments), write_work(arguments);
}
