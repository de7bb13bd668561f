// Hard cases: the ends of every range, and what a user may try on purpose. Each has a closed form or a
// reason; 26_hard_cases.toml has the table.
//
// Two of them need a formula:
//   Column of N equal spheres at rest on a plate: sphere k carries the weight of n = N - k spheres, so
//   delta = (n m g/K)^(2/3), with K of the wall for the lowest, K/(2 sqrt 2) between particles.
//   Deep overlap, e_n = 1: the elastic energy 2/5 K delta^(5/2) becomes kinetic.
#include <random>

#include "support.hpp"

using namespace verification;

static const double R = 0.005, g = 9.81;
static double mass(double rho, double r) { return 4 * pi / 3 * rho * r * r * r; }
/// Force over overlap^1.5 of a sphere and a wall.
static double wall_stiffness(const Parameters& p, double r) {
  return 4 * double(p.E) / (3 * (1 - double(p.nu) * double(p.nu))) * std::sqrt(r);
}
static Parameters material(const std::string& more) { return scene("Rmin = 0.005; Rmax = 1" + more); }
static double largest(double a, double b) { return std::max(a, std::abs(b)); }

// ------------------------------------------------------------------------- how large may a step be?

/// 27 equal spheres fall into a box at 0.5 m/s, which means overlaps of 10 %, and come to rest. With a
/// step that is too large energy appears: a tenth of what they had, or the run stops, or they never
/// rest (which without friction takes too long to wait for).
static bool unstable(double en, double mu, double times, unsigned seed) {
  Parameters p = material("; g = 0,0,-9.81; orientation = off" + setting("en", real(en)) +
                          setting("mus", real(mu)) + setting("mur", real(mu)));
  const double dt = double(p.dt), a = 6.6 * R;
  p.dt = real(times * dt);
  Mesh box;
  for (const double z : {0.0, 40 * R})
    for (int k = 0; k < 4; ++k)
      box.vertices.push_back({real(k % 3 ? a : 0), real(k > 1 ? a : 0), real(z)});
  box.elements = {{4, {0, 1, 2, 3}, 0}, {4, {4, 5, 6, 7}, 0}};
  for (int k = 0; k < 4; ++k) box.elements.push_back({4, {k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4}, 0});
  std::mt19937 bits(seed);
  const auto any = [&] { return (double(bits()) / 4294967296.0 - 0.5) * 0.15 * R; };
  tinydem::vector<Particle> all;
  for (int k = 0; k < 27; ++k)
    all.push_back(ball({real((1.1 + 2.2 * (k % 3)) * R + any()), real((1.1 + 2.2 * (k / 3 % 3)) * R + any()),
                        real((1.1 + 2.2 * (k / 9)) * R)}, real(R), {0, 0, real(-0.5)}));
  try {
    Simulation sim(p, box, all);
    const double m = 27 * mass(1000, R), scale = m * (0.125 + 2 * g * R);  // kinetic and potential
    const double start = double(sim.summary().energy());
    for (int k = 0; k < 30; ++k) {
      sim.run(std::lround(0.5 / 30 / double(p.dt)));
      if (!(double(sim.summary().energy()) < start + 0.1 * scale)) return true;
    }
    if (en == 1 || mu == 0) return false;
    const auto s = sim.summary();
    return double(s.kinetic + s.rotational) > 2e-3 * scale;
  } catch (const tinydem::RunError&) { return true; }
}
/// The largest step in units of Eq. (50): the middle of the first unstable one and the one below.
static double step_limit(double en, double mu, double ratio, unsigned seeds) {
  double x = 1;
  const auto bad = [&](double times) {
    for (unsigned seed = 1; seed <= seeds; ++seed)
      if (unstable(en, mu, times, seed)) return true;
    return false;
  };
  while (x < 12 && !bad(x)) x *= ratio;
  return x / std::sqrt(ratio);
}
/// A fit in a few numbers, for a warning.
static double limit_formula(double en, double mu) {
  const double beta = en > 0 ? -std::log(en) / std::hypot(std::log(en), pi) : 1;
  return 4.8 * (1 - beta / 2) / (1 + std::min(mu, 3.0) / 5);
}
static void step_limits(const Arguments& run, Metrics& metrics) {
  Csv csv(run.out / "steps.csv", "en,mu,limit,formula");
  double smallest = 1e9, largest_ = 0, least = 1e9;
  for (const double mu : {0.0, 0.1, 0.3, 1.0, 3.0, 1000.0})
    for (const double en : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
      if (run.quick && (mu != 0.3 || (en != 0.1 && en != 0.5 && en != 0.9))) continue;
      const double x = step_limit(en, mu, 1.12, run.quick ? 1 : 2), y = limit_formula(en, mu);
      csv.row(en, mu, x, y);
      least = std::min(least, x);
      smallest = std::min(smallest, x / y), largest_ = std::max(largest_, x / y);
    }
  Csv head_on(run.out / "head_on.csv", "en,dt_over_eq50,smallest,largest");
  for (const double en : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
    for (double x = 1; x <= 8 && !run.quick; x += 0.25) {
      double low = 1e9, high = -1e9;
      for (double phase = 0; phase < 1; phase += 0.05) {
        Parameters p = material("; E = 1e6" + setting("en", real(en)));
        p.dt *= real(x);
        double e = 0;
        try {
          Simulation sim = on_plate(p, real(R), {0, 0, -1}, {}, real(-double(p.dt) * (0.01 + phase)));
          sim.run(200), e = double(sim.particles()[0].v.z);
        } catch (const tinydem::RunError&) { e = 3; }
        low = std::min(low, e), high = std::max(high, e);
      }
      head_on.row(en, x, low, high);
    }
  metrics("step_limit_least", least);
  metrics("step_limit_smallest", smallest), metrics("step_limit_largest", largest_);
}

// -------------------------------------------------------------------------------- ends of the ranges

/// Speed of a sphere after an impact at 1 m/s on the plate, and its largest overlap over R.
static double rebound(const Parameters& p, double r, double divisor = 1, double* angular = nullptr) {
  Parameters fine = p;
  fine.dt = real(eq50(p, r) / divisor);
  Simulation sim = on_plate(fine, real(r), {0, 0, -1}, {}, real(-0.003 * r));
  sim.run(std::lround(60 * divisor));
  if (angular) *angular = double(norm(sim.particles()[0].w));
  return double(sim.particles()[0].v.z);
}
static void ranges(Metrics& metrics) {
  for (const auto& [name, en, divisor] : {std::tuple("en_0", 0.0, 1.0), {"en_1e-6", 1e-6, 1000.0}, {"en_1", 1.0, 10.0}})
    metrics(name, std::abs(rebound(material("; E = 1e8" + setting("en", real(en))), R, divisor) - en));
  double nu_rebound = 0, nu_slide = 0;
  for (const double nu : {-0.9, -0.5, 0.0, 0.3, 0.5}) {
    const Parameters p = material("; E = 1e8; en = 0.5; mus = 0.1; mur = 0; mut = 0" + setting("nu", real(nu)));
    nu_rebound = largest(nu_rebound, rebound(p, R, 100) - 0.5);
    Parameters fine = p;
    fine.dt = real(eq50(p, R) / 100);
    Simulation sim = on_plate(fine, real(R), {5, 0, -1}, {}, real(-0.003 * R));
    sim.run(6000);
    // gross sliding, Coulomb: mu v_n (1 + 2 e_c - e_n), with e_c of the pushing part of the impact
    const double beta = 1 / std::sqrt(1 + std::pow(pi / std::log(0.5), 2)), s = std::sqrt(1 - beta * beta),
                 ec = std::exp(-2 * beta / s * std::acos(beta));
    nu_slide = largest(nu_slide, (5 - double(sim.particles()[0].v.x)) / (0.1 * (1 + 2 * ec - 0.5)) - 1);
  }
  metrics("nu_rebound", nu_rebound), metrics("nu_sliding", nu_slide);
}
static Particle oblique(const std::string& friction, double divisor) {
  Parameters p = material("; E = 1e8; en = 1" + friction);
  p.dt /= real(divisor);
  Simulation sim = on_plate(p, real(R), {1, 0, -1}, {0, 0, 10}, real(-0.003 * R));
  sim.run(std::lround(60 * divisor));
  return sim.particles()[0];
}
static double energy(const Particle& a, double r) {
  return double(square(a.v)) + 0.4 * r * r * double(square(a.w));
}
static void friction(Metrics& metrics) {
  const Particle smooth = oblique("; mus = 0; mur = 0; mut = 0", 1);
  metrics("mu_0", largest(double(smooth.v.x) - 1, double(norm(smooth.w - Vec3{0, 0, 10}))));
  double gain = 0;
  for (const char* mu : {"3", "1000"})
    for (const double divisor : {1.0, 10.0}) {
      const std::string m = mu;
      const double e = energy(oblique("; mus = " + m + "; mur = " + m + "; mut = " + m, divisor), R);
      gain = std::max(gain, e / (2 + 0.4 * R * R * 100) - 1);
    }
  metrics("mu_energy_gain", gain);
  const Particle a = oblique("; mus = 1e3; mur = 1e3; mut = 1e3", 1), b = oblique("; mus = 1e9; mur = 1e9; mut = 1e9", 1);
  metrics("mu_1e3", double(norm(a.v - b.v) + norm(a.w - b.w)));
}
static void size_ratios(Metrics& metrics) {
  double rebound_off = 0, momentum = 0;
  for (const double ratio : {1.0, 10.0, 100.0})
    for (const bool wall : {false, true}) {
      Parameters p = material("; E = 1e8; en = 0.5; mus = 0.3; mur = 0.3" + setting("Rmax", real(ratio)));
      p.dt = real(eq50(p, R) / 20);
      const double big = ratio * R, offset = wall ? 0.3 * R : 0, M = ratio * ratio * ratio;
      const double h = std::sqrt(std::pow(1.003 * R + big, 2) - offset * offset);
      Simulation sim(p, {}, {ball({real(offset), 0, real(h)}, real(R), {0, 0, -1}), ball({}, real(big))});
      sim.run(2400);
      const Particle a = sim.particles()[0], b = sim.particles()[1];
      if (!wall) rebound_off = largest(rebound_off, double(a.v.z - b.v.z) - 0.5);
      momentum = largest(momentum, double(norm(a.v + real(M) * b.v - Vec3{0, 0, -1})));
    }
  metrics("ratio_rebound", rebound_off), metrics("ratio_momentum", momentum);
}

// ------------------------------------------------------------------------------------------- scales

/// 27 spheres fall on a plate, in units of length L, modulus E and density rho: dimensionless result.
static std::vector<double> scaled(double L, double E) {
  const double rho = 1000, v = std::sqrt(E / rho) / 30, G = 1e-4 * E / (rho * L);
  Parameters p = scene("mus = 0.3; mur = 0.1; eta = " + tinydem::text(real(1e-4 * L * std::sqrt(E * rho))) +
                       "; g = 0,0," + tinydem::text(real(-G)) + setting("E", real(E)) + setting("Rmax", real(2 * L)) +
                       setting("Rmin", real(L)));
  std::mt19937 bits(3);
  const auto any = [&](double size) { return real((double(bits()) / 4294967296.0 - 0.5) * size); };
  tinydem::vector<Particle> all;
  for (int k = 0; k < 27; ++k)
    all.push_back({{real(2.7 * L * (k % 3)), real(2.7 * L * (k / 3 % 3)), real(2.7 * L * (k / 9 + 0.5))},
                   real((1 + 0.3 * (k % 4) / 4) * L), {any(v), any(v), real(-v)}, {1, 0, 0, 0},
                   {any(v / L), any(v / L), any(v / L)}});
  Simulation sim(p, plate(real(100 * L)), all);
  sim.run(400);
  std::vector<double> result;
  for (const Particle& a : sim.particles())
    for (const real* c = &a.x.x; c <= &a.w.z; ++c) {
      const auto n = c - &a.x.x;
      result.push_back(double(*c) / (n < 4 ? L : n < 7 ? v : n < 11 ? 1 : v / L));
    }
  return result;
}
static void scales(const Arguments& run, Metrics& metrics) {
  const auto unit = scaled(1, 1e6);
  double off = 0;
  for (const double L : {1e-9, 1e-6, 1e-3, 1e3, 1e9})
    for (const double E : {1.0, 1e6, 1e12}) {
      if (run.quick && E == 1e6 && L != 1e-3) continue;
      const auto other = scaled(L, E);
      for (size_t k = 0; k < unit.size(); ++k) off = largest(off, other[k] - unit[k]);
    }
  metrics("scale", off);
}

// ------------------------------------------------------------------------------------- long and many

static void column(Metrics& metrics) {
  const int N = 1000;
  Parameters p = material("; E = 1e9; g = 0,0,-9.81; mus = 0.3; mur = 0.3");
  const double m = mass(1000, R), K = wall_stiffness(p, R);
  std::vector<double> overlap;
  tinydem::vector<Particle> all;
  double z = 0;
  for (int k = 0; k < N; ++k) {
    overlap.push_back(std::pow((N - k) * m * g / (k == 0 ? K : K / (2 * std::sqrt(2.0))), 2.0 / 3));
    z += (k == 0 ? R : 2 * R) - overlap.back();
    all.push_back(ball({0, 0, real(z)}, real(R)));
  }
  Simulation sim(p, plate(1), all);
  sim.run(10000);
  double off = 0, sideways = 0, speed = 0;
  const auto now = sim.particles();
  for (int k = 0; k < N; ++k) {
    const double d = k == 0 ? R - double(now[0].x.z) : 2 * R - double(now[k].x.z - now[k - 1].x.z);
    off = largest(off, d / overlap[size_t(k)] - 1);
    sideways = largest(largest(sideways, double(now[k].x.x)), double(now[k].x.y));
    speed = std::max(speed, double(norm(now[k].v)));
  }
  metrics("column_overlap", off), metrics("column_sideways", sideways), metrics("column_speed", speed);
}
static void heap(const Arguments& run, Metrics& metrics) {
  Parameters p = material("; g = 0,0,-9.81; mus = 0.5; mur = 0.5; orientation = off");
  tinydem::vector<Particle> all;
  for (int layer = 0; layer < 3; ++layer)  // 9, 4 and 1 spheres
    for (int k = 0; k < (3 - layer) * (3 - layer); ++k)
      all.push_back(ball({real((layer + 2.0 * (k % (3 - layer))) * R), real((layer + 2.0 * (k / (3 - layer))) * R),
                          real((1 + 1.42 * layer) * R)}, real(R)));
  Simulation sim(p, plate(1), all);
  sim.run(30000);
  metrics("heap_top", double(sim.particles()[13].x.z) / R);
  const auto start = sim.particles();
  const auto before = sim.summary();
  const long steps = run.quick ? 200000 : 10000000;
  sim.run(steps);
  const auto end = sim.particles();
  double creep = 0;
  for (int k = 0; k < 14; ++k) creep = std::max(creep, double(norm(end[k].x - start[k].x)) / R);
  const auto after = sim.summary();
  metrics("heap_creep", creep), metrics("heap_kinetic", double(after.kinetic + after.rotational) / (mass(1000, R) * g * R));
  metrics("heap_energy", std::abs(double(after.energy() - before.energy())) / (mass(1000, R) * g * R));
}
static void spin(Metrics& metrics) {
  const double w = 1e5;
  Parameters p = material("; E = 1e8; en = 0.5; mus = 0.1; mur = 0; mut = 0");
  Simulation free(p, {}, {ball({}, real(R), {}, {0, 0, real(w)})});
  free.run(100000);
  const Particle a = free.particles()[0];
  const double angle = std::fmod(100000.0 * double(p.dt) * w / 2, 2 * pi);
  metrics("spin_free", largest(double(a.w.z) / w - 1, double(a.q[0]) - std::cos(angle)));
  p.dt = real(eq50(p, R) / 100);
  Simulation sim = on_plate(p, real(R), {0, 0, -1}, {0, real(w), 0}, real(-0.003 * R));
  sim.run(6000);
  const double beta = 1 / std::sqrt(1 + std::pow(pi / std::log(0.5), 2)), s = std::sqrt(1 - beta * beta),
               ec = std::exp(-2 * beta / s * std::acos(beta)), closed = 0.1 * (1 + 2 * ec - 0.5);
  metrics("spin_impact", std::abs(double(sim.particles()[0].v.x) / closed - 1));
}

// -------------------------------------------------------------------------------- nothing, too much

static void counts(const Arguments& run, Metrics& metrics) {
  Parameters p = material("; g = 0,0,-9.81");
  double wrong = 0;
  for (const Mesh& mesh : {Mesh(), plate(1)}) {
    Simulation none(p, mesh);
    none.run(1000);
    wrong += none.size() != 0 || none.steps != 1000 || none.summary().energy() != 0 || !none.contacts().empty();
  }
  metrics("no_particles", wrong);
  Simulation one(p, {}, {ball({}, real(R))});
  one.run(1000);
  const double t = 1000 * double(p.dt);
  metrics("one_particle", std::abs(double(one.particles()[0].x.z) / (-g / 2 * t * (t + double(p.dt))) - 1));
  // what is far away changes nothing
  const double far = 1e9 * 2 * R;
  const Particle near = ball({0, 0, real(2 * R)}, real(R), {1, 0, -1}), other = ball({real(far), 0, real(2 * R)}, real(R), {0, 0, 1});
  Simulation alone(p, plate(1), {near}), both(p, plate(1), {near, other});
  alone.run(2000), both.run(2000);
  metrics("far_away", double(norm(alone.particles()[0].x - both.particles()[0].x) + norm(alone.particles()[0].w - both.particles()[0].w)));
  // a spawn box that has no room left
  Parameters full = scene("Rmin = 0.01; Rmax = 0.01; smin = -0.03,-0.03,0.2; smax = 0.03,0.03,0.26; v0 = 0,0,0; Nmax = 1000; Nspawn = 1000");
  Simulation spawning(full);
  spawning.run(run.quick ? 300 : 3000);
  double overlap = 0;
  const auto all = spawning.particles();
  for (const Particle& a : all)
    for (const Particle& b : all)
      if (&a != &b) overlap = std::max(overlap, double(a.R + b.R - norm(a.x - b.x)));
  metrics("spawn_overlap", overlap);
  metrics("spawn_share", double(all.size()) * 4 * pi / 3 * 1e-6 / std::pow(0.06 + 0.02, 3));
}
static void million(const Arguments& run, Metrics& metrics) {
  const int n = run.quick ? 200 : 708;
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      mesh.vertices.push_back({real(2.0 * i / n - 1), real(2.0 * j / n - 1), 0});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      mesh.elements.push_back({3, {v, v + 1, v + n + 2, 0}, 0});
      mesh.elements.push_back({3, {v, v + n + 2, v + n + 1, 0}, 0});
    }
  const Parameters p = material("; g = 0,0,-9.81; mus = 0.3; mur = 0.1");
  const Particle start = ball({real(-0.101), real(0.203), real(1.5 * R)}, real(R), {1, real(-0.5), -1}, {20, 30, 40});
  Simulation one(p, plate(1), {start}), many(p, mesh, {start});
  one.run(1000), many.run(1000);
  const Particle a = one.particles()[0], b = many.particles()[0];
  metrics("mesh_difference", largest(double(norm(a.v - b.v)), double(norm(a.x - b.x)) / R));
}
/// Exactly above or on vertices, edges and seams; centres that lie in the mesh are refused.
static void exactly(Metrics& metrics) {
  const Mesh square{{{-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}},
                    {{3, {0, 1, 2, 0}, 0}, {3, {0, 2, 3, 0}, 0}, {4, {1, 4, 5, 2}, 0}}};
  double wrong = 0, refused = 0, places = 0;
  for (const Vec3& at : {Vec3{0, 0, 0}, Vec3{-1, -1, 0}, Vec3{0, 1, 0}, Vec3{real(-0.5), 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, 0}}) {
    const Parameters p = material("; en = 1; mus = 0; mur = 0; mut = 0");
    Simulation sim(p, square, {ball(at + Vec3{0, 0, real(0.99 * R)}, real(R))});
    wrong += sim.contacts().size() != 1;
    sim.run(200);
    const Vec3 v = sim.particles()[0].v;
    wrong += v.x != 0 || v.y != 0 || !(v.z > 0);  // straight up
    ++places;
    try { Simulation(p, square, {ball(at, real(R))}); } catch (const tinydem::InputError&) { ++refused; }
  }
  metrics("exact_places", wrong), metrics("exact_refused", places - refused);
}
static void deep(Metrics& metrics) {
  double off = 0;
  for (const double delta : {0.1, 0.5, 0.99}) {
    Parameters p = material("; en = 1; mus = 0; mur = 0; mut = 0");
    p.dt /= 10;
    Simulation sim = on_plate(p, real(R), {}, {}, real(delta * R));
    sim.run(2000);
    const double v = std::sqrt(0.8 * wall_stiffness(p, R) * std::pow(delta * R, 2.5) / mass(1000, R));
    off = largest(off, double(sim.particles()[0].v.z) / v - 1);
  }
  metrics("deep_speed", off);
  double accepted = 0;
  for (const double delta : {1.001, 1.5, 2.0})
    try {
      two_spheres(material(""), real(R), real(3 * R), {}, real(delta * R)), ++accepted;
    } catch (const tinydem::InputError&) {}
  metrics("too_deep", accepted);
}

int main(int argc, char** argv) {
  const Arguments run(argc, argv);
  Metrics metrics(run.out);
  step_limits(run, metrics);
  ranges(metrics), friction(metrics), size_ratios(metrics), scales(run, metrics);
  column(metrics), heap(run, metrics), spin(metrics);
  counts(run, metrics), million(run, metrics), exactly(metrics), deep(metrics);
}
