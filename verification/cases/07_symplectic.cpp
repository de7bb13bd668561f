// Is the method symplectic, and what does that say about the energy?
//
// One step maps (x, p) to (x', p'); it is symplectic if its Jacobian J satisfies J^T O J = O with
// O = ((0, 1), (-1, 0)). This is checked with differences of the solver's own step. Then energy: a
// sphere that bounces on a plate, a chain of three between two walls, and a gas in a box; all
// elastic (e_n = 1) and without friction, so that nothing but the method can change the energy.
// Other methods: the same forces, Hertz as written down here, in a loop of three lines.
#include "one_contact.hpp"
#include "support.hpp"

using namespace verification;

namespace {
const double E = 1e6, nu = 0.3, rho = 1000;
Parameters elastic(const std::string& more = "") {
  return scene("en = 1; mus = 0; mur = 0; mut = 0; orientation = off" + more);
}
const double default_step = eq50(scene(""), 0.01);

// ------------------------------------------------------------- a chain between two walls, along z

/// Three spheres between walls at z = 0 and z = length [m]; gaps of some per cent of a radius.
struct Chain {
  double R[3] = {0.01, 0.012, 0.015}, x[3] = {0.0102, 0.0325, 0.0600}, v[3] = {0.5, -0.3, 0.1};
  double length = 0.0755;
  double mass(int i) const { return 4 * pi / 3 * rho * R[i] * R[i] * R[i]; }
};
double hertz(double delta, double Rstar, double Estar) {
  return delta > 0 ? 4. / 3 * Estar * std::sqrt(Rstar * delta) * delta : 0;
}
/// Accelerations; also the elastic energy, 2/5 of force times overlap.
double accelerate(const Chain& c, double* a) {
  const double wall = E / (1 - nu * nu), pair = wall / 2;
  double f[3] = {}, energy = 0;
  const auto push = [&](double delta, double Rstar, double Estar, int below, int above) {
    const double force = hertz(delta, Rstar, Estar);
    if (below >= 0) f[below] -= force;
    if (above >= 0) f[above] += force;
    energy += 0.4 * force * std::max(delta, 0.);
  };
  push(c.R[0] - c.x[0], c.R[0], wall, -1, 0), push(c.x[2] + c.R[2] - c.length, c.R[2], wall, 2, -1);
  for (int i = 0; i < 2; ++i)
    push(c.R[i] + c.R[i + 1] - (c.x[i + 1] - c.x[i]), c.R[i] * c.R[i + 1] / (c.R[i] + c.R[i + 1]),
         pair, i, i + 1);
  for (int i = 0; i < 3; ++i) a[i] = f[i] / c.mass(i);
  return energy;
}
double energy(const Chain& c) {
  double a[3], sum = accelerate(c, a);
  for (int i = 0; i < 3; ++i) sum += c.mass(i) / 2 * c.v[i] * c.v[i];
  return sum;
}
void step(Chain& c, Method method, double dt) {
  double a[3], b[3];
  accelerate(c, a);
  for (int i = 0; i < 3; ++i) {
    const double before = c.v[i];
    if (method == Method::velocity_verlet) c.x[i] += dt * (c.v[i] + dt / 2 * a[i]);
    else c.v[i] += dt * a[i], c.x[i] += dt * (method == Method::explicit_euler ? before : c.v[i]);
  }
  if (method != Method::velocity_verlet) return;
  accelerate(c, b);
  for (int i = 0; i < 3; ++i) c.v[i] += dt / 2 * (a[i] + b[i]);
}
/// The same chain in the solver.
Simulation simulation(const Chain& c, double dt) {
  Mesh walls = plate(1);
  for (int k = 0; k < 4; ++k)
    walls.vertices.push_back(walls.vertices[k] + Vec3{0, 0, real(c.length)});
  walls.elements.push_back({4, {4, 5, 6, 7}, 0});
  tinydem::vector<Particle> all;
  for (int i = 0; i < 3; ++i)
    all.push_back(ball({0, 0, real(c.x[i])}, real(c.R[i]), {0, 0, real(c.v[i])}));
  return Simulation(elastic(setting("dt", real(dt))), walls, all);
}
void advance(Chain& c, double dt, long steps) {
  Simulation s = simulation(c, dt);
  s.run(steps);
  const auto all = s.particles();
  for (int i = 0; i < 3; ++i) c.x[i] = double(all[i].x.z), c.v[i] = double(all[i].v.z);
}

// ----------------------------------------------------------------------------- one-step form

/// Largest element of J^T O J - O of a map of the chain; lengths in R_0, momenta in m_0 R_0 / dt.
template <class Map> double defect(const Chain& start, double dt, Map map) {
  const double length = start.R[0], h = 1e-5;
  double J[6][6], worst = 0;
  const auto coordinate = [&](Chain& c, int k) -> double& { return k < 3 ? c.x[k] : c.v[k - 3]; };
  const auto unit = [&](int k) {
    return k < 3 ? length : length / dt * start.mass(0) / start.mass(k - 3);
  };
  for (int k = 0; k < 6; ++k) {
    Chain plus = start, minus = start;
    coordinate(plus, k) += h * unit(k), coordinate(minus, k) -= h * unit(k);
    map(plus), map(minus);
    for (int i = 0; i < 6; ++i)
      J[i][k] = (coordinate(plus, i) - coordinate(minus, i)) / unit(i) / (2 * h);
  }
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) {
      double sum = i + 3 == k ? -1 : k + 3 == i ? 1 : 0;
      for (int m = 0; m < 3; ++m) sum += J[m][i] * J[m + 3][k] - J[m + 3][i] * J[m][k];
      worst = std::max(worst, std::abs(sum));
    }
  return worst;
}
void one_step_form(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "one_step.csv", "method,dt_over_eq50,defect");
  Chain c;  // all four contacts closed, some per cent of a radius deep
  c.length = 0.072, c.x[0] = 0.0096, c.x[1] = 0.0311, c.x[2] = 0.0574;
  double symplectic = 0;
  for (const double s : {0.25, 0.5, 1., 2.}) {
    const double dt = s * default_step;
    const double solver = defect(c, dt, [&](Chain& d) { advance(d, dt, 1); });
    symplectic = std::max(symplectic, solver);
    file.row("solver", s, solver);
    for (const Method m : {Method::velocity_verlet, Method::explicit_euler}) {
      const double other = defect(c, dt, [&](Chain& d) { step(d, m, dt); });
      file.row(name(m), s, other);
      if (s == 1 && m == Method::explicit_euler) metric("form_explicit", other);
    }
  }
  metric("form", symplectic);
}

// --------------------------------------------------------------------------------- energy

/// Kinetic and elastic energy of a run. The velocities of semi-implicit Euler are half a step
/// behind the positions; they are brought to the same time with the forces of the contacts.
double synchronized_energy(const Simulation& s) {
  auto all = s.particles();
  const auto mass = [](const Particle& a) { return real(4 * pi / 3 * rho) * a.R * a.R * a.R; };
  for (const auto& c : s.contacts()) {
    const real half = s.p.dt / 2;
    all[c.i].v += half / mass(all[c.i]) * c.fn;
    if (c.j >= 0) all[c.j].v += -half / mass(all[c.j]) * c.fn;
  }
  double sum = double(s.summary().elastic);
  for (const Particle& a : all) sum += double(mass(a) / 2 * square(a.v));
  return sum;
}
/// Relative change of the energy of a sphere dropped from a height of 1 cm onto a plate, at the
/// apex of every bounce, by one method; returns the RMS over the bounces.
double bounce(Method method, double dt, int bounces, Csv* file, double over_eq50, double* cost) {
  OneContact<double> c(elastic("; g = 0,0,-9.81"), true);
  const double R = 0.01, drop = 0.01;
  c.i.R = R, c.i.x.z = R + drop;
  double sum = 0, last = 0;
  int n = 0;
  for (; n < bounces;) {
    const double before = c.i.v.z, z = c.i.x.z;
    c.step(method, dt);
    if (!(before > 0 && c.i.v.z <= 0) || z < R) continue;
    last = (before * before / 2 + 9.81 * (z - R)) / (9.81 * drop) - 1;
    sum += last * last, ++n;
    if (file && (n % 20 == 0 || n < 20)) file->row(name(method), over_eq50, n, last);
    if (std::abs(last) > 3) break;  // it has left for good
  }
  if (cost) *cost = double(c.evaluations) / n;
  return std::abs(last) > 3 ? std::abs(last) : std::sqrt(sum / n);
}
void bouncing(const Arguments& arg, Metrics& metric) {
  const int bounces = arg.quick ? 500 : 2000;
  Csv file(arg.out / "bounce.csv", "method,dt_over_eq50,bounce,energy_change");
  Work work(arg.out);
  for (double s = 4; s > (arg.quick ? 0.05 : 0.03); s /= 2)
    for (const char* scheme : {"consistent", "paper", "velocity Verlet", "explicit Euler"}) {
      const Method m = scheme[0] == 'v'   ? Method::velocity_verlet
                       : scheme[0] == 'e' ? Method::explicit_euler
                                          : Method::semi_implicit_euler;
      const Timer timer;
      double cost = 0;
      const bool draw = scheme[0] != 'p' && (s == 1 || s == 0.25 || s == 0.0625);
      const double error = bounce(m, s * default_step, bounces, draw ? &file : nullptr, s, &cost);
      work(scheme, s, cost * bounces, timer.seconds(), error);
      if (scheme[0] == 'c' && s == 1) metric("bounce_eq50", error);
      if (scheme[0] == 'c' && s == 0.0625) metric("bounce_16", error);
      if (scheme[0] == 'e' && s == 0.0625) metric("bounce_explicit", error);
    }
}
/// The chain in the solver and with other methods; its total energy, contacts included.
void chain(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "chain.csv", "method,dt_over_eq50,time_s,energy_change");
  const double end = arg.quick ? 4 : 16;  // [s], about 260 impacts per second
  double worst[2] = {0, 0};
  for (const double s : {1., 0.0625}) {
    const double dt = s * default_step;
    const long stride = std::lround(end / 400 / dt);
    Simulation sim = simulation(Chain(), dt);
    const double start = energy(Chain());
    for (int n = 1; n <= 400; ++n) {
      sim.run(stride);
      const double change = synchronized_energy(sim) / start - 1;
      worst[s < 1] = std::max(worst[s < 1], std::abs(change));
      file.row("solver", s, double(n * stride) * dt, change);
    }
    for (const Method m : {Method::velocity_verlet, Method::explicit_euler}) {
      Chain c;
      for (long n = 1; n <= 400 * stride && energy(c) < 5 * start; ++n)
        if (step(c, m, dt); n % stride == 0)
          file.row(name(m), s, double(n) * dt, energy(c) / start - 1);
    }
  }
  metric("chain_eq50", worst[0]), metric("chain_16", worst[1]);
}
/// Elastic, frictionless spheres of three sizes in a closed box; the solver with its summary().
void gas(const Arguments& arg, Metrics& metric) {
  Csv file(arg.out / "gas.csv", "dt_over_eq50,time_s,energy_change,unsynchronized,elastic_share");
  const int n = arg.quick ? 4 : 6;
  const real a = real(0.015 * n), speed = 0.5;
  Mesh box;
  box.vertices = {{-a, -a, -a}, {a, -a, -a}, {a, a, -a}, {-a, a, -a},
                  {-a, -a, a},  {a, -a, a},  {a, a, a},  {-a, a, a}};
  box.elements = {{4, {0, 1, 2, 3}, 0}, {4, {4, 5, 6, 7}, 0}, {4, {0, 1, 5, 4}, 0},
                  {4, {3, 2, 6, 7}, 0}, {4, {0, 3, 7, 4}, 0}, {4, {1, 2, 6, 5}, 0}};
  std::mt19937_64 bits(1);
  const auto uniform = [&] { return real(double(bits() >> 11) * 0x1p-52 - 1); };
  tinydem::vector<Particle> all;
  for (int k = 0; k < n * n * n; ++k)
    all.push_back(ball(
        {real(0.03) * real(k % n) + real(0.015) - a, real(0.03) * real(k / n % n) + real(0.015) - a,
         real(0.03) * real(k / n / n) + real(0.015) - a},
        real(0.01 + 0.002 * (k % 3)), {speed * uniform(), speed * uniform(), speed * uniform()}));
  double last[2] = {};
  for (const double s : {1., 0.25}) {
    const double dt = s * default_step, end = arg.quick ? 1 : 3;
    Simulation sim(elastic(setting("dt", real(dt))), box, all);
    const double start = double(sim.summary().kinetic);
    for (int k = 1; k <= 60; ++k) {
      sim.run(std::lround(end / 60 / dt));
      const auto e = sim.summary();
      const double change = synchronized_energy(sim) / start - 1;
      last[s < 1] = std::max(last[s < 1], std::abs(change));
      file.row(s, double(sim.time()), change, double(e.kinetic + e.elastic) / start - 1,
               double(e.elastic) / start);
    }
  }
  metric("gas_eq50", last[0]), metric("gas_4", last[1]);
}
}  // namespace

int main(int argc, char** argv) {
  const Arguments arg(argc, argv);
  Metrics metric(arg.out);
  one_step_form(arg, metric), bouncing(arg, metric), chain(arg, metric), gas(arg, metric);
}
