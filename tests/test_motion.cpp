// Particles without contact: the discrete laws of fall, drag and rotation are known exactly.
// Particles that collide in a plane or on a line: they never leave it.
#include <Eigen/Geometry>
#include <map>

#include "test_support.hpp"

using namespace tinydem;

// Eqs. (42, 44, 45)
TEST_CASE("exact: free fall") {
  const Parameters p = scene("g = 0.3,-1.7,-9.81; dt = 1e-3");
  const Vec3 x0{real(0.1), real(-0.2), 3}, v0{1, 2, -3};
  Simulation s(p, {}, {ball(x0, real(0.1), v0)});
  Largest worst;
  for (const long n : {1, 10, 100, 1000}) {  // v = v0 + n g dt, x = x0 + n dt v0 + g dt^2 n(n + 1)/2
    s.run(n - s.steps);
    const real t = real(n) * p.dt;
    worst(s.grains[0].v, v0 + t * p.g, norm(v0));
    worst(s.grains[0].x, x0 + t * v0 + real(n + 1) * p.dt * t / 2 * p.g, norm(x0));
  }
  CHECK(worst.error < 2e-13);  // measured 3.6e-14
}

// Eqs. (3, 4, 42-46)
TEST_CASE("exact: Stokes drag on fall and spin") {
  const Parameters p = scene("g = 0.3,-1.7,-9.81; eta = 0.02; dt = 1e-3");
  const Vec3 x0{real(0.1), real(-0.2), 3}, v0{1, 2, -3}, w0{-4, 5, 6};
  const Reals radii{real(0.005), real(0.01)};
  Simulation s(p, {}, {ball(x0, radii[0], v0, w0), ball(x0 + x0, radii[1], v0, w0)});
  Largest worst;
  for (const long n : {1, 10, 100, 1000}) {
    s.run(n - s.steps);
    for (size_t i = 0; i < 2; ++i) {
      const real c = 9 * p.eta / (2 * p.rho * square(radii[i])), gamma = 10 * c / 3;  // Eqs. (3, 4)
      const real slower = 1 - c * p.dt, left = std::pow(slower, real(n));
      const Vec3 limit = 1 / c * p.g, v = limit + left * (v0 - limit);  // v' = v + dt (g - c v)
      const Vec3 way = real(n) * p.dt * limit + slower * (1 - left) / c * (v0 - limit);
      const Particle a = s.particles()[i];
      worst(a.v, v, norm(v0)), worst(a.x, (i ? 2 : 1) * x0 + way, norm(x0));
      worst(a.w, std::pow(1 - gamma * p.dt, real(n)) * w0, norm(w0));
    }
  }
  CHECK(worst.error < 1e-13);  // measured 1.5e-14
}

static Eigen::Quaternion<real> orientation(const Simulation& s) {
  const auto q = s.particles()[0].q;
  return {q[0], q[1], q[2], q[3]};
}
static Eigen::Quaternion<real> rotation(real angle, const Vec3& axis) {
  return Eigen::Quaternion<real>(Eigen::AngleAxis<real>(angle, Eigen::Matrix<real, 3, 1>(axis.x, axis.y, axis.z)));
}
// Eqs. (47-49)
TEST_CASE("exact: two quarter turns about the axes of the laboratory") {
  for (const string scheme : {"consistent", "paper"})
    for (const long steps : {3, 1000}) {  // large angles and small ones
      const Vec3 x{1, 0, 0}, y{0, 1, 0};
      const Parameters p = scene("dt = 1e-3; scheme = " + scheme);
      const real spin = pi / 2 / (real(steps) * p.dt);
      Simulation s(p, {}, {ball({}, 1, {}, spin * x)});
      s.run(steps);
      s.grains[0].w = spin * y;
      s.run(steps);
      const auto turns = scheme == "paper" ? rotation(pi / 2, x) * rotation(pi / 2, y)   // Eq. (47)
                                           : rotation(pi / 2, y) * rotation(pi / 2, x);  // [D3]
      CAPTURE(scheme);
      CHECK((orientation(s).coeffs() - turns.coeffs()).norm() < 2e-13);  // measured 3.2e-14
    }
}

// Eqs. (43, 46-48)
TEST_CASE("exact: angle of a spin that drag slows down") {
  const Parameters p = scene("dt = 1e-3; eta = 0.05");
  const Vec3 axis{real(0.6), 0, real(0.8)};
  const real R = real(0.01), spin = 50, gamma = 15 * p.eta / (p.rho * R * R), left = 1 - gamma * p.dt;
  Simulation s(p, {}, {ball({}, R, {}, spin * axis)});
  s.run(200);
  // A step turns by dt w + dt^2/2 alpha with alpha = -gamma w, and w is a geometric series.
  const real angle = spin * (1 - gamma * p.dt / 2) * (1 - std::pow(left, real(200))) / gamma;
  CHECK((orientation(s).coeffs() - rotation(angle, axis).coeffs()).norm() < 5e-14);  // measured 7.3e-15
}

TEST_CASE("exact: the norm of a quaternion does not drift") {
  Simulation s(scene("dt = 1e-3; eta = 1e-6"), {}, {ball({}, real(0.01), {}, {30, -20, 10})});
  for (int k = 0; k < 10; ++k) {
    s.grains[0].w += Vec3{real(k), 20 * real(k % 3), -3};
    s.run(10000);
  }
  CHECK(std::abs(orientation(s).norm() - 1) < 5e-12);  // measured 8.1e-13 after 1e5 steps
}

// Eqs. (47-49): orientations are kept apart from the particles, and follow them when these are sorted.
TEST_CASE("exact: each of many spinning particles has its own orientation") {
  for (const string friction : {"0", "0.3"})  // without friction too, where no torque can act
    for (const int n : {1, 31, 33, 3000}) {
      const Parameters p = scene("g = 0,0,0; dt = 1e-3; mur = 0; mus = " + friction);
      Random random(1);
      vector<Particle> all;
      for (int k = 0; k < n; ++k) {  // far apart; every fifth turns by a large angle per step
        const Vec3 place{real(k % 15), real(k / 15 % 15), real(k / 225)};
        all.push_back(ball(place, real(0.01), random.vector(1), random.vector(k % 5 ? 50 : 500)));
      }
      Simulation s(p, {}, all);
      Largest worst;
      for (int k = 0; k < 3; ++k) {
        s.particle_tree.order.clear(), s.stale = true;  // sort
        s.run(50);
        const vector<Particle> now = s.particles();
        for (size_t i = 0; i < all.size(); ++i) {
          const auto q = rotation(norm(all[i].w) * s.time(), 1 / norm(all[i].w) * all[i].w);
          worst(Vec3{now[i].q[1], now[i].q[2], now[i].q[3]}, {q.x(), q.y(), q.z()}, 1);
          worst(now[i].q[0], q.w(), 1);
        }
      }
      CAPTURE(friction);
      CAPTURE(n);
      CHECK(worst.error < 1e-13);  // measured 1.4e-14
    }
}
TEST_CASE("exact: spawned particles turn, also without friction") {
  const Parameters p = scene("g = 0,0,0; dt = 1e-3; mus = 0; mur = 0; w0 = 3,-4,12; Nmax = 500; Nspawn = 5; v0 = 0,0,1; "
                             "smin = -1,-1,0; smax = 1,1,2; Rmin = 0.01; Rmax = 0.02");
  Simulation s(p);
  s.run(200);
  REQUIRE(s.size() == 500);
  Largest worst;
  for (const Particle& a : s.particles()) {  // turned for a whole number of steps
    const real steps = 2 * std::acos(a.q[0]) / (norm(p.w0) * p.dt), whole = std::round(steps);
    CHECK(whole > 90);
    worst(steps, whole, whole);
    worst(cross({a.q[1], a.q[2], a.q[3]}, p.w0), {}, norm(p.w0));
  }
  CHECK(worst.error < 1e-13);  // measured 9.6e-15
}
TEST_CASE("exact: radii, masses and moments of inertia stay in drag, gravity and collisions") {
  for (const string settings : {"", "mus = 0; mur = 0", "orientation = off"}) {
    Simulation s(scene("g = 3,-4,-9.81; eta = 0.1; " + settings), open_box(real(0.1), 1, real(-0.11)), swarm(8));
    std::map<int, Grain> before;
    for (int i = 0; i < s.size(); ++i) before.insert({s.id[i], s.grains[i]});
    s.run(300);
    CHECK(s.contacts().size() > 50);
    for (int i = 0; i < s.size(); ++i) {
      const Grain &now = s.grains[i], &was = before.at(s.id[i]);
      CHECK((now.R == was.R && now.m_inv == was.m_inv && now.R_inv == was.R_inv));
      CHECK(norm(now.v - was.v) > 0);
    }
  }
}
TEST_CASE("exact: what nothing can turn keeps its orientation") {
  vector<Particle> all = swarm(6);
  for (Particle& a : all) a.w = {};
  Simulation s(scene("mus = 0; mur = 0; eta = 1e-3"), {}, all);
  s.run(200);
  CHECK(s.summary().contacts > 0);
  for (const Particle& a : s.particles()) {
    CHECK(norm(a.w) == 0);
    CHECK(a.q == std::array<real, 4>{1, 0, 0, 0});
  }
}

/// Particles that fly together from a box with walls of one kind across it. Coordinates vary and
/// spins point along some axes only.
struct Confined {
  string name;
  Vec3 place, spin;
};
static Simulation implosion(const Confined& c, const string& settings, int corners) {
  Random random(4);
  const auto along = [](const Vec3& a, const Vec3& axes) { return Vec3{a.x * axes.x, a.y * axes.y, a.z * axes.z}; };
  const Vec3 centre{real(0.123), real(-0.0456), real(0.789)};
  const real size = c.name.size() > 1 ? real(0.1) : real(0.4);
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Mesh mesh;
  for (int k = 0; k < 3; ++k)
    for (const real side : {-size, size}) {  // across axis k, if the particles can move along it
      if (dot(axes[k], c.place) == 0) continue;
      const Vec3 a = axes[(k + 1) % 3], b = axes[(k + 2) % 3], middle = centre + side * axes[k];
      const Vec3 corner = middle - real(1.7) * a - real(0.9) * b;
      const int n = int(mesh.vertices.size());
      if (corners == 1) mesh.vertices.push_back(middle);
      if (corners == 2) mesh.vertices.insert(mesh.vertices.end(), {middle - real(1.7) * a, middle + real(1.3) * a});
      if (corners > 2) mesh.vertices.insert(mesh.vertices.end(), {corner, corner + 3 * a, corner + 3 * (a + b), corner + 3 * b});
      mesh.elements.push_back({corners, {n, n + 1, n + 2, n + 3}, 0});
    }
  vector<Particle> cloud;
  while (cloud.size() < 30) {
    const Vec3 x = along(random.vector(size - real(0.02)), c.place);
    bool free = true;
    for (const Particle& a : cloud) free = free && norm(a.x - centre - x) > real(0.015);
    if (!free) continue;
    const Vec3 w = along(random.vector(100), c.spin);  // in this order with every compiler
    const Vec3 v = -5 * x + along(random.vector(1), c.place);
    cloud.push_back(ball(centre + x, random(real(0.004), real(0.007)), v, w));
  }
  return Simulation(scene(settings), mesh, cloud);
}
TEST_CASE("exact: bodies stay in their plane and on their line") {
  const string settings[] = {"eta = 1e-3; Rmesh = 0.01", "mur = 0; Rmesh = 0.01", "scheme = paper; Rmesh = 0.01"};
  const Confined cases[] = {{"x", {1, 0, 0}, {1, 0, 0}},  {"y", {0, 1, 0}, {0, 1, 0}},  {"z", {0, 0, 1}, {0, 0, 1}},
                            {"xy", {1, 1, 0}, {0, 0, 1}}, {"yz", {0, 1, 1}, {1, 0, 0}}, {"zx", {1, 0, 1}, {0, 1, 0}}};
  for (const int corners : {1, 2, 3, 4}) {
    int with_particles = 0, with_walls = 0;
    for (const Confined& c : cases)
      for (const string& options : settings) {
        Simulation s = implosion(c, options, corners);
        const vector<Particle> before = s.particles();
        for (int k = 0; k < 200; ++k) {
          s.run(10);
          for (const Contact& contact : s.contacts()) ++(contact.j < 0 ? with_walls : with_particles);
        }
        const vector<Particle> after = s.particles();
        int departures = 0;
        for (size_t i = 0; i < after.size(); ++i)
          for (real Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            if (c.place.*axis == 0) departures += after[i].x.*axis != before[i].x.*axis || after[i].v.*axis != 0;
            if (c.spin.*axis == 0) departures += after[i].w.*axis != 0;
          }
        CAPTURE(corners);
        CAPTURE(c.name);
        CAPTURE(options);
        CHECK(departures == 0);
      }
    CHECK(min(with_particles, with_walls) > 100);  // it was a test
  }
}
