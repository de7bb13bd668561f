// Case 13: a sphere on a plate that rolls, twists, spins in place or slides until it rolls. It lies
// at its static overlap, so N = m g and the lever arm r = R - delta/2 is constant. Newton's laws
// give
//   rolling without sliding  dv/dt = -mu_r g r R/(r^2 + 0.4 R^2)  (torque R mu_r N, momentum about
//                            the contact m v r + 0.4 m R^2 w, v = r w)
//   spin without sliding friction  dw/dt = -2.5 mu_r g/R
//   twisting                 dw/dt = -2.5 mu_t g/R
//   sliding                  dv/dt = -mu_s g, R dw/dt = 2.5 mu_s g r/R, until v = r w:
//                            t_s = v0/(mu_s g q), q = 1 + 2.5 r^2/R^2, v = v0 (q - 1)/q
//   and then                 the spring lets go: the contact swings, with v_s = v - r w and u from
//                            L/k: du/dt = v_s, m dv_s/dt = -q (k u + c v_s), v = v_end + v_s/q.
//
// The printed update loses a part of the kinetic friction. In steady slip the trial force after a
// clipped step is -L + c (v - v'), below the limit L; so every second step is static and its force
// is smaller by c |v - v'| = c q L dt/m, where q L/m is the deceleration of the contact. The mean
// friction is short of L by (q/2) c dt/m: q = 1 + 2.5 r^2/R^2 (slide), 2.5 r/R (spin), 2.5 (twist).
#include "impacts.hpp"

using namespace verification;

const double R = 0.01, g = 9.81;  // m, m/s^2

/// A sphere of R = 1 cm at its static overlap, and the coefficients of its contact.
struct Resting {
  Parameters p;
  double m, delta, r, q, ks, cn, cs;
  Resting(const std::string& text, const std::string& scheme, double divisor)
      : p(scene("g = 0,0,-9.81; Rmin = 0.01; " + text + "; scheme = " + scheme)) {
    p.dt /= real(divisor);
    const double E = double(p.E), nu = double(p.nu), e = std::log(double(p.en));
    const double beta = -e / std::sqrt(e * e + pi * pi);
    m = 4 * pi / 3 * double(p.rho) * R * R * R;
    delta = std::pow(0.75 * m * g * (1 - nu * nu) / (E * std::sqrt(R)), 2.0 / 3);
    r = R - delta / 2, q = 1 + 2.5 * r * r / (R * R);
    const double a = std::sqrt(R * delta);
    const double kn = 4.0 / 3 * E / (1 - nu * nu) * a;
    ks = 4 * E / ((1 + nu) * (2 - nu)) * a;
    cn = beta * std::sqrt(5 * m * kn), cs = beta * std::sqrt(m * ks / 6);
  }
  Simulation start(double v, const Vec3& w) const {
    return on_plate(p, real(R), {real(v), 0, 0}, w, real(delta));
  }
};

/// Velocity and spins over time.
struct Track {
  std::vector<double> t{}, v{}, wy{}, wz{};
  void add(const Simulation& s) {
    const Particle a = s.particles()[0];
    t.push_back(double(s.time())), v.push_back(double(a.v.x));
    wy.push_back(double(a.w.y)), wz.push_back(double(a.w.z));
  }
};
Track follow(Simulation s, double duration, long samples = 200) {
  Track track;
  track.add(s);
  const long all = std::lround(duration / double(s.p.dt));
  for (long k = 1; k <= samples; ++k) {
    s.run(all * k / samples - all * (k - 1) / samples);
    track.add(s);
  }
  return track;
}
/// Slope of the middle of a curve, where the friction has built up and not yet ended.
double middle_slope(const std::vector<double>& t, const std::vector<double>& y) {
  const auto n = std::ptrdiff_t(t.size());
  return slope({t.begin() + n / 5, t.begin() + 4 * n / 5},
               {y.begin() + n / 5, y.begin() + 4 * n / 5});
}

/// The four motions: what decelerates, and its closed form.
enum Motion { roll, spin, twist, slide };
const char* const names[] = {"roll", "spin", "twist", "slide"};
struct Result {
  Track track;
  double measured, expected, deficit;
};
Result run(Motion motion, const std::string& scheme, double divisor) {
  const char* texts[] = {"mus = 0.6; mur = 0.1; mut = 0", "mus = 0; mur = 0.1; mut = 0",
                         "mus = 0.3; mur = 0; mut = 0.2", "mus = 0.3; mur = 0; mut = 0"};
  const Resting s(texts[motion], scheme, divisor);
  const double r = s.r, dt = double(s.p.dt), inertia = r * r + 0.4 * R * R;
  const auto result = [&](const Track& track, const std::vector<double>& y, double expected,
                          double deficit) {
    return Result{track, -middle_slope(track.t, y), expected, deficit};
  };
  if (motion == roll) {
    const Track t = follow(s.start(0.3, {0, real(0.3 / r), 0}), 0.2);
    return result(t, t.v, 0.1 * g * r * R / inertia, 0);
  }
  if (motion == spin) {
    const Track t = follow(s.start(0, {0, 40, 0}), 0.12);
    return result(t, t.wy, 2.5 * 0.1 * g / R, 1.25 * r / R * s.cn * dt / s.m);
  }
  if (motion == twist) {
    const Track t = follow(s.start(0, {0, 0, 60}), 0.1);
    return result(t, t.wz, 2.5 * 0.2 * g / R, 1.25 * s.cs * dt / s.m);
  }
  const Track t = follow(s.start(1, {}), 0.09);
  return result(t, t.v, 0.3 * g, s.q / 2 * s.cs * dt / s.m);
}

/// Sliding until it rolls: the velocity afterwards over its closed form, and the rms distance of
/// the whole curve from the closed form.
struct Transition {
  Track track;
  double v_end, rms;
};
double closed_v(const Resting& s, double v0, double t) {
  const double mu = double(s.p.mus), t_s = v0 / (mu * g * s.q);
  if (t < t_s) return v0 - mu * g * t;
  const double omega2 = s.q * s.ks / s.m, decay = s.q * s.cs / (2 * s.m), u = mu * s.m * g / s.ks;
  const double swing = std::sqrt(omega2 - decay * decay);
  const double v_s =
      -u * omega2 / swing * std::exp(-decay * (t - t_s)) * std::sin(swing * (t - t_s));
  return v0 * (s.q - 1) / s.q + v_s / s.q;
}
Transition transition(const std::string& scheme, double divisor) {
  const Resting s("mus = 0.3; mur = 0; mut = 0", scheme, divisor);
  Transition a{follow(s.start(1, {}), 0.15), 0, 0};
  for (size_t k = 0; k < a.track.t.size(); ++k)
    a.rms += std::pow(a.track.v[k] - closed_v(s, 1, a.track.t[k]), 2) / double(a.track.t.size());
  a.rms = std::sqrt(a.rms);
  a.v_end = a.track.v.back() / ((s.q - 1) / s.q) - 1;
  return a;
}

void write_tracks(const Arguments& arguments) {
  Csv csv(arguments.out / "tracks.csv", "motion,method,time_s,v_m_per_s,surface_m_per_s,wz_per_s");
  Csv closed(arguments.out / "closed.csv", "time_s,v_m_per_s,surface_m_per_s");
  for (const char* scheme : schemes) {
    const auto put = [&](const std::string& name, const Track& t) {
      for (size_t k = 0; k < t.t.size(); ++k)
        csv.row(name, scheme, t.t[k], t.v[k], R * t.wy[k], t.wz[k]);
    };
    for (const Motion motion : {roll, spin, twist})
      put(names[motion], run(motion, scheme, 1).track);
    put("transition", transition(scheme, 1).track);
  }
  const Resting s("mus = 0.3; mur = 0; mut = 0", "consistent", 1);
  for (double t = 0; t <= 0.15; t += 0.0003) {
    const double v = closed_v(s, 1, t);
    closed.row(t, v, 2.5 * s.r / R * (1 - v));
  }
}
void write_steps(const Arguments& arguments) {
  Csv csv(arguments.out / "steps.csv", "motion,method,divisor,deviation,predicted");
  Work work(arguments.out);
  for (double divisor = 1; divisor <= 64; divisor *= 2)
    for (const char* scheme : schemes) {
      for (const Motion motion : {roll, spin, twist, slide}) {
        const Result a = run(motion, scheme, divisor);
        csv.row(names[motion], scheme, divisor, std::abs(1 - a.measured / a.expected), a.deficit);
      }
      const Timer timer;
      const Transition a = transition(scheme, divisor);
      const double dt = double(Resting("", scheme, divisor).p.dt);
      work(scheme, 1 / divisor, 0.15 / dt, timer.seconds(), a.rms);
    }
}

int main(int argc, char** argv) {
  const Arguments arguments(argc, argv);
  Metrics metrics(arguments.out);
  for (const Motion motion : {roll, spin, twist, slide}) {
    const Result a = run(motion, "consistent", 1), b = run(motion, "paper", 1);
    metrics(std::string(names[motion]) + "_dt0", std::abs(a.measured / a.expected - 1));
    if (motion != roll)
      metrics(std::string("paper_") + names[motion] + "_deficit",
              std::abs((1 - b.measured / b.expected) / b.deficit - 1));
    else metrics("paper_roll_dt0", std::abs(b.measured / b.expected - 1));
  }
  const Transition a = transition("consistent", 1), b = transition("paper", 1);
  metrics("transition_v_end", std::abs(a.v_end)), metrics("transition_rms", a.rms);
  metrics("paper_transition_rms", b.rms);
  std::vector<double> steps, errors;
  for (const double d : {2.0, 8.0, 32.0})
    steps.push_back(1 / d), errors.push_back(transition("consistent", d).rms);
  metrics("transition_order", order(steps, errors));
  if (!arguments.quick) write_tracks(arguments), write_steps(arguments);
}
