// Impacts: what is conserved, what feels no friction, how fast spheres rebound, where energy goes.
#include "test_support.hpp"

using namespace tinydem;

static const string schemes[] = {"consistent", "paper"};

/// Linear and angular momentum about the origin, and the sums of norms that rounding is measured by.
struct Momenta {
  Vec3 linear, angular;
  real linear_size = 0, angular_size = 0;
};
static Momenta momenta(const Simulation& s) {
  Momenta a;
  for (size_t i = 0; i < s.grains.size(); ++i) {
    const Grain& g = s.grains[i];
    const real m = 1 / g.m_inv, R = g.R;
    const Vec3 p = m * g.v, l = cross(g.x, p) + real(0.4) * m * R * R * g.w;
    a.linear += p, a.linear_size += norm(p);
    a.angular += l, a.angular_size += norm(l);
  }
  return a;
}
// Eqs. (1, 2, 31, 56-60)
TEST_CASE("exact: impacts of two and of thousands of spinning spheres keep both momenta") {
  const vector<Particle> two = {
      ball({0, 0, 0}, real(0.005), {1, real(0.3), -1}, {100, -50, 20}),
      ball({real(0.012), real(0.003), real(-0.009)}, real(0.009), {real(-0.5), 0, real(0.2)}, {-30, 10, 80})};
  for (const auto& particles : {two, swarm(15)})
    for (const string& scheme : schemes) {
      Simulation s(scene("mus = 0.4; mur = 0.2; scheme = " + scheme), {}, particles);
      const Momenta before = momenta(s);
      long touching = 0;
      Largest worst;
      for (int k = 0; k < 100; ++k) {
        s.run(1);
        const Momenta now = momenta(s);
        worst(now.linear, before.linear, before.linear_size);
        worst(now.angular, before.angular, before.angular_size);
        for (const Slab& b : s.slabs) touching += b.contacts;
      }
      CAPTURE(scheme);
      CHECK(touching > 5 * s.size());
      CHECK(worst.error < 5e-15);  // measured 1.8e-15
    }
}

// Eqs. (26, 36-38)
TEST_CASE("exact: meshed gears and rigid rotation feel no friction") {
  const real Ri = real(0.004), Rj = real(0.0097), delta = Ri / 10, ri = Ri - delta / 2, rj = Rj - delta / 2;
  const Vec3 n{real(0.48), real(0.6), real(0.64)}, axis{10, -20, 50}, spin = cross(n, axis), x = (Ri + Rj - delta) * n;
  for (const string& scheme : schemes) {
    // Surfaces that run along with each other, Eq. (26): opposite spins, inverse to the lever arms.
    Simulation gears(scene("mur = 0; scheme = " + scheme), {}, {ball({}, Ri, {}, rj / ri * spin), ball(x, Rj, {}, -spin)});
    // Particles that turn about one axis like one body: no sliding, no rolling, no twisting.
    Simulation body(scene("scheme = " + scheme), {}, {ball({}, Ri, {}, axis), ball(x, Rj, cross(axis, x), axis)});
    for (Simulation* s : {&gears, &body}) {
      const vector<Particle> before = s->particles();
      s->run(1);
      const vector<Particle> after = s->particles();
      CHECK(norm(after[0].v - before[0].v) > real(0.01));  // the normal force acts
      Largest worst;
      for (size_t i = 0; i < 2; ++i) worst(after[i].w, before[i].w, norm(before[i].w));
      CAPTURE(scheme);
      CHECK(worst.error < 1e-15);  // measured 0
    }
  }
  // Equal gears stay meshed through a whole impact.
  Simulation impact(scene("mur = 0"), {}, {ball({}, Ri, n, spin), ball(real(1.9) * Ri * n, Ri, -n, -spin)});
  impact.run(200);
  CHECK(impact.contacts().empty());
  for (const Particle& a : impact.particles())
    CHECK(std::abs(norm(a.w) / norm(spin) - 1) < 2e-15);  // measured 4.4e-16
}

/// A sphere that hits a wall or a larger sphere with velocity 1 after some steps.
static Simulation head_on(const string& settings, bool wall, real shorter, real steps) {
  Parameters p = scene("mus = 0; mur = 0; Rmesh = 0; " + settings);
  p.dt /= shorter;
  const real R = p.Rmin;
  vector<Particle> particles = {ball({0, 0, R + steps * p.dt}, R, {0, 0, -1})};
  if (!wall) particles.push_back(ball({0, 0, -2 * R}, 2 * R));
  return Simulation(p, wall ? open_box(1, 1) : Mesh(), particles);
}
/// RMS error of the velocity ratio after impacts that begin at different phases of a step.
static double restitution_error(const string& en, bool wall, real shorter) {
  constexpr int phases = 8;
  double sum = 0;
  for (int k = 0; k < phases; ++k) {
    Simulation s = head_on("en = " + en, wall, shorter, 1 + real(k) / phases);
    s.run(long(200 * shorter));
    const real other = wall ? 0 : s.particles()[1].v.z;
    sum += double(square(s.particles()[0].v.z - other - s.p.en));
  }
  return std::sqrt(sum / phases);
}
// Eqs. (5, 18, 21)
TEST_CASE("rate: head-on restitution approaches e_n, order 1") {
  struct Case {
    string en;
    bool wall;
    double error;  // measured at dt0/16
  };
  const Case cases[] = {{"0.9", false, 4.7e-5}, {"0.5", false, 5.1e-4}, {"0.2", false, 9.8e-4},
                        {"0.9", true, 1.5e-4},  {"0.5", true, 6.6e-4},  {"0.2", true, 1.3e-3}};
  for (const Case& c : cases) {
    const double coarse = restitution_error(c.en, c.wall, 1), middle = restitution_error(c.en, c.wall, 4);
    const double fine = restitution_error(c.en, c.wall, 16);
    INFO("e_n = ", c.en, c.wall ? ", wall: " : ", pair: ", coarse, " ", middle, " ", fine);
    CHECK(fine < 2 * c.error);
    CHECK(min(coarse / middle, middle / fine) > 2);        // measured 2.3 ... 10.5
    CHECK(std::log(coarse / fine) / std::log(16) > 0.95);  // measured 1.01 ... 1.15
  }
}

/// Largest departure of kinetic + elastic energy from its value before an elastic impact, and the
/// duration of the impact against the one that the summary predicts when it is deepest.
static std::pair<double, double> elastic_errors(bool wall, real shorter) {
  Simulation s = head_on("en = 1", wall, shorter, 0);
  Largest energy;
  real predicted = std::numeric_limits<real>::infinity(), lasted = 0;
  for (int k = 0; k < int(40 * shorter); ++k) {
    s.run(1);
    const Summary e = s.summary();
    energy(e.kinetic + e.elastic, s.supplied, s.supplied);
    if (e.contacts > 0) ++lasted, predicted = min(predicted, e.steps);
  }
  return {energy.error, double(abs(predicted / lasted - 1))};
}
// Eqs. (5, 12, 44, 45)
TEST_CASE("rate: energy within an elastic impact, order 1, and the duration of the impact") {
  for (const bool wall : {false, true}) {
    const auto coarse = elastic_errors(wall, 16), fine = elastic_errors(wall, 64);
    CAPTURE(wall);
    CHECK(fine.first < 5e-3);                                         // measured 2.7e-3
    CHECK(std::log(coarse.first / fine.first) / std::log(4) > 0.95);  // measured 1.00
    CHECK(fine.second < 2e-3);                                        // measured 9.2e-4: one step
  }
}

// Eqs. (53-55)
TEST_CASE("exact: no oblique impact on a wall gains energy [D1, D2]") {
  Largest ratio;
  for (const string en : {"0.3", "0.5", "0.8"})
    for (const real mus : {0.1, 0.5, 2.0})
      for (int degrees = 5; degrees < 90; degrees += 5)
        for (const real shorter : {1, 10, 100}) {
          Parameters p = scene("Rmesh = 0; en = " + en);
          p.mus = mus, p.dt /= shorter;
          const real angle = real(degrees) * pi / 180, R = p.Rmin, speed = std::cos(angle);
          Simulation s(p, open_box(1, 1), {ball({0, 0, R}, R, {std::sin(angle), 0, -speed})});
          s.run(long(shorter * 60 * std::pow(speed, real(-0.2))));
          const Summary e = s.summary();
          REQUIRE(e.contacts == 0);
          ratio(double((e.kinetic + e.rotational) / s.supplied));
        }
  CHECK(ratio.error < 1);  // measured 
}

// Eqs. (6, 12-14, 19-24, 53)
TEST_CASE("exact: force and spring of a contact that sticks") {
  for (const bool wall : {false, true}) {
    const Parameters p = scene("mus = 1; Rmesh = 0; nu = 0.2; en = 0.6");
    const real R = real(0.01), v = real(0.01);
    vector<Particle> particles = {ball({0, 0, real(0.95) * R}, R, {v, 0, 0})};
    if (!wall) particles.push_back(ball({0, 0, real(-0.95) * R}, R, {-v, 0, 0}));
    Simulation s(p, wall ? open_box(1, 1) : Mesh(), particles);
    s.run(1);
    const real m = 4 * pi / 3 * p.rho * R * R * R, half = wall ? 1 : real(0.5);
    const Particle i = s.particles()[0], j = wall ? ball({i.x.x, 0, 0}, 0) : s.particles()[1];
    const Contact c = s.contacts().at(0);
    const Vec3 n = 1 / norm(i.x - j.x) * (i.x - j.x);
    const Vec3 u = i.v - j.v + cross(n, (R - c.delta / 2) * (i.w + j.w)), us = u - dot(u, n) * n;
    const real kn = 4 * p.E * half / (3 * (1 - p.nu * p.nu)) * sqrt(half * R * c.delta);
    const real ks = 3 * (1 - p.nu) / (2 - p.nu) * kn;
    const real beta = 1 / std::sqrt(1 + std::pow(pi / std::log(p.en), 2)), cs = beta * sqrt(half * m * ks / 6);
    CAPTURE(wall);
    CHECK(std::abs(c.kn / kn - 1) < 1e-15);                                // measured 0
    CHECK(std::abs(c.mstar / (half * m) - 1) < 1e-15);                     // measured 0
    CHECK(std::abs(norm(c.us) / (p.dt * v / half) - 1) < 1e-15);           // measured 0, Eq. (53) [D1]
    CHECK(norm(c.fs + ks * c.us + cs * us) < 1e-13 * norm(c.fs));          // measured 1.1e-14
    CHECK(double(norm(c.fn)) > 0);
  }
}

TEST_CASE("exact: energies of the summary") {
  const Parameters p = scene("g = 0,2,-9; rho = 1500");
  const real R = real(0.01), m = 4 * pi / 3 * p.rho * R * R * R;
  const Summary e = Simulation(p, {}, {ball({1, 2, 3}, R, {3, 4, 12}, {2, 3, 6})}).summary();
  CHECK(std::abs(e.kinetic / (m * 169 / 2) - 1) < 1e-15);
  CHECK(std::abs(e.rotational / (m * R * R * 49 / 5) - 1) < 1e-15);
  CHECK(std::abs(e.potential / (m * 23) - 1) < 1e-15);
  CHECK(e.elastic == 0);
}

TEST_CASE("exact: elastic energy of a contact with its springs") {
  for (const string& scheme : schemes) {
    Simulation s(scene("mus = 1; mur = 1; mut = 1; nu = 0.2; Rmesh = 0.01; scheme = " + scheme), open_box(1, 1),
                 {ball({0, 0, real(0.0249)}, real(0.015), {-1, 1, -1}, {20, -30, 50}),
                  ball({0, 0, real(0.0551)}, real(0.016), {1, -1, -3}, {10, 30, -50})});
    s.run(4);
    const vector<Contact> contacts = s.contacts();
    REQUIRE(contacts.size() == 2);
    for (const Contact& c : contacts) {
      const real ks = 3 * (1 - s.p.nu) / (2 - s.p.nu) * c.kn;  // Eqs. (12, 13, 22, 23)
      const real springs = ks * (square(c.us) + c.ut * c.ut) + c.kn * square(c.ur);
      CHECK(std::abs(c.energy / (c.kn * c.delta * c.delta * 2 / 5 + springs / 2) - 1) < 2e-15);  // measured 4.4e-16
      CHECK(min(norm(c.us), min(norm(c.ur), abs(c.ut))) > 0);
      CHECK((c.j < 0 ? c.i == 0 && c.element == 0 : c.i + c.j == 1 && c.element < 0));
    }
  }
}

TEST_CASE("exact: energy is never won while particles settle") {
  for (const string& scheme : schemes) {
    Parameters p = scene("g = 0,0,-9.81; Rmesh = 0.01; Nspawn = 20; Nmax = 150; v0 = 0,0,-1; "
                         "smin = -0.03,-0.03,0.02; smax = 0.03,0.03,0.2; Rmin = 0.004; Rmax = 0.01; scheme = " + scheme);
    if (scheme == "paper") p.dt /= 5;  // its springs are unstable at larger steps
    Simulation s(p, open_box(real(0.05), real(0.3)));
    real before = 0;
    Largest won;
    for (int k = 0; k < 100; ++k) {
      s.run(20);
      const Summary e = s.summary();
      const real dissipated = s.supplied - (e.kinetic + e.rotational + e.potential + e.elastic);
      won(double((before - dissipated) / s.supplied));
      before = dissipated;
    }
    CAPTURE(scheme);
    CHECK(s.size() == 150);
    CHECK(before > s.supplied / 10);
    CHECK(won.error < 1e-12);  // measured 0, but sums round
  }
}
