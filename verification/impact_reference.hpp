// Reference for one impact of two spheres, or of a sphere on a flat wall: the contact model of the
// paper as a piecewise smooth ordinary differential equation, written down anew from Eqs. (5)-(41)
// and (51)-(60) and integrated by GSL (Prince-Dormand order 8, tolerance 1e-12). It shares no code
// with the solver.
//
// Each friction mode (sliding, rolling, twisting) is in one of two states:
//   stick  f = -k u - c v,  du/dt = v;  ends where |k u + c v| exceeds the limit L = mu |f_n|
//   slip   |f| = L. What the update of the scheme `consistent` becomes when the step goes to zero:
//     c > 0  The next trial force is (k'/k) f - c v. It exceeds L as long as v opposes f. So
//            f = -L v/|v|, until v vanishes.
//     c = 0  The trial force is (k'/k) f - k v dt: a plastic slider whose spring keeps the length
//            L/k. It ends where the spring would grow slower than the limit:
//            d(k |u|)/dt = L k'/k + k v.e < dL/dt, e = -f/|f|.
// The instants of the changes are located, so that the integrator never crosses a kink.
#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace reference {

/// Three components; not the solver's vectors, whose products are to be checked.
struct Triple {
  double x = 0, y = 0, z = 0;
};
inline Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Triple operator*(double s, const Triple& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Triple operator-(const Triple& a, const Triple& b) { return a + -1.0 * b; }
inline double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Triple& a) { return std::sqrt(dot(a, a)); }
inline Triple unit(const Triple& a) { return norm(a) > 0 ? 1 / norm(a) * a : a; }

/// Material of both bodies; E in Pa, rho in kg/m^3.
struct Matter {
  double E = 1e6, nu = 0.3, rho = 1000, e_n = 0.5, mu_s = 0.3, mu_r = 0, mu_t = 0;
};
/// A sphere: radius in m, velocity in m/s, spin in 1/s.
struct Ball {
  double R = 0.01;
  Triple v{}, w{};
  double mass(double rho) const { return 4 * M_PI / 3 * rho * R * R * R; }
};

/// One impact. `normal` points from j to i; j.R = 0 stands for a flat wall at rest.
class Impact {
 public:
  Impact(const Matter& matter, const Ball& i, const Ball& j, const Triple& normal)
      : mat(matter), wall(j.R <= 0), Ri(i.R), Rj(j.R), mi(i.mass(mat.rho)), n0(normal) {
    mj = wall ? INFINITY : j.mass(mat.rho);
    const double bodies = wall ? 1 : 2;  // elastic bodies that share the deformation
    Estar = mat.E / (bodies * (1 - mat.nu * mat.nu));
    Gstar = mat.E / (2 * (1 + mat.nu)) / (bodies * (2 - mat.nu));
    Rstar = wall ? Ri : Ri * Rj / (Ri + Rj);
    mstar = wall ? mi : mi * mj / (mi + mj);
    const double log_e = std::log(mat.e_n);
    beta = -log_e / std::sqrt(log_e * log_e + M_PI * M_PI);
    const double vn = -dot(i.v - j.v, normal);
    if (!(vn > 0)) throw std::invalid_argument("the bodies must approach");
    deepest = std::pow(15 * mstar * vn * vn / (16 * Estar * std::sqrt(Rstar)), 0.4);
    duration = 2.943 * deepest / vn;
    start(i, j, vn);
  }

  /// Integrates to the end of the contact.
  void run() {
    Stepper stepper(*this);
    for (double h = 1e-9 * duration; !apart; ++steps) {
      if (steps > 2000000 || t > 1e3 * duration) throw std::runtime_error("the contact never ends");
      advance(stepper, h);
    }
  }

  Triple vi() const { return at(3); }
  Triple vj() const { return at(6); }
  Triple wi() const { return at(9); }
  Triple wj() const { return at(12); }
  double t = 0;                 ///< time since first contact [s]
  double deepest, duration;     ///< scales: elastic overlap [m] and duration [s]
  long steps = 0, changes = 0;  ///< of the integrator, of the states of friction
  double least = 1e-9;  ///< shortest time between changes of state, as a share of `duration`
  std::function<void(const Impact&)> watch{};  ///< called after every step

  /// Overlap [m].
  double overlap() const { return wall ? Ri - dot(at(0), n0) : Ri + Rj - norm(at(0)); }

 private:
  enum { sliding, rolling, twisting, modes };
  static constexpr int size = 22;  // d, vi, vj, wi, wj, us, ur (three each), ut
  typedef std::array<double, size> State;
  struct Mode {
    bool slip = false;
    Triple e{};
    double since = -1;
  };
  /// All that the state implies: geometry, and for each mode velocity, stiffness, damping, limit.
  struct Contact {
    double delta, rate, ri, rj, N, k[modes], c[modes], L[modes];
    Triple n, turn, v[modes];
  };
  struct Stepper {
    explicit Stepper(Impact& impact) : system{rates, nullptr, size, &impact} {
      const double speed = impact.deepest / impact.duration, L = impact.deepest;
      double scale[size];
      for (int k = 0; k < size; ++k)
        scale[k] = k < 3 || k >= 15 ? L : k < 9 ? speed : speed / impact.Ri;
      step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size);
      control = gsl_odeiv2_control_scaled_new(1e-12, 0, 1, 0, scale, size);
      evolve = gsl_odeiv2_evolve_alloc(size);
    }
    Stepper(const Stepper&) = delete;
    Stepper& operator=(const Stepper&) = delete;
    ~Stepper() {
      gsl_odeiv2_evolve_free(evolve), gsl_odeiv2_control_free(control);
      gsl_odeiv2_step_free(step);
    }
    gsl_odeiv2_system system;
    gsl_odeiv2_step* step;
    gsl_odeiv2_control* control;
    gsl_odeiv2_evolve* evolve;
  };

  Triple at(int k) const { return {y[size_t(k)], y[size_t(k + 1)], y[size_t(k + 2)]}; }
  static Triple get(const double* a, int k) { return {a[k], a[k + 1], a[k + 2]}; }
  static void put(double* a, int k, const Triple& b) { a[k] = b.x, a[k + 1] = b.y, a[k + 2] = b.z; }
  static Triple spring(const double* a, int m) {
    return m == twisting ? Triple{a[21], 0, 0} : get(a, 15 + 3 * m);
  }
  void set_spring(int m, const Triple& u) {
    if (m == twisting) y[21] = u.x;
    else put(y.data(), 15 + 3 * m, u);
  }

  Contact contact(const double* a) const {
    Contact q;
    const Triple d = get(a, 0), v = get(a, 3) - get(a, 6), wi = get(a, 9), wj = get(a, 12);
    const double distance = wall ? dot(d, n0) : norm(d);
    q.n = wall ? n0 : 1 / distance * d;
    q.delta = std::max(Ri + Rj - distance, 0.0);
    q.rate = -dot(v, q.n);
    q.turn = wall ? Triple{} : 1 / distance * (v - dot(v, q.n) * q.n);  // d(n)/dt
    q.ri = Ri - q.delta / 2, q.rj = wall ? 0 : Rj - q.delta / 2;
    const double area = std::sqrt(Rstar * q.delta);
    const double kn = 4.0 / 3 * Estar * area, ks = 8 * Gstar * area;
    const double cn = beta * std::sqrt(5 * mstar * kn), cs = beta * std::sqrt(mstar * ks / 6);
    q.N = kn * q.delta + cn * q.rate;
    const double stiff[] = {ks, kn, ks}, damp[] = {cs, cn, cs},
                 mu[] = {mat.mu_s, mat.mu_r, mat.mu_t};
    for (int m = 0; m < modes; ++m)
      q.k[m] = stiff[m], q.c[m] = damp[m], q.L[m] = mu[m] * std::abs(q.N);
    q.v[sliding] = v + q.rate * q.n + cross(q.n, q.ri * wi + q.rj * wj);
    q.v[rolling] = (wall ? q.ri : q.ri * q.rj / (q.ri + q.rj)) * cross(wi - wj, q.n);
    q.v[twisting] = {Rstar * dot(wi - wj, q.n), 0, 0};
    return q;
  }
  /// Direction against which friction acts in slip.
  Triple against(const Contact& q, const double* a, int m) const {
    if (beta <= 0) return unit(spring(a, m));
    const Triple e = unit(q.v[m]);
    return dot(e, mode[m].e) < 0 ? -1.0 * e : e;  // smooth through the zero that ends the slip
  }
  Triple force(const Contact& q, const double* a, int m) const {
    if (q.L[m] <= 0 && mode[m].slip) return {};
    if (mode[m].slip) return -q.L[m] * against(q, a, m);
    return -q.k[m] * spring(a, m) - q.c[m] * q.v[m];
  }
  Triple spring_rate(const Contact& q, const double* a, int m) const {
    const Triple u = spring(a, m);
    const Triple turned = m == twisting ? Triple{} : -dot(u, q.turn) * q.n;
    if (!mode[m].slip) return q.v[m] + turned;
    if (beta > 0 || q.L[m] <= 0) return {};
    const Triple e = unit(u);  // here the spring only keeps the direction; its length is `deepest`
    return deepest * q.k[m] / q.L[m] * (q.v[m] - dot(q.v[m], e) * e) + turned;
  }
  static int rates(double, const double* a, double* r, void* self) {
    const Impact& s = *static_cast<Impact*>(self);
    const Contact q = s.contact(a);
    Triple f[modes];
    for (int m = 0; m < modes; ++m) f[m] = s.force(q, a, m);
    const Triple all = q.N * q.n + f[sliding];
    const Triple mutual = s.Rstar * (cross(q.n, f[rolling]) + f[twisting].x * q.n);
    const Triple arm = cross(f[sliding], q.n);
    put(r, 0, get(a, 3) - get(a, 6));
    put(r, 3, 1 / s.mi * all);
    put(r, 6, s.wall ? Triple{} : -1 / s.mj * all);
    put(r, 9, 2.5 / (s.mi * s.Ri * s.Ri) * (q.ri * arm + mutual));
    put(r, 12, s.wall ? Triple{} : 2.5 / (s.mj * s.Rj * s.Rj) * (q.rj * arm - mutual));
    for (int m = 0; m < modes; ++m) {
      const Triple u = s.spring_rate(q, a, m);
      if (m == twisting) r[21] = u.x;
      else put(r, 15 + 3 * m, u);
    }
    return GSL_SUCCESS;
  }

  /// First contact at the overlap 1e-9 of the deepest, where the motion is still free.
  void start(const Ball& i, const Ball& j, double vn) {
    const double delta = 1e-9 * deepest;
    t = delta / vn;
    put(y.data(), 0, (Ri + Rj - delta) * n0);
    put(y.data(), 3, i.v), put(y.data(), 6, j.v), put(y.data(), 9, i.w), put(y.data(), 12, j.w);
    const Contact q = contact(y.data());
    for (int m = 0; m < modes; ++m) {
      set_spring(m, t * q.v[m]);
      const Triple trial = q.k[m] * spring(y.data(), m) + q.c[m] * q.v[m];
      if (norm(trial) > q.L[m] || q.L[m] <= 0) begin_slip(m, unit(trial));
    }
  }
  void begin_slip(int m, const Triple& e) {
    mode[m].slip = true, mode[m].e = e;
    set_spring(m, beta > 0 ? Triple{} : deepest * e);
  }
  /// Positive when mode m must change its state.
  double due(const Contact& q, const double* a, int m) const {
    if (q.L[m] <= 0 && mode[m].slip) return -1;
    if (!mode[m].slip) return norm(q.k[m] * spring(a, m) + q.c[m] * q.v[m]) - q.L[m];
    if (beta > 0) return -dot(q.v[m], mode[m].e);
    return q.L[m] * q.rate / std::max(q.delta, 1e-30) - q.k[m] * dot(q.v[m], unit(spring(a, m)));
  }
  void change(int m) {
    const Contact q = contact(y.data());
    ++changes, mode[m].since = t;
    if (mode[m].slip) {  // the spring keeps the force: u = -f/k
      const Triple e = beta > 0 ? mode[m].e : unit(spring(y.data(), m));
      mode[m].slip = false, set_spring(m, q.L[m] / q.k[m] * e);
      return;
    }
    const Triple e = unit(q.k[m] * spring(y.data(), m) + q.c[m] * q.v[m]);
    // With the spring reset to u = L/k e, the next trial force is L e + c v. Is it within the
    // limit?
    const bool released = norm(q.L[m] * e + q.c[m] * q.v[m]) < q.L[m];
    if (beta > 0 && released) set_spring(m, q.L[m] / q.k[m] * e);
    else begin_slip(m, beta > 0 ? unit(q.v[m]) : e);
  }
  /// One step, shortened to the first event in it: the end of the contact (3), the zero of the
  /// normal force (4), or a change of state of a mode.
  void advance(Stepper& s, double& h) {
    const State before = y;
    const double t0 = t, N0 = contact(before.data()).N, shortest = least * duration;
    h = std::min(h, duration / 50);
    gsl_odeiv2_evolve_apply(s.evolve, s.control, s.step, &s.system, &t, INFINITY, &h, y.data());
    const double taken = t - t0;
    double first = taken;
    int event = -1;
    for (int k = 0; k < 5; ++k) {
      const auto value = [&](const State& a) {
        const Contact q = contact(a.data());
        return k < modes ? due(q, a.data(), k) : k == 3 ? outside(a) : N0 > 0 ? -q.N : q.N * 0 - 1;
      };
      if (!(value(y) > 0)) continue;
      const double h1 = locate(s, before, taken, value);
      if (h1 <= first) first = h1, event = k;
    }
    if (event >= 0) {
      first = std::max(first, std::min(shortest, taken));
      y = before, t = t0 + first;
      if (first > 0) apply(s, y, first);
      gsl_odeiv2_evolve_reset(s.evolve), gsl_odeiv2_step_reset(s.step);
      if (event == 3) apart = true;
      else if (event < modes) change(event);
      h = std::max(1e-3 * first, shortest);
    }
    const Contact q = contact(y.data());
    for (int m = 0; m < modes; ++m)
      if (mode[m].slip && beta > 0) mode[m].e = against(q, y.data(), m);
    if (watch) watch(*this);
  }
  /// Positive when the contact is over: at 1e-10 of the deepest overlap, because the direction of
  /// an undamped slip follows the motion ever faster as the limit goes to zero.
  double outside(const State& a) const {
    const Triple d = get(a.data(), 0);
    return (wall ? dot(d, n0) : norm(d)) - Ri - Rj + 1e-10 * deepest;
  }
  static void apply(Stepper& s, State& a, double h) {
    State error;
    gsl_odeiv2_step_reset(s.step);
    gsl_odeiv2_step_apply(s.step, 0, h, a.data(), error.data(), nullptr, nullptr, &s.system);
  }
  /// The part of the step after which `value` becomes positive: regula falsi (Illinois), and
  /// bisection while the lower end is not negative.
  template <class F> static double locate(Stepper& s, const State& before, double step, F value) {
    State end = before;
    apply(s, end, step);
    double low = 0, high = step, at_low = value(before), at_high = value(end);
    for (int k = 0; k < 60 && high - low > 1e-14 * step; ++k) {
      const bool bracket = at_low < 0 && at_high > 0 && k % 4 != 3;
      const double middle =
          bracket ? low - at_low * (high - low) / (at_high - at_low) : (low + high) / 2;
      State a = before;
      apply(s, a, middle);
      const double v = value(a);
      if (v > 0) high = middle, at_high = v, at_low /= 2;
      else low = middle, at_low = v, at_high /= 2;
      if (v == 0) break;
    }
    return high;
  }

  Matter mat;
  bool wall, apart = false;
  double Ri, Rj, mi, mj = 0, Rstar, mstar, Estar, Gstar, beta;
  Triple n0;
  State y{};
  Mode mode[modes];
};

}  // namespace reference
