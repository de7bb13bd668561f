// The neighbour list against all pairs, in every step; friction springs when the list is built anew;
// the memory of the search.
#include <map>

#include "test_support.hpp"

using namespace tinydem;

typedef std::pair<int, int> Key;  // indices in the order of creation; of a wall: particle, ~element

/// What is wrong with the list that a step used, seen from the positions before that step.
struct Verdict {
  long missing = 0, misplaced = 0, repeated = 0, touching = 0;
};
static Verdict judge_step(Simulation& s) {
  const vector<Particle> before = s.particles();
  s.run(1);
  std::map<Key, int> listed;
  vector<int> slab_of(before.size());
  Verdict result;
  for (size_t k = 0; k < s.slabs.size(); ++k)
    for (int i = s.slabs[k].first; i < s.slabs[k].last; ++i) slab_of[size_t(s.id[size_t(i)])] = int(k);
  for (const Slab& b : s.slabs) {
    for (const Pair& c : b.pairs) {
      const int i = s.id[size_t(c.i)], j = c.j < 0 ? c.j : s.id[size_t(c.j)];
      ++listed[c.j < 0 ? Key{i, j} : Key{min(i, j), max(i, j)}];
      result.misplaced += c.i < b.first || c.i >= b.last || i == j;
    }
  }
  // Once; a pair of two slabs once in each of them.
  for (const auto& [key, count] : listed)
    result.repeated += count != (key.second < 0 || slab_of[size_t(key.first)] == slab_of[size_t(key.second)] ? 1 : 2);
  const auto look = [&](size_t i, int partner, const Vec3& x, real R) {
    if (square(before[i].x - x) >= square(before[i].R + R)) return;
    ++result.touching, result.missing += !listed.count({int(i), partner});
  };
  for (size_t i = 0; i < before.size(); ++i) {
    for (size_t j = i + 1; j < before.size(); ++j) look(i, int(j), before[j].x, before[j].R);
    for (size_t k = 0; k < s.mesh.elements.size(); ++k) {
      const Element& e = s.mesh.elements[k];
      look(i, ~int(k), closest_point(s.mesh, e, before[i].x), s.p.Rmesh[size_t(e.group)]);
    }
  }
  return result;
}
static void check_list(Simulation s, int steps, long contacts) {
  Verdict sum;
  for (int k = 0; k < steps; ++k) {
    const Verdict v = judge_step(s);
    sum.missing += v.missing, sum.misplaced += v.misplaced;
    sum.repeated += v.repeated, sum.touching += v.touching;
  }
  CHECK(sum.missing == 0);
  CHECK(sum.misplaced == 0);
  CHECK(sum.repeated == 0);
  CHECK(sum.touching >= contacts);  // it was a test
  if (steps > 1) CHECK(s.rebuilds > 3);
}

/// Spheres at random places, radii evenly spread over the orders of magnitude. The smaller one of two
/// may have a fifth of its radius in the other, and in the mesh.
static Simulation cloud(Random& random, int n, real ratio, const Vec3& box, const Mesh& mesh, const vector<Particle>& more = {}) {
  Parameters p = scene("Rmax = 0.01; Rmin = " + text(real(0.01) / ratio));
  vector<Particle> all = more;
  for (int k = 0; k < 10000 && all.size() < size_t(n) + more.size(); ++k) {
    const real R = real(0.01) * std::pow(ratio, -random(0, 1));
    const Vec3 x{random(-1, 1) * box.x, random(-1, 1) * box.y, random(-1, 1) * box.z};
    bool free = true;
    for (const Particle& a : all) free = free && norm(a.x - x) > a.R + R - min(a.R, R) / 5;
    for (const Element& e : mesh.elements)
      free = free && norm(closest_point(mesh, e, x) - x) > p.Rmesh[size_t(e.group)] + real(0.8) * R;
    if (!free) continue;
    const Vec3 w = random.vector(1 / R), v = random.vector(1);  // in this order with every compiler
    all.push_back(ball(x, R, v, w));
  }
  return Simulation(p, mesh, all);
}

TEST_CASE("exact: neighbour list of a gas in three dimensions, two, and one") {
  Random random(1);
  const real a = real(0.1);
  check_list(Simulation(scene(""), open_box(a, a, -a), swarm(8)), 120, 1000);
  for (const Vec3& box : {Vec3{a, a, a}, Vec3{a, a, 0}, Vec3{0, 2 * a, a}, Vec3{30 * a, 0, 0}, Vec3{0, 0, 30 * a}})
    check_list(cloud(random, 100, 2, box, one_element({box, 2 * box})), 180, 40);
}
TEST_CASE("exact: neighbour list of very different sizes") {
  Random random(2);
  for (const real ratio : {10, 50}) {
    const real R = real(0.01) * ratio;  // the largest is still a grain to the giant that flies into them
    const Particle giant = ball({0, 0, -R - real(0.04)}, R, {0, 0, 1});
    const real a = real(0.04);
    check_list(cloud(random, 300, ratio, {a, a, a}, open_box(a, a, -a), {giant}), 300, 1000);
  }
}
TEST_CASE("exact: neighbour list far apart, far from the origin and on its negative side") {
  for (const real away : {1e6, 1e9}) {
    vector<Particle> all;
    for (const real side : {-1, 0, 1})
      for (Particle a : swarm(3)) a.x += side * away * Vec3{real(0.02), real(-0.02), real(0.02)}, all.push_back(a);
    check_list(Simulation(scene(""), {}, all), 100, 900);
  }
}
TEST_CASE("exact: neighbour list with a fast particle") {
  const real d = real(0.022), R = real(0.006);
  vector<Particle> all;
  for (int k = 0; k < 160; ++k)
    all.push_back(ball({d * real(k % 4), d * real(k / 4 % 4), d * real(k / 16)}, real(0.01), {}));
  const Parameters p = scene("mus = 0; mur = 0");
  all.push_back(ball({d / 2, d / 2, -d}, R, {0, 0, real(0.9) * R / p.dt}));  // grazes all layers
  check_list(Simulation(p, {}, all), 120, 40);
}
TEST_CASE("exact: neighbour list of several slabs") {
  vector<Particle> all = swarm(15);
  all.push_back(ball({0, 0, real(-0.37)}, real(0.2), {0, 0, 1}));
  Simulation s(scene(""), open_box(real(0.17), 1, real(-0.5)), all);
  CHECK(s.slabs.size() > 1);
  check_list(s, 100, 5000);
}
TEST_CASE("exact: neighbour list of 300 small random clouds") {
  Random random(5);
  Verdict sum;
  for (int k = 0; k < 300; ++k) {
    const real size = real(0.005) * std::pow(real(10), random(0, 2)), ratio = std::pow(real(10), random(0, 3));
    const Mesh mesh = one_element({random.vector(size), random.vector(size), random.vector(size)});
    Simulation s = cloud(random, int(random(0, 20)), ratio, {size, size, size}, mesh);
    const Vec3 shift = random.vector(std::pow(real(10), random(-3, 3)));
    for (Grain& g : s.grains) g.x += shift;
    for (Vec3& x : s.mesh.vertices) x += shift;
    s.sort_elements(), s.stale = true;
    const Verdict v = judge_step(s);
    sum.missing += v.missing, sum.misplaced += v.misplaced, sum.repeated += v.repeated, sum.touching += v.touching;
  }
  CHECK(sum.missing + sum.misplaced + sum.repeated == 0);
  CHECK(sum.touching > 100);
}

/// The springs of all pairs that overlap, as the particle that was created first sees them.
static std::map<Key, vector<real>> springs(const Simulation& s, long& mirrored, long& different) {
  std::map<Key, vector<real>> all;
  const auto read = [&](const Slab& b, const Pair& c) {
    const int k = int(&c - b.pairs.data());
    const Grain& a = s.grains[c.i];
    const Body<real> partner = c.j < 0 ? s.wall(-1 - c.j, a.x) : Body<real>(s.grains[c.j]);
    if (square(a.x - partner.x) >= square(a.R + partner.R) || (!c.touching && k >= b.held)) return;
    int i = s.id[size_t(c.i)], j = c.j < 0 ? c.j : s.id[size_t(c.j)];
    const auto [old_us, ur, ut] = b.springs.get(k);
    if (square(old_us) + square(ur) + square(ut) == 0) return;  // a contact that begins
    Vec3 us = old_us;
    if (c.j >= 0 && i > j) std::swap(i, j), us = -us;
    const vector<real> springs{us.x, us.y, us.z, ut, ur.x, ur.y, ur.z};
    const auto [place, fresh] = all.insert({{i, j}, springs});
    mirrored += !fresh, different += !fresh && place->second != springs;  // kept by both slabs
  };
  for (const Slab& b : s.slabs)
    for (const Pair& c : b.pairs) read(b, c);
  return all;
}
TEST_CASE("exact: springs survive a new list and a new order of particles") {
  Simulation s(scene("g = 0,0,-9.81"), open_box(real(0.17), 1, real(-0.18)), swarm(15));
  long mirrored = 0, different = 0, reordered = 0;
  s.run(20);
  for (int k = 0; k < 10; ++k) {
    s.run(20);
    const auto before = springs(s, mirrored, different);
    const vector<int> order = s.id;
    s.stale = true;
    if (k % 4 != 0) s.particle_tree.order.clear();  // sort, which is not done every time
    s.list_neighbours();
    CHECK(before.size() > 100);
    CHECK(springs(s, mirrored, different) == before);
    reordered += s.id != order;
  }
  CHECK(different == 0);
  CHECK(mirrored > 100);
  CHECK(reordered > 5);
}
TEST_CASE("exact: pairs that touched when they were listed move alike whether they are asked again or not") {
  for (const string settings : {"", "mur = 0", "mus = 0; mur = 0", "scheme = paper; dt = 1e-5"}) {
    CAPTURE(settings);
    Simulation held(scene("g = 0,0,-9.81; en = 0.9; " + settings), open_box(real(0.17), 1, real(-0.18)), swarm(15));
    held.run(20);
    long parted = 0, together = 0;
    for (int round = 0; round < 6; ++round) {
      held.horizon = 8, held.stale = true, held.list_neighbours();
      Simulation asked = held;
      for (Slab& b : asked.slabs) {
        for (int k = 0; k < b.held; ++k) b.pairs[k].touching = 1;
        b.held = 0;
      }
      const long lists = held.rebuilds;
      for (int step = 0; step < 12; ++step) {
        held.run(1), asked.run(1);
        if (held.rebuilds != lists) break;
        for (size_t b = 0; b < held.slabs.size(); ++b)
          for (int k = 0; k < held.slabs[b].held; ++k) {
            const bool touches = asked.slabs[b].pairs[k].touching & 1;
            parted += !touches, together += touches;
            if (!held.friction) continue;
            const Springs<real> u = held.slabs[b].springs.get(k), v = touches ? asked.slabs[b].springs.get(k) : Springs<real>{};
            CHECK(std::memcmp(&u, &v, sizeof u) == 0);
          }
        const vector<Particle> a = held.particles(), b = asked.particles();
        CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
      }
      const vector<Contact> a = held.contacts(), b = asked.contacts();
      REQUIRE(a.size() == b.size());
      for (size_t k = 0; k < a.size(); ++k)
        CHECK(std::memcmp(&a[k].delta, &b[k].delta, sizeof a[k] - offsetof(Contact, delta)) == 0);
      held.run(30);
    }
    CHECK((parted > 100 || held.printed));  // whose steps are too short for that
    CHECK(together > 1000);
  }
}

TEST_CASE("exact: the reach follows the cost of a list over that of its idle pairs") {
  Simulation s(scene("g = 0,0,-9.81; en = 0.9"), open_box(real(0.17), 1, real(-0.18)), swarm(15));
  long wider = 0, narrower = 0;
  for (int k = 0; k < 2000; ++k) {
    double list = 50. * s.size(), idle = 0;
    for (const Slab& b : s.slabs) list += 25. * double(b.contacts), idle += double(b.pairs.size()) - double(b.contacts);
    const double shares = double(1 + 2 * s.rooms / (s.rooms + s.radii)), age = double(s.steps - s.listed_at);
    const real before = s.horizon;
    const long lists = s.rebuilds;
    s.run(1);
    if (s.rebuilds == lists) {
      CHECK(s.horizon == before);
      continue;
    }
    const double ratio = idle * age * shares > 0 ? std::pow(list / (idle * age * shares), 0.25) : 2;
    const double expected = max(0.2, min(20., double(before) * max(0.8, min(1.5, ratio))));
    if (lists > 1) CHECK(std::abs(double(s.horizon) / expected - 1) < 1e-14);
    wider += s.horizon > before, narrower += s.horizon < before;
  }
  CHECK(wider > 3);
  CHECK(narrower > 3);
}
TEST_CASE("exact: the reach stays a number while lists are renewed and nothing is there") {
  Simulation s(scene("motion = 0 vibrate 0,0,0.1 50"), open_box(1, 1), {});
  s.run(3000);
  CHECK(s.rebuilds > 10);
  CHECK(s.horizon >= real(0.2));
  CHECK(s.horizon <= 20);
}

/// Pairs that are not listed and could meet before one of them has used up its room.
static long unguarded(const Simulation& s) {
  std::map<Key, int> listed;
  for (const Slab& b : s.slabs)
    for (const Pair& c : b.pairs) listed[c.j < 0 ? Key{c.i, c.j} : Key{min(c.i, c.j), max(c.i, c.j)}] = 1;
  long found = 0;
  const auto look = [&](int i, int j, const Vec3& x, real reach) {
    found += !listed.count({i, j}) && norm(s.grains[i].x - x) < (s.grains[i].reach() + reach) * (1 - 1e-9);
  };
  for (int i = 0; i < s.size(); ++i) {
    for (int j = i + 1; j < s.size(); ++j) look(i, j, s.grains[j].x, s.grains[j].reach());
    for (int k = 0; k < count(s.mesh.elements); ++k) {
      const Body<real> w = s.wall(k, s.grains[i].x);
      look(i, -1 - k, w.x, w.R);
    }
  }
  return found;
}
TEST_CASE("exact: neighbour list while particles are spawned") {
  for (const string more : {"", "; motion = 0 translate 0,0,0.2", "; scheme = paper; dt = 1e-5; Nspawn = 1"}) {
    CAPTURE(more);
    Simulation s(scene("g = 0,0,-9.81; Nspawn = 3; Nmax = 400; Rmin = 0.002; Rmax = 0.006; v0 = 1,0,-2; mus = 0.5; "
                       "smin = -0.06,-0.06,0; smax = 0.06,0.06,0.08; Rmesh = 0.005" + more),
                 open_box(real(0.07), 1, real(-0.06)));
    long gaps = 0, joined = 0, touching = 0;
    while (s.steps < 1200) {
      const int before = s.size();
      const long lists = s.rebuilds;
      s.run(1);
      touching += s.slabs[0].contacts;
      if (s.stale) continue;  // the next step begins with a new list
      joined += s.size() > before && s.rebuilds == lists;
      real excess = -1;
      for (const Slab& b : s.slabs) excess = max(excess, b.excess);
      if (excess <= 0) gaps += unguarded(s);
    }
    CHECK(gaps == 0);
    CHECK(s.size() > 250);
    CHECK(touching > 1000);
    CHECK(joined > 30);                // new particles joined a list that went on to be used
    CHECK(3 * s.rebuilds < s.steps);  // and so lists are rarer than particles
  }
}

TEST_CASE("exact: springs of a particle that joined the list survive the next one") {
  vector<Particle> all = swarm(15);  // several slabs; the new particle belongs to the last one
  for (Particle& a : all) a.v = a.w = {};
  const size_t targets[] = {0, all.size() - 1};
  for (const size_t target : targets) {  // it has pairs already, some of them stand with it
    const Particle a = all[target];
    const Vec3 up = 1 / norm(a.x) * a.x, e = cross(up, {0, 1, 0}), side = 1 / norm(e) * e, other = cross(up, side);
    for (const Vec3& to : {side, -side, other, -other}) {
      const Vec3 away = real(0.7) * up + to;
      all.push_back(ball(a.x + (a.R + real(0.00501)) / norm(away) * away, real(0.005), {}));
    }
  }
  for (const size_t target : targets) {
    const Particle& a = all[target];
    const Vec3 at = a.x + (a.R + real(0.00501)) * (1 / norm(a.x)) * a.x;  // outside of the swarm
    const auto words = [](const Vec3& x) { return text(x.x) + "," + text(x.y) + "," + text(x.z); };
    Simulation s(scene("Nspawn = 1; Rmin = 0.005; Rmax = 0.005; w0 = 100,200,300; smin = " + words(at) + "; smax = " +
                       words(at) + "; v0 = " + words(-1 / norm(at) * at) + "; Nmax = " + to_string(all.size() + 1)),
                 {}, all);
    long kept = 0, mirrored = 0, different = 0;
    for (int k = 0; k < 30; ++k) {
      s.run(1);
      long young = 0;
      for (const Slab& b : s.slabs)
        for (int l = b.held; l < count(b.pairs); ++l)
          young += (b.pairs[l].touching & 1) && max(s.id[b.pairs[l].i], b.pairs[l].j < 0 ? -1 : s.id[b.pairs[l].j]) == count(all);
      if (young == 0) continue;
      s.run(3);
      const auto before = springs(s, mirrored, different);
      s.stale = true, s.list_neighbours();
      if (before.empty()) continue;  // it has parted again
      CHECK(springs(s, mirrored, different) == before);
      kept += young;
    }
    CHECK(s.size() == count(all) + 1);
    CHECK(s.slabs.size() > 1);
    CHECK(kept >= 1);
    CHECK(different == 0);
  }
}
TEST_CASE("exact: a shearing pile moves alike when the list is built anew again and again") {
  for (const string settings : {"", "mur = 0", "mus = 0; mur = 0", "scheme = paper; dt = 1e-5"}) {
    const Parameters p = scene("g = 3,2,-9.81; mus = 0.5; Rmesh = 0.01; " + settings);
    const real R = real(0.01);  // three spheres on the floor and one on top, on their way through cells
    vector<Particle> pile;
    for (const Vec3& x : {Vec3{-1, 0, 2}, Vec3{real(0.98), 0, 2}, Vec3{0, real(1.7), 2}, Vec3{0, real(0.55), real(3.6)}})
      pile.push_back(ball(R * x, R, {3, 2, 0}, {0, 0, 20}));
    pile.push_back(ball({1, 0, R}, R));  // five particles are more than one leaf of the tree
    Simulation calm(p, open_box(5, 1), pile), restless(p, open_box(5, 1), pile);
    Largest worst;
    bool reordered = false;
    long contacts = 0;
    for (int k = 0; k < 400; ++k) {
      restless.stale = k % 3 != 0;
      calm.run(1), restless.run(1);
      contacts += calm.summary().contacts, reordered = reordered || restless.id != vector<int>{0, 1, 2, 3, 4};
      const vector<Particle> a = calm.particles(), b = restless.particles();
      for (size_t i = 0; i < a.size(); ++i) worst(a[i].x, b[i].x, R), worst(a[i].w, b[i].w, 100);
    }
    CAPTURE(settings);
    CHECK(worst.error < 1e-12);  // measured 0: even the order of sums is the same
    CHECK(restless.rebuilds > calm.rebuilds + 200);
    CHECK(reordered);
    CHECK(contacts > 1000);
  }
}

TEST_CASE("exact: memory of the search depends on the number of particles alone") {
  const real R = real(0.01);
  vector<Particle> two = {ball({}, R), ball({real(2e6) * R, real(2e6) * R, real(2e6) * R}, R)};
  CHECK(Simulation(scene(""), {}, two).particle_tree.boxes.size() <= 8);
  vector<Particle> many = swarm(10);
  many.push_back(ball({0, 0, -1000}, 999));
  const Simulation s(scene(""), {}, many);
  CHECK(s.particle_tree.boxes.size() <= 2 * many.size());
}
