// What the case programs share: arguments, CSV files, scenes, GSL's integrator, line fits, a clock.
#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_odeiv2.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iomanip>
#include <stdexcept>
#include <string>
#include <vector>

#include "tinydem.hpp"

namespace verification {
using tinydem::Mesh, tinydem::Parameters, tinydem::Particle, tinydem::real, tinydem::Simulation;
using tinydem::Vec3;
const double pi = 3.14159265358979323846;

// ------------------------------------------------------------------------------------- output

/// The command line `CASE OUT_DIR [quick]`; creates the directory.
struct Arguments {
  std::filesystem::path out{};
  bool quick = false;
  Arguments(int argc, char** argv) {
    if (argc < 2) throw std::runtime_error("usage: CASE OUT_DIR [quick]");
    out = argv[1], quick = argc > 2 && std::string(argv[2]) == "quick";
    std::filesystem::create_directories(out);
  }
};
/// A CSV file: `Csv f(out / "name.csv", "angle_deg,error"); f.row(12.5, 1e-3);`, words allowed.
struct Csv {
  std::ofstream file;
  Csv(const std::filesystem::path& path, const std::string& header) : file(path) {
    if (!file) throw std::runtime_error("cannot write " + path.string());
    file << header << "\n" << std::setprecision(12);
  }
  template <class A, class... B> void row(const A& first, const B&... rest) {
    file << first;
    ((file << "," << rest), ...);
    file << "\n";
  }
};
/// metrics.csv: what the table of cases judges.
struct Metrics : Csv {
  explicit Metrics(const std::filesystem::path& out) : Csv(out / "metrics.csv", "name,value") {}
  void operator()(const std::string& name, double value) { row(name, value); }
};
/// work.csv: the cost and the error of a method at a step.
struct Work : Csv {
  explicit Work(const std::filesystem::path& out)
      : Csv(out / "work.csv", "method,dt_over_eq50,force_evaluations,wall_time_s,error") {}
  void operator()(const std::string& method, double step, double evaluations, double wall_time,
                  double error) {
    row(method, step, evaluations, wall_time, error);
  }
};
/// Seconds since it was made.
struct Timer {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

// ------------------------------------------------------------------------------------- scenes

/// Parameters from text like "en = 0.9; mus = 0". Nothing falls, nothing is spawned and meshes have
/// no thickness unless asked.
inline Parameters scene(const std::string& text) {
  tinydem::vector<tinydem::Setting> all = {
      {"g", "0,0,0", ""}, {"Nspawn", "0", ""}, {"Rmesh", "0", ""}};
  for (const std::string& line : tinydem::split(text, ';'))
    if (const auto word = tinydem::split(line, '='); word.size() == 2)
      all.push_back({word[0], word[1], "scene of the case"});
  return tinydem::resolve(all);
}
/// "name = value" with every digit, to put a number into a scene.
inline std::string setting(const std::string& name, real value) {
  return "; " + name + " = " + tinydem::text(value);
}
/// The default step of Eq. (50) for a smallest radius R: written down here, not asked from the
/// solver.
inline double eq50(const Parameters& p, double R) {
  return R * std::sqrt(double(p.rho) * (1 - double(p.nu) * double(p.nu)) / double(p.E));
}
inline Particle ball(const Vec3& x, real R, const Vec3& v = {}, const Vec3& w = {}) {
  return {x, R, v, {1, 0, 0, 0}, w};
}
/// A square plate of edge 2a in the plane z = 0, about the origin.
inline Mesh plate(real a) {
  return {{{-a, -a, 0}, {a, -a, 0}, {a, a, 0}, {-a, a, 0}}, {{4, {0, 1, 2, 3}, 0}}};
}
/// A sphere that touches the plate with overlap `delta` (negative: above it).
inline Simulation on_plate(const Parameters& p, real R, const Vec3& v, const Vec3& w = {},
                           real delta = 0) {
  return Simulation(p, plate(1000 * R), {ball({0, 0, R - delta}, R, v, w)});
}
/// Two spheres along z that touch with overlap `delta`; v is the velocity of the upper one, the
/// lower one rests.
inline Simulation two_spheres(const Parameters& p, real upper, real lower, const Vec3& v,
                              real delta = 0) {
  return Simulation(p, {}, {ball({0, 0, upper + lower - delta}, upper, v), ball({}, lower)});
}

// ---------------------------------------------------------------------------------------- GSL

/// dy/dt = rates(t, y, dydt) by GSL's rk8pd with error control at `tolerance`, times `scales` (the
/// size of each component).
class Ode {
 public:
  typedef std::function<void(double, const double*, double*)> Rates;
  typedef std::function<double(double, const double*)> Event;
  Ode(Rates f, std::vector<double> scales, double tolerance = 1e-12)
      : rates(std::move(f)),
        scale(std::move(scales)),
        n(scale.size()),
        system{call, nullptr, n, this} {
    gsl_set_error_handler_off();
    stepper = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, n);
    control = gsl_odeiv2_control_scaled_new(tolerance, tolerance, 1, 0, scale.data(), n);
    evolve = gsl_odeiv2_evolve_alloc(n);
  }
  ~Ode() {
    gsl_odeiv2_evolve_free(evolve);
    gsl_odeiv2_control_free(control);
    gsl_odeiv2_step_free(stepper);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  /// Advances (t, y) to `end`, or to the first change of sign of `event` after the first step: then
  /// true. `first_step` is a guess.
  bool advance(double& t, std::vector<double>& y, double end, const Event& event = {},
               double first_step = 0) {
    double h = first_step > 0 ? first_step : (end - t) / 1000;
    double before = event ? event(t, y.data()) : 0;
    gsl_odeiv2_evolve_reset(evolve);
    while (t < end) {
      const double t0 = t;
      const std::vector<double> y0 = y;
      if (gsl_odeiv2_evolve_apply(evolve, control, stepper, &system, &t, end, &h, y.data()) !=
          GSL_SUCCESS)
        throw std::runtime_error("gsl_odeiv2: no step is small enough");
      if (!event) continue;
      const double after = event(t, y.data());
      if (before * after < 0) return locate(t0, y0, event, t, y), true;
      if (after != 0) before = after;
    }
    return false;
  }

 private:
  Rates rates;
  std::vector<double> scale;
  size_t n;
  gsl_odeiv2_system system;
  gsl_odeiv2_step* stepper = nullptr;
  gsl_odeiv2_control* control = nullptr;
  gsl_odeiv2_evolve* evolve = nullptr;
  static int call(double t, const double y[], double dydt[], void* self) {
    static_cast<Ode*>(self)->rates(t, y, dydt);
    return GSL_SUCCESS;
  }
  /// Halves the last step until its end is the event; one step of part of its size is no less
  /// accurate than the whole.
  void locate(double t0, const std::vector<double>& y0, const Event& event, double& t,
              std::vector<double>& y) {
    const double sign = event(t0, y0.data()) > 0 || event(t, y.data()) < 0 ? 1 : -1;
    std::vector<double> error(n);
    double low = 0, high = t - t0;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      y = y0;
      gsl_odeiv2_step_apply(stepper, t0, middle, y.data(), error.data(), nullptr, nullptr, &system);
      t = t0 + middle;
      (sign * event(t, y.data()) > 0 ? low : high) = middle;
    }
    gsl_odeiv2_step_reset(stepper);
  }
};

/// Slope of a straight line through (x, y), least squares.
inline double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double c0 = 0, c1 = 0, c00 = 0, c01 = 0, c11 = 0, sum = 0;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &c0, &c1, &c00, &c01, &c11, &sum);
  return c1;
}
/// Order of convergence: the slope of log(error) over log(step).
inline double order(std::vector<double> step, std::vector<double> error) {
  for (double& a : step) a = std::log(a);
  for (double& a : error) a = std::log(a);
  return slope(step, error);
}
}  // namespace verification
