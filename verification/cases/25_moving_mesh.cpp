// Case 25: a sphere on a plate that vibrates, translates or rotates. At its static overlap N = m g,
// r = R - delta/2, q = 1 + 2.5 r^2/R^2. Plane vectors are complex numbers, i turns by 90 degrees.
//
// Vibration A sin(omega t), Gamma = A omega^2/g. In the frame of the plate
//   m d2(delta)/dt2 = m g (1 - Gamma sin(omega t)) - K delta^(3/2) - beta sqrt(5 m K) delta^(1/4)
//   d(delta)/dt. A stiff contact follows its load, delta = delta_0 (1 - Gamma sin)^(2/3), and opens
//   where sin = 1/Gamma. There the load falls as -J t, J = g omega sqrt(Gamma^2 - 1). With the time
//   T = (m/K)^(2/7) J^(-1/7) and the length J T^3 the equation loses its constants,
//   y'' = -x - y^(3/2) - beta sqrt(5) y^(1/4) y', so a soft contact opens C T later, C = C(e_n).
// Belt of speed V, sphere at rest: dv/dt = mu_s g until q v = V + 2.5 (r/R) mu_r g t; so it goes
// on,
//   without slip, until v = V at V r/(R mu_r g). For mu_r R > mu_s r it slides like a box until
//   V/(mu_s g), for mu_r = 0 it stays at V/q.
// Turntable W, mu_r = mu_t = 0: the force is m dv/dt, the torque changes r n x w by (q - 1) dv, and
//   no slip means v + r n x w = i W z; so dv/dt = i Omega v, Omega = W/q: a circle of radius
//   |v|/Omega about z + i v/Omega. The contact itself is linear: the reference is an ODE.
// Sphere at rest on the table: F = m rho W^2 stretches the springs by F/k_s and F r/(R k_n), and
//   it stays while rho W^2 <= g min(mu_s, mu_r R/r). No slip in a step from z to z' means
//   (z' - z)/dt = i W (z + z')/2, so that a step turns it by 2 arctan(W dt/2): it lags behind.
// Velocities of the solver belong to the middle of the last step: a particle that is at z at t = 0
//   starts with the velocity that it has half a step before.
#include <complex>

#include "support.hpp"

using namespace verification;
typedef std::complex<double> Complex;

const Complex I(0, 1), axis(0.2, -0.1);  // the table turns about this point, m
const double R = 0.01, g = 9.81;         // m, m/s^2

static std::string digits(double a) { return tinydem::text(real(a)); }

/// A sphere at its static overlap under the load of `loads` weights, and the constants of its
/// contact, from the model's equations.
struct Resting {
  Parameters p;
  double m, K, delta, r, q, kn, ks, cs, beta;  // K: force over overlap^1.5
  explicit Resting(const std::string& text, double divisor = 1, double loads = 1)
      : p(scene("g = 0,0,-9.81; Rmin = 0.01; " + text)) {
    p.dt /= real(divisor);
    const double E = double(p.E), nu = double(p.nu), e = std::log(double(p.en));
    m = 4 * pi / 3 * double(p.rho) * R * R * R;
    K = 4.0 / 3 * E / (1 - nu * nu) * std::sqrt(R), beta = -e / std::sqrt(e * e + pi * pi);
    delta = std::pow(loads * m * g / K, 2.0 / 3), r = R - delta / 2;
    q = 1 + 2.5 * r * r / (R * R);
    kn = K * std::sqrt(delta), ks = 4 * E / ((1 + nu) * (2 - nu)) * std::sqrt(R * delta);
    cs = beta * std::sqrt(m * ks / 6);
  }
};
static double largest(double a, double b) { return std::max(a, std::abs(b)); }

// ------------------------------------------------------------------------------- vibrating plate

const double omega = 2 * pi * 5;  // 1/s
struct Shaking {
  double gamma, E, divisor = 1;
};
static Resting shaken(const Shaking& s) {
  return Resting("E = " + digits(s.E) + "; motion = 0 vibrate 0,0," +
                     digits(s.gamma * g / (omega * omega)) + " 5",
                 s.divisor);
}
/// Overlap over time; `opened` is the phase of the first take-off, or 0.
struct Overlap {
  std::vector<double> t{}, delta{};
  double opened = 0;
};
static Overlap solver_overlap(const Shaking& s, double periods) {
  const Resting c = shaken(s);
  const double A = s.gamma * g / (omega * omega);
  Simulation sim = on_plate(c.p, real(R), {0, 0, real(A * omega)}, {}, real(c.delta));
  Overlap o{{0}, {c.delta}};
  while (o.opened == 0 && o.t.back() * omega < 2 * pi * periods) {
    sim.run(1);
    const double t = double(sim.time()), before = o.delta.back();
    const double now = R + A * std::sin(omega * t) - double(sim.particles()[0].x.z);
    if (now <= 0) o.opened = omega * (t - double(c.p.dt) * now / (now - before));
    o.t.push_back(t), o.delta.push_back(now);
  }
  return o;
}
/// The same by GSL, at the instants `t`, of which the last may be later than the take-off.
static Overlap reference_overlap(const Shaking& s, const std::vector<double>& t) {
  const Resting c = shaken(s);
  Ode ode(
      [&](double at, const double* y, double* dydt) {
        const double d = std::max(y[0], 0.0), damping = c.beta * std::sqrt(5 * c.K / c.m);
        dydt[0] = y[1];
        dydt[1] = g * (1 - s.gamma * std::sin(omega * at)) - c.K / c.m * std::pow(d, 1.5) -
                  damping * std::pow(d, 0.25) * y[1];
      },
      {c.delta, omega * c.delta}, 1e-11);
  Overlap o;
  std::vector<double> y = {c.delta, 0};
  double now = 0;
  for (const double end : t) {
    if (end > now && ode.advance(
                         now, y, end, [](double, const double* a) { return a[0]; },
                         1e-3 * std::sqrt(c.delta / g))) {
      o.opened = omega * now;
      break;
    }
    o.t.push_back(end), o.delta.push_back(y[0]);
  }
  return o;
}
/// How late a soft contact opens, in units of T.
static double delay_constant(double beta) {
  Ode ode(
      [&](double x, const double* y, double* dydx) {
        const double d = std::max(y[0], 0.0);
        dydx[0] = y[1];
        dydx[1] = -x - std::pow(d, 1.5) - beta * std::sqrt(5.0) * std::pow(d, 0.25) * y[1];
      },
      {1, 1});
  const double start = 200;
  std::vector<double> y = {std::pow(start, 2.0 / 3), -2.0 / 3 * std::pow(start, -1.0 / 3)};
  double x = -start;
  ode.advance(
      x, y, 100, [](double, const double* a) { return a[0]; }, 1e-3);
  return x;
}
static double opening_phase(const Shaking& s) {
  const Resting c = shaken(s);
  const double J = g * omega * std::sqrt(s.gamma * s.gamma - 1);
  return std::asin(1 / s.gamma) +
         delay_constant(c.beta) * omega * std::pow(c.m / c.K, 2.0 / 7) * std::pow(J, -1.0 / 7);
}
static double rest_part(double gamma, double t) {
  return std::pow(1 - gamma * std::sin(omega * t), 2.0 / 3);
}

/// Below 1 g: largest distance from the reference and from the quasi-static overlap, in static
/// ones.
struct Following {
  double reference = 0, quasi_static = 0, smallest = 1;
  long steps = 0;
};
static Following follow(double gamma, double divisor) {
  const Shaking s{gamma, 1e8, divisor};
  const double unit = shaken(s).delta;
  const Overlap all = solver_overlap(s, 2);
  Overlap a;
  for (size_t k = 0; k < all.t.size(); k += size_t(50 * divisor))
    a.t.push_back(all.t[k]), a.delta.push_back(all.delta[k]);
  const Overlap b = reference_overlap(s, a.t);
  Following f;
  f.steps = long(all.t.size());
  if (all.opened > 0 || b.opened > 0) return f.smallest = 0, f;
  for (size_t k = 0; k < a.t.size(); ++k) {
    f.reference = largest(f.reference, (a.delta[k] - b.delta[k]) / unit);
    f.quasi_static = largest(f.quasi_static, a.delta[k] / unit - rest_part(gamma, a.t[k]));
    f.smallest = std::min(f.smallest, a.delta[k] / unit);
  }
  return f;
}
static void below_one_g(Metrics& metrics) {
  Following worst;
  for (const double gamma : {0.2, 0.5, 0.8, 0.95}) {
    const Following f = follow(gamma, 1);
    worst.reference = std::max(worst.reference, f.reference);
    worst.quasi_static = std::max(worst.quasi_static, f.quasi_static);
    worst.smallest = std::min(worst.smallest, f.smallest);
  }
  metrics("vibration_smallest_overlap", worst.smallest);
  metrics("vibration_overlap", worst.reference);
  metrics("vibration_quasi_static", worst.quasi_static);
  double low = 0.97, high = 1.03;
  for (int k = 0; k < 10; ++k) {
    const double middle = (low + high) / 2;
    (solver_overlap({middle, 1e8}, 1).opened > 0 ? high : low) = middle;
  }
  metrics("vibration_limit", std::abs(low - 1));
}
static void above_one_g(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "takeoff.csv", "E_Pa,gamma,phase,stiff,reference");
  double stiff = 0, reference = 0;
  for (const double E : {1e6, 1e8, 1e10})
    for (const double gamma : {1.1, 1.25, 1.5, 2.0, 3.0, 5.0}) {
      if (run.quick && gamma != 1.1 && gamma != 2 && gamma != 5) continue;
      const Shaking s{gamma, E};
      const double phase = solver_overlap(s, 1).opened, closed = std::asin(1 / gamma);
      const double soft = reference_overlap(s, {0, 2 * pi / omega}).opened;
      csv.row(E, gamma, phase, closed, soft);
      reference = largest(reference, phase - soft);
      if (E > 1e9) stiff = largest(stiff, phase - closed);
    }
  metrics("takeoff_reference", reference), metrics("takeoff_stiff", stiff);
  const Shaking fine{2, 1e10, 16};
  const double closed = std::asin(0.5), delay = opening_phase(fine) - closed;
  metrics("takeoff_delay", std::abs((solver_overlap(fine, 1).opened - closed) / delay - 1));
}
/// Overlaps at 0.8 g over the time step.
static void vibration_steps(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "steps.csv", "divisor,force_evaluations,error");
  std::vector<double> steps, errors;
  for (double divisor = 1; divisor <= (run.quick ? 4 : 32); divisor *= 2) {
    const Following f = follow(0.8, divisor);
    csv.row(divisor, f.steps, f.reference);
    if (divisor <= 4) steps.push_back(1 / divisor), errors.push_back(f.reference);
  }
  metrics("vibration_order", order(steps, errors));
}
static void write_vibration(const Arguments& run) {
  Csv late(run.out / "delay.csv", "E_Pa,gamma,phase");
  for (const double E : {1e6, 1e8, 1e10})
    for (double gamma = 1.06; gamma < 5.2; gamma *= 1.04)
      late.row(E, gamma, opening_phase({gamma, E}));
  Csv csv(run.out / "vibration.csv", "gamma,phase,overlap,quasi_static");
  for (const double gamma : {0.2, 0.5, 0.8, 0.95, 1.5}) {
    const Shaking s{gamma, 1e8};
    const Overlap o = solver_overlap(s, 1);
    const double unit = shaken(s).delta;
    for (size_t k = 0; k < o.t.size(); k += 40)
      csv.row(gamma, omega * o.t[k], o.delta[k] / unit,
              std::pow(std::max(0.0, 1 - gamma * std::sin(omega * o.t[k])), 2.0 / 3));
  }
}

// ------------------------------------------------------------------------------------------ belt

const double V = 1, mus = 0.3;  // m/s
struct Belt {
  double mur;
  Resting c;
  explicit Belt(double mu)
      : mur(mu),
        c("E = 1e8; motion = 0 translate 1,0,0; mus = 0.3; mut = 0; mur = " + digits(mu)) {}
  bool box() const { return mur * R > mus * c.r; }
  /// When slip ends, when the belt's speed is reached.
  double grip() const { return V / (g * (c.q * mus - 2.5 * mur * c.r / R)); }
  double end() const { return box() ? V / (mus * g) : V * c.r / (R * mur * g); }
  double speed(double t) const {
    if (t >= end()) return V;
    if (box() || t < grip()) return mus * g * t;
    return (V + 2.5 * c.r / R * mur * g * t) / c.q;
  }
};
/// Time and velocity, until the sphere moves steadily.
static Overlap ride(const Belt& b) {
  Simulation s = on_plate(b.c.p, real(R), {}, {}, real(b.c.delta));
  Overlap o{{0}, {0}};
  const double all = b.mur > 0 ? b.end() + 0.15 : 3 * b.grip();
  while (o.t.back() < all) {
    s.run(50);
    o.t.push_back(double(s.time())), o.delta.push_back(double(s.particles()[0].v.x));
  }
  return o;
}
/// When the straight line through the middle of the last phase of acceleration reaches `speed`.
static double arrival(const Overlap& o, double from, double to, double speed) {
  std::vector<double> t, v;
  for (size_t k = 0; k < o.t.size(); ++k)
    if (o.t[k] > from + 0.3 * (to - from) && o.t[k] < to - 0.1 * (to - from))
      t.push_back(o.t[k]), v.push_back(o.delta[k]);
  return t[0] + (speed - v[0]) / slope(t, v);
}
static void belt(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "belt.csv", "mu_r,time_s,v_m_per_s,closed_m_per_s");
  double speed = 0, time = 0, rms = 0;
  for (const double mur : {0.0, 0.1, 0.2, 0.4}) {
    const Belt b(mur);
    const Overlap o = ride(b);
    const double last = mur > 0 ? V : V / b.c.q, due = mur > 0 ? b.end() : b.grip();
    speed = largest(speed, o.delta.back() / last - 1);
    const double from = mur == 0 || b.box() ? 0 : b.grip();
    time = largest(time, arrival(o, from, due, last) / due - 1);
    double sum = 0;
    for (size_t k = 0; k < o.t.size(); ++k) {
      sum += std::pow(o.delta[k] - b.speed(o.t[k]), 2) / double(o.t.size());
      csv.row(mur, o.t[k], o.delta[k], b.speed(o.t[k]));
    }
    rms = std::max(rms, std::sqrt(sum));
  }
  metrics("belt_speed", speed), metrics("belt_time", time), metrics("belt_rms", rms);
}

// ------------------------------------------------------------------------------------- turntable

static std::string turning(double W) {
  return "motion = 0 rotate " + digits(axis.real()) + "," + digits(axis.imag()) + ",0 0,0," +
         digits(W) + "; ";
}
/// A sphere at z from the axis with velocity v and spin w.
static Simulation on_table(const Resting& c, Complex z, Complex v, const Vec3& w) {
  const Vec3 x{real(axis.real() + z.real()), real(axis.imag() + z.imag()), real(R - c.delta)};
  return Simulation(c.p, plate(1), {ball(x, real(R), {real(v.real()), real(v.imag()), 0}, w)});
}
static Complex place(const Simulation& s) {
  const Vec3 x = s.particles()[0].x;
  return Complex(double(x.x), double(x.y)) - axis;
}
static Complex velocity(const Simulation& s) {
  const Vec3 v = s.particles()[0].v;
  return {double(v.x), double(v.y)};
}
const Complex z0(0.1, 0.02), v0(0.03, 0.1);  // at t = 0; m, m/s
const int samples = 60;                      // of one turn of the sphere

/// The turn of a sphere that starts without slip: where it is, from the axis.
struct Turn {
  Resting c;
  double W, Omega, period;
  long steps_each;
  Complex half{};  // by which the velocity turns in half a step
  Turn(double w, const std::string& scheme, double divisor)
      : c(turning(w) + "mus = 0.5; mur = 0; mut = 0; scheme = " + scheme),
        W(w),
        Omega(W / c.q),
        period(2 * pi / std::abs(Omega)),
        steps_each(std::lround(period / samples / double(c.p.dt) * divisor)) {
    c.p.dt = real(period / samples / double(steps_each));
    half = std::exp(I * Omega * double(c.p.dt) / 2.0);
  }
};
struct Path {
  std::vector<Complex> z{}, v{};
};
static Path solver_path(const Turn& t, Complex start_v = v0) {
  const Complex v = start_v / t.half, z = z0 - double(t.c.p.dt) / 2 * v;  // half a step before
  const Complex s = I * t.W * z - v;                                      // r n x w: no slip
  Simulation sim = on_table(t.c, z0, v, {real(s.imag() / t.c.r), real(-s.real() / t.c.r), 0});
  Path path{{place(sim)}, {start_v}};
  for (int k = 0; k < samples; ++k) {
    sim.run(t.steps_each);
    path.z.push_back(place(sim)), path.v.push_back(velocity(sim) * t.half);
  }
  return path;
}
/// The same by GSL: place, velocity, r n x w and sliding spring, which turns with the table.
static Path reference_path(const Turn& t) {
  const Resting& c = t.c;
  Ode ode(
      [&](double, const double* y, double* dydt) {
        const Complex *a = reinterpret_cast<const Complex*>(y), slip = a[1] - I * t.W * a[0] + a[2];
        const Complex f = -(c.ks * a[3] + c.cs * slip);
        Complex* d = reinterpret_cast<Complex*>(dydt);
        d[0] = a[1], d[1] = f / c.m, d[2] = (c.q - 1) * f / c.m, d[3] = I * t.W * a[3] + slip;
      },
      {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 1e-6, 1e-6}, 1e-10);
  const Complex s = I * t.W * z0 - v0;
  std::vector<double> y = {z0.real(), z0.imag(), v0.real(), v0.imag(), s.real(), s.imag(), 0, 0};
  Path path{{z0}, {v0}};
  double now = 0;
  for (int k = 1; k <= samples; ++k) {
    ode.advance(now, y, t.period * k / samples, {}, 1e-4);
    path.z.push_back({y[0], y[1]}), path.v.push_back({y[2], y[3]});
  }
  return path;
}
/// Largest distance of two paths over the radius of the circle.
static double distance(const Path& a, const Path& b, const Turn& t) {
  double worst = 0;
  for (size_t k = 0; k < a.z.size(); ++k)
    worst = std::max(worst, std::abs(a.z[k] - b.z[k]) * std::abs(t.Omega / v0));
  return worst;
}
/// z = centre + factor v, least squares.
static void fit_circle(const Path& p, Complex& centre, Complex& factor) {
  const double n = double(p.z.size());
  Complex sz = 0, sv = 0, szv = 0, svv = 0;
  for (size_t k = 0; k < p.z.size(); ++k) {
    sz += p.z[k], sv += p.v[k];
    szv += std::conj(p.v[k]) * p.z[k], svv += std::norm(p.v[k]);
  }
  factor = (szv - std::conj(sv) * sz / n) / (svv - std::norm(sv) / n);
  centre = (sz - factor * sv) / n;
}
static void circles(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "circles.csv", "W_per_s,x_m,y_m,exact_x_m,exact_y_m");
  double rate = 0, centre_off = 0, radius = 0, loss = 0, still = 0;
  for (const double W : {5.0, -5.0}) {
    const Turn t(W, "consistent", 1);
    const Path a = solver_path(t);
    Complex centre, factor;
    fit_circle(a, centre, factor);
    double angle = 0;  // through which the velocity has turned
    for (size_t k = 1; k < a.v.size(); ++k) angle += std::arg(a.v[k] / a.v[k - 1]);
    const double R0 = std::abs(v0 / t.Omega);
    rate = largest(rate, angle / (t.Omega * t.period) - 1);
    centre_off = std::max(centre_off, std::abs(centre - (z0 + I * v0 / t.Omega)) / R0);
    radius = std::max(radius, std::abs(factor * I * t.Omega - 1.0));
    loss = largest(loss, std::log(std::abs(a.v.front() / a.v.back())));
    for (const Complex z : solver_path(t, 0).z) still = std::max(still, std::abs(z - z0) / R);
    for (size_t k = 0; k < a.z.size(); ++k) {
      const Complex e =
          z0 + I * v0 / t.Omega *
                   (1.0 - std::exp(I * (2 * pi * double(k) / samples * (W > 0 ? 1.0 : -1.0))));
      csv.row(W, a.z[k].real(), a.z[k].imag(), e.real(), e.imag());
    }
  }
  metrics("table_rate", rate), metrics("table_centre", centre_off);
  metrics("table_radius", radius), metrics("table_loss", loss);
  metrics("table_rest", still);
}
/// Error of the turntable over the time step.
static void table_steps(const Arguments& run, Metrics& metrics) {
  Work work(run.out);
  const Path exact = reference_path(Turn(5, "consistent", 1));
  std::vector<double> steps, errors;
  for (double divisor = 1; divisor <= (run.quick ? 4 : 64); divisor *= 2)
    for (const char* scheme : {"consistent", "paper"}) {
      if (run.quick && scheme[0] == 'p') continue;
      const Turn t(5, scheme, divisor);
      const Timer timer;
      const double error = distance(solver_path(t), exact, t);
      work(scheme, 1 / divisor, double(samples * t.steps_each), timer.seconds(), error);
      if (scheme[0] == 'p' || divisor > 4) continue;
      if (divisor == 1) metrics("table_error_dt0", error);
      steps.push_back(1 / divisor), errors.push_back(error);
    }
  metrics("table_order", order(steps, errors));
}
/// A sphere on the axis is taken along by twisting friction.
static void spin_up(Metrics& metrics) {
  const double W = 40;
  const Resting c(turning(W) + "mut = 0.2");
  Simulation s = on_table(c, 0, 0, {});
  std::vector<double> t, w;
  for (const double due = W / (2.5 * 0.2 * g / R); double(s.time()) < 0.8 * due;) {
    s.run(1);
    if (double(s.time()) > 0.2 * due)
      t.push_back(double(s.time())), w.push_back(double(s.particles()[0].w.z));
  }
  metrics("spin_up_rate", std::abs(slope(t, w) / (2.5 * 0.2 * g / R) - 1));
  s.run(std::lround(0.3 / double(c.p.dt)));
  metrics("spin_up_end", std::abs(double(s.particles()[0].w.z) / W - 1));
}

// --------------------------------------------------------------------------- at rest on the table

/// Radius and angle by which the sphere lags over time, spin over W at the end.
struct Carried {
  std::vector<double> t{}, rho{}, lag{};
  double spin = 0, away = 0;
};
const double rho0 = 0.1, W_rest = 5;  // m, 1/s
/// The velocity, half a step before t = 0, of what turns with the table and is at rho then.
static Complex circling(const Resting& c, double W, double rho) {
  return I * W * rho * std::exp(-I * W * double(c.p.dt) / 2.0);
}
static Resting carried_contact(double divisor) {
  return Resting(turning(W_rest) + "mus = 0.5; mur = 0.5; mut = 0.5", divisor);
}
static Carried carried(double divisor, double turns) {
  const Resting c = carried_contact(divisor);
  Simulation s = on_table(c, rho0, circling(c, W_rest, rho0), {0, 0, real(W_rest)});
  Carried a{{0}, {rho0}, {0}};
  const long each = std::lround(2 * pi / W_rest / 40 / double(c.p.dt));
  for (int k = 0; k < 40 * turns; ++k) {
    s.run(each);
    const Complex z = place(s) * std::exp(-I * W_rest * double(s.time()));
    a.t.push_back(double(s.time())), a.rho.push_back(std::abs(z));
    a.lag.push_back(-std::arg(z)), a.away = std::max(a.away, std::abs(z - rho0) / rho0);
  }
  a.spin = double(s.particles()[0].w.z) / W_rest;
  return a;
}
static void at_rest(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "carried.csv", "divisor,turns,lag,closed");
  const Resting c = carried_contact(1);
  const double soft = c.m * W_rest * W_rest * (1 / c.ks + c.r / (R * c.kn));  // stretch over rho
  std::vector<double> steps, lags;
  double lag = 0;
  for (const double divisor : {0.25, 0.5, 1.0, 2.0}) {
    if (run.quick && divisor != 0.5 && divisor != 1) continue;
    const Carried a = carried(divisor, 10);
    const double h = double(c.p.dt) / divisor, slow = W_rest - 2 / h * std::atan(W_rest * h / 2);
    for (size_t k = 0; k < a.t.size(); k += 10)
      csv.row(divisor, a.t[k] * W_rest / (2 * pi), a.lag[k], slow * a.t[k]);
    if (divisor <= 1) lag = largest(lag, a.lag.back() / (slow * a.t.back()) - 1);
    if (divisor == 0.5 || divisor == 1)
      steps.push_back(1 / divisor), lags.push_back(a.lag.back());
    if (divisor != 1) continue;
    metrics("carried_stretch", std::abs((a.rho.back() / rho0 - 1) / (soft / (1 - soft)) - 1));
    metrics("carried_ten_turns", a.away), metrics("carried_spin", std::abs(a.spin - 1));
  }
  metrics("carried_lag", lag), metrics("carried_order", order(steps, lags));
}
/// Is a sphere at the radius rho left behind? Its weight shrinks slowly from three times its own,
/// so that no oscillation reaches the limit before the static load does.
static bool leaves(const std::string& friction, double W, double rho) {
  const Resting c(turning(W) + friction, 8, 3);
  Simulation s = on_table(c, rho, circling(c, W, rho), {0, 0, real(W)});
  const long n = std::lround(0.3 / 200 / double(c.p.dt));
  for (double k = 1; k <= 200; ++k) {
    const double share = k / 200, eased = share * share * (3 - 2 * share);
    s.p.g.z = real(-g * (3 - 2 * eased)), s.run(n);
  }
  s.run(std::lround(0.1 / double(c.p.dt)));
  const double before = std::abs(place(s)), t = double(s.time());
  s.run(std::lround(0.02 / double(c.p.dt)));
  return std::abs(place(s)) - before > 1e-4 * (double(s.time()) - t);  // outwards, 0.1 mm/s
}
static void limits(Metrics& metrics) {
  double worst = 0;
  const double r = Resting("").r, W = 3;
  for (const bool rolls : {false, true}) {
    const std::string friction = rolls ? "mus = 0.6; mur = 0.3" : "mus = 0.3; mur = 0.6";
    const double expected = g / (W * W) * 0.3 * (rolls ? R / r : 1);
    double low = 0.9 * expected, high = 1.1 * expected;
    for (int k = 0; k < 13; ++k) {
      const double middle = (low + high) / 2;
      (leaves(friction, W, middle) ? high : low) = middle;
    }
    worst = largest(worst, low / expected - 1);
  }
  metrics("carried_limit", worst);
}

int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  below_one_g(metrics), above_one_g(run, metrics), vibration_steps(run, metrics);
  belt(run, metrics);
  circles(run, metrics), table_steps(run, metrics), spin_up(metrics);
  at_rest(run, metrics), limits(metrics);
  if (!run.quick) write_vibration(run);
}
