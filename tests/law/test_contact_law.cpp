// The contact law against the paper's equations, written down here a second time: plain scalars in
// long double, the vectors of another library, c_s from Eq. (19) instead of Eq. (25).
//
// This file includes the source of the solver, because the law is a template that is compiled there.
#define TINYDEM_NO_MAIN
#include "tinydem.cpp"

#include <Eigen/Dense>

#include "../test_support.hpp"

using namespace tinydem;

typedef long double num;
typedef Eigen::Matrix<num, 3, 1> Vector;

/// Bodies i and j and their springs before a step. A wall has radius Rj, and neither moves nor turns.
struct State {
  Vector xi, vi, wi, xj, vj, wj, us, ur;
  num Ri, Rj, ut;
};
struct Answer {
  Vector f{0, 0, 0}, ti{0, 0, 0}, tj{0, 0, 0}, us, ur;
  num ut, fn;
  bool slips[3] = {};
};
struct Switches {
  bool sliding, rolling, twisting, printed;
};

static num length(const Vector& a) { return a.norm(); }
static num length(num a) { return fabsl(a); }

/// The force of a friction mode, and its spring for the next step.
template <class V> V friction_force(V& u, const V& v, num k, num c, num limit, num dt, bool printed, bool& slips) {
  if (!printed) u = u + dt * v;             // (53), before the force is computed
  V f = -k * u - c * v;                     // (6, 34, 35)
  slips = length(f) > limit;                // (11, 39, 40)
  if (slips) {
    f = f * (limit / length(f));            // (54)
    u = -(printed ? V(f + c * v) : f) / k;  // (55), without the dashpot unless printed
  } else if (printed) {
    u = u + dt * v;                         // (53)
  }
  return f;
}
static Vector turned(const Vector& u, const Vector& n) {  // (52), scaled back to the old length
  const Vector flat = u - u.dot(n) * n;
  return length(flat) > 0 ? Vector(flat * (length(u) / length(flat))) : flat;
}

static Answer expected(const State& s, const Parameters& p, bool wall, const Switches& on) {
  const num pi_ = acosl(-1), E = p.E, nu = p.nu, rho = p.rho, en = p.en, dt = p.dt;
  const Vector d = s.xi - s.xj;                                           // (8)
  const num delta = s.Ri + s.Rj - d.norm();                               // (7)
  const Vector n = d / d.norm();                                          // (9)
  const num G = E / (2 * (1 + nu)), mi = 4 * pi_ / 3 * rho * powl(s.Ri, 3), mj = 4 * pi_ / 3 * rho * powl(s.Rj, 3);
  const num compliant = wall ? 1 : 2;  // bodies that are not infinitely stiff
  const num Estar = 1 / (compliant * (1 - nu * nu) / E);                  // (15)
  const num Gstar = 1 / (compliant * (2 - nu) / G);                       // (16)
  const num Rstar = wall ? s.Ri : 1 / (1 / s.Ri + 1 / s.Rj);              // (17)
  const num mstar = wall ? mi : 1 / (1 / mi + 1 / mj);                    // (20)
  const num a = sqrtl(Rstar * delta);                                     // (14)
  const num kn = 4 * Estar * a / 3, ks = 8 * Gstar * a;                   // (12, 13)
  const num beta = 1 / sqrtl(1 + powl(pi_ / logl(en), 2));                // (21)
  const num cn = sqrtl(5 * mstar * kn) * beta, cs = sqrtl(mstar * ks / 6) * beta;  // (18, 19)
  const num ri = s.Ri - delta / 2, rj = s.Rj - delta / 2;                 // (29, 30)
  const Vector wj = wall ? Vector(0, 0, 0) : s.wj, vj = wall ? Vector(0, 0, 0) : s.vj;
  const Vector v = s.vi - vj + n.cross(ri * s.wi + rj * wj);              // (26), sum of the spins
  const Vector vn = v.dot(n) * n, vs = v - vn, w = s.wi - wj;             // (27, 28, 38)
  const Vector vr = (wall ? ri : 1 / (1 / ri + 1 / rj)) * w.cross(n);     // (36)
  const num vt = Rstar * w.dot(n);                                        // (37)
  const Vector fn = kn * delta * n - cn * vn;                             // (5, 10)
  Answer r;
  r.f = fn, r.us = s.us, r.ur = s.ur, r.ut = s.ut, r.fn = fn.norm();
  const auto mode = [&](auto& u, const auto& velocity, num k, num c, num mu, int m) {
    return friction_force(u, velocity, k, c, mu * r.fn, dt, on.printed, r.slips[m]);
  };
  if (on.sliding) {
    r.us = turned(s.us, n);
    const Vector fs = mode(r.us, vs, ks, cs, p.mus, 0);
    r.f += fs, r.ti += ri * fs.cross(n), r.tj += rj * fs.cross(n);        // (57, 31, 60)
  }
  if (on.rolling) {
    r.ur = turned(s.ur, n);
    const Vector torque = Rstar * n.cross(mode(r.ur, vr, kn, cn, p.mur, 1));
    r.ti += torque, r.tj -= torque;                                       // (32, 58)
  }
  if (on.twisting) {
    const Vector torque = mode(r.ut, vt, ks, cs, p.mut, 2) * Rstar * n;
    r.ti += torque, r.tj -= torque;                                       // (33, 59)
  }
  return r;
}

static const Parameters params = scene("mus = 0.4; mur = 0.3; mut = 0.2; en = 0.6; nu = 0.25");

/// Contacts that stick and slip, approach and part; numbers that double precision holds.
static State random_state(Random& random) {
  const auto vector = [](const Vec3& a) { return Vector(a.x, a.y, a.z); };
  const Vec3 n = random.direction(), xj = random.vector(real(0.1));
  const real Ri = random(real(0.002), real(0.01)), Rj = random(real(0.002), real(0.01));
  const real delta = random(real(0.02), real(0.3)) * min(Ri, Rj), size = random(0, delta / 2);
  const real speed = std::pow(real(10), random(-3, 0));
  return {vector(xj + (Ri + Rj - delta) * n), vector(random.vector(speed)), vector(random.vector(speed / Ri)),
          vector(xj), vector(random.vector(speed)), vector(random.vector(speed / Rj)),
          vector(random.vector(size)), vector(random.vector(size)), Ri, Rj, random(-size, size)};
}
template <class T> static Vec<T> to(const Vector& a) { return {T(a[0]), T(a[1]), T(a[2])}; }
/// The bodies of a state for the solver.
template <class T> static std::pair<Body<T>, Body<T>> bodies(const State& s, bool wall) {
  const auto inverse_mass = [](num R) { return T(1 / (4 * acosl(-1) / 3 * num(params.rho) * R * R * R)); };
  const Body<T> i{{to<T>(s.xi), T(s.Ri), to<T>(s.vi), T(1 / s.Ri)}, to<T>(s.wi), inverse_mass(s.Ri)};
  if (wall) return {i, {{to<T>(s.xj), T(s.Rj), {}, 0}, {}, 0}};
  return {i, {{to<T>(s.xj), T(s.Rj), to<T>(s.vj), T(1 / s.Rj)}, to<T>(s.wj), inverse_mass(s.Rj)}};
}

/// What the solver answers.
template <class M, bool wall, class T> static std::pair<Loads<T>, Springs<T>> solved(const State& s) {
  const auto [i, j] = bodies<T>(s, wall);
  Springs<T> u{to<T>(s.us), to<T>(s.ur), T(s.ut)};
  const Loads<T> load = contact_law<M>(approach(i, j), u, material_of<T>(params));
  return {load, u};
}

/// Compares 300 random contacts for one choice of modes; counts[m][slips] says what has been seen.
template <class M, bool wall, class T> static double law_error(int (&counts)[3][2]) {
  Random random(1);
  Largest worst;
  for (int k = 0; k < 300; ++k) {
    const State s = random_state(random);
    const Answer a = expected(s, params, wall, {M::sliding, M::rolling, M::twisting, M::printed});
    const auto [load, u] = solved<M, wall, T>(s);
    const auto compare = [&](const Vec<T>& b, const Vector& reference, num scale) {
      worst(double((Vector(b.x, b.y, b.z) - reference).norm() / scale));
    };
    const num delta = s.Ri + s.Rj - (s.xi - s.xj).norm(), force = a.f.norm() + a.fn;
    compare(load.f, a.f, force), compare(load.ti, a.ti, force * s.Ri);
    if (!wall) compare(load.tj, a.tj, force * (s.Ri + s.Rj));
    compare(u.us, a.us, delta), compare(u.ur, a.ur, delta);
    worst(double(fabsl(num(u.ut) - a.ut) / delta));
    for (int m = 0; m < 3; ++m) ++counts[m][a.slips[m]];
  }
  return worst.error;
}
template <class T, size_t... k> static double all_modes(std::index_sequence<k...>, int (&counts)[3][2]) {
  Largest worst;
  const auto both = [&](auto mode) {
    typedef decltype(mode) M;
    worst(law_error<M, false, T>(counts)), worst(law_error<M, true, T>(counts));
  };
  (both(Modes<k % 2 != 0, k / 2 % 2 != 0, k / 4 % 2 != 0, k / 8 != 0>()), ...);
  return worst.error;
}

// Eqs. (5-40, 52-55, 58-60)
TEST_CASE("exact: contact law of particles and walls with all modes and both schemes") {
  int counts[3][2] = {};
  const auto modes = std::make_index_sequence<16>();
  // Error: rounding of delta, a small difference of large lengths, and of stiff dashpots.
  CHECK(all_modes<double>(modes, counts) < 1e-13);       // measured 1.3e-14
  CHECK(all_modes<long double>(modes, counts) < 5e-16);  // measured 7.7e-17; pi is known in double
  for (const auto& mode : counts) CHECK(min(mode[0], mode[1]) > 1000);
}

// Eq. (21)
TEST_CASE("exact: damping factor at the ends of its range") {
  CHECK(material_of<double>(scene("en = 1")).beta == 0);
  CHECK(material_of<double>(scene("en = 0")).beta == 1);
}

TEST_CASE("exact: a contact at rest without friction force has no NaN") {
  typedef Modes<1, 1, 1> M;
  const real R = real(0.75);  // and a distance of 1: no rounding turns the spring along the normal
  const Body<real> i{{{0, 0, 0}, R, {}, 1 / R}, {}, 1}, j{{{1, 0, 0}, R, {}, 1 / R}, {}, 1};
  for (const real mu : {0.0, 0.5})
    for (const Vec3& us : {Vec3{}, Vec3{real(0.1), 0, 0}}) {  // none; one along the normal
      Parameters p = params;
      p.mus = p.mur = p.mut = mu;
      Springs<real> u{us, us, 0};
      const Loads<real> load = contact_law<M>(approach(i, j), u, material_of<real>(p));
      CHECK(load.f.x < 0);
      for (const Vec3& a : {load.ti, load.tj, u.us, u.ur}) CHECK(square(a) == 0);
      CHECK(square(Vec3{0, load.f.y, load.f.z}) + u.ut == 0);
    }
}

/// Forces, torques and springs in the hot loop against the law, contact by contact; how many numbers
/// have other bits. dense: a compressed lattice; else a swarm that has met.
template <class M> static long bits_that_differ(const string& settings, bool dense) {
  vector<Particle> start = swarm(6);
  Random random(5);
  for (int k = 0; dense && k < count(start); ++k)
    start[k] = ball(real(0.0196) * Vec3{real(k % 6), real(k / 6 % 6), real(k / 36)}, real(0.01), random.vector(2),
                    random.vector(50));
  Simulation s(scene("g = 0,0,-9.81; " + settings), one_element({{real(0.011), 0, 0}}), start);
  s.run(dense ? 10 : 150);
  long different = 0, compared = 0, held = 0;
  const auto differ = [&](const auto& a, const auto& b) {
    different += std::memcmp(&a, &b, sizeof a) != 0, ++compared;
  };
  const Material<real> mat = material_of<real>(s.p);
  for (Slab& b : s.slabs) {
    s.force_phase(s, b);  // now every pair knows whether it touches
    const Slab before = b;
    vector<Grain> grains = s.grains;
    for (vector<Grain>* all : {&grains, &s.grains})
      for (Grain& g : *all) g.f = g.t = Vec3();
    s.force_phase(s, b);
    for (int k = 0; k < count(before.pairs); ++k) {
      const auto [i, j, touching] = before.pairs[k];
      if (!touching && k >= before.held) continue;
      const auto seen = [&](const Body<real>& a) {  // without friction no spins, and 1/m from 1/R
        return M::any ? a : body(static_cast<const Ball<real>&>(a), mat.unit);
      };
      const Body<real> bi = seen(grains[i]), bj = seen(j < 0 ? s.wall(-1 - j, bi.x) : Body<real>(grains[j]));
      Springs<real> u{};
      if (square(bi.x - bj.x) >= square(bi.R + bj.R)) {  // touched when it was listed, and has parted
        if (M::any) differ(b.springs.get(k), u);
        continue;
      }
      held += k < before.held;
      if (M::any) u = before.springs.get(k);
      const Loads<real> load = contact_law<M>(approach(bi, bj), u, mat);
      grains[i].f += load.f, grains[i].t += load.ti;
      if (j >= b.first && j < b.last) grains[j].f += -load.f, grains[j].t += load.tj;
      if (M::any) differ(b.springs.get(k), u);
    }
    for (int i = 0; i < s.size(); ++i) differ(s.grains[i].f, grains[i].f), differ(s.grains[i].t, grains[i].t);
  }
  CHECK(compared > 400);  // 432 without friction: forces and torques of 216 particles
  CHECK((held > 300) == dense);
  return different;
}
// Eqs. (1, 2, 56, 57)
TEST_CASE("exact: the hot loop gives the bits of the law, contact by contact") {
  for (const bool dense : {false, true}) {
    CAPTURE(dense);
    CHECK(bits_that_differ<Modes<1, 1, 1>>("mus = 0.5; mur = 0.1", dense) == 0);
    CHECK(bits_that_differ<Modes<1, 0, 1>>("mus = 0.5; mur = 0", dense) == 0);
    CHECK(bits_that_differ<Modes<1, 0, 0>>("mus = 0.5; mur = 0; mut = 0", dense) == 0);
    CHECK(bits_that_differ<Modes<0, 0, 0>>("mus = 0; mur = 0; mut = 0", dense) == 0);
    CHECK(bits_that_differ<Modes<1, 1, 1, true>>("mus = 0.5; mur = 0.1; scheme = paper; dt = 1e-5", dense) == 0);
  }
}

template <Phase* law, Phase* narrow, Phase* move> static void compare_instruction_sets(const string& settings, bool spins) {
  vector<Particle> start = swarm(6);
  for (Particle& a : start)
    if (!spins) a.w = {};
  const auto run = [&](Phase* forces, Phase* motion) {
    Simulation s(scene(settings + "; g = 0,0,-9.81"), one_element({{real(0.011), 0, 0}}), start);
    s.force_phase = forces, s.motion_phase = motion;
    s.run(200);
    CHECK(s.contacts().size() > 50);
    return s.particles();
  };
  const auto base = run(tinydem::base<narrow>, tinydem::base<move>);
  CHECK(same_bits(base, run(tinydem::base<law>, tinydem::base<move>)));
#ifdef TINYDEM_FOR
  if (__builtin_cpu_supports("avx2")) CHECK(same_bits(base, run(avx2<law>, avx2<move>)));
  if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    CHECK(same_bits(base, run(avx512<law>, avx512<move>)));
#endif
}
TEST_CASE("exact: the same bits on every instruction set") {
  typedef Modes<1, 1, 1> Full;
  compare_instruction_sets<forces<Full>, forces<Full, false>, motion<true, true>>("mus = 0.5; mur = 0.1", true);
  typedef Modes<0, 0, 0> Smooth;
  compare_instruction_sets<forces<Smooth>, forces<Smooth, false>, motion<false, false>>("mus = 0; mur = 0", false);
}
