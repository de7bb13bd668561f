// TinyDEM, teaching edition: the physics of the solver.
//
//   1 parameters     Table 2 as scene files, options and --help
//   2 contact law    Eqs. (5)-(41), (51)-(55): pure functions, to be read beside the paper
//   3 time step      forces, Eqs. (42)-(49), neighbour list, spawning
//   4 program        frames, log, restart, command line
//
// Equation numbers: R. Vetter, TinyDEM, Comput. Phys. Commun. (2025) 109942. [D1]-[D3] mark the
// three statements in which --scheme consistent differs from the printed one (docs/deviations.md).
// Build: g++ -std=c++17 -O3 -fopenmp -I/usr/include/eigen3 -o tinydem tinydem.cpp
#include "tinydem.hpp"

#include <functional>
#include <map>
#ifdef _OPENMP
#include <omp.h>
#endif
#ifndef TINYDEM_NO_MAIN
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <sstream>
#if defined(__GNUC__) && !defined(__clang__)  // options need no speed: compiles in half the time
#pragma GCC push_options
#pragma GCC optimize("O0")
#include <CLI/CLI.hpp>
#pragma GCC pop_options
#else
#include <CLI/CLI.hpp>
#endif
#endif

namespace tinydem {

// ------------------------------------------------------------------------------ 1 parameters

/// A parameter; type is the first letter of its type in the table.
struct Option {
  const char *name, *dimension, *range, *help;
  void* at;
  char type;
  Reals& list() const { return *static_cast<Reals*>(at); }
  long& whole() const { return *static_cast<long*>(at); }
  string& word() const { return *static_cast<string*>(at); }
  real* first() const { return static_cast<real*>(at); }
  Reals numbers() const {
    return type == 's' ? Reals() : type == 'R' ? list() : type == 'l' ? Reals{real(whole())}
                       : Reals(first(), first() + (type == 'V' ? 3 : 1));
  }
};
static vector<Option> options(Parameters& p) {
#define X(name, type, value, ...) {#name, __VA_ARGS__, &p.name, #type[0]},
  return {TINYDEM_PARAMETERS(X)};
#undef X
}
static string text(const Reals& values, int digits = 0) {
  string all;
  for (const real a : values) all += "," + text(a, digits);
  return all.empty() ? all : all.substr(1);
}
static string text(const Option& o) { return o.type == 's' ? o.word() : text(o.numbers()); }

/// Stores the text of a setting; false when it is malformed.
static bool assign(const Option& o, const string& s) {
  const auto words = split(o.range, '|');
  if (o.type == 's')
    return o.word() = s, words.size() == 1 || std::count(words.begin(), words.end(), s) > 0;
  Reals a;
  for (const string& token : split(s, ','))
    if (a.push_back(0); !parse(token, a.back())) return false;
  if (o.type == 'R') return o.list() = a, true;
  if (a.size() != o.numbers().size()) return false;
  if (o.type != 'l') return std::copy(a.begin(), a.end(), o.first()), true;
  return a[0] == std::floor(a[0]) && abs(a[0]) < real(4e18) && (o.whole() = long(a[0]), true);
}
/// Are the numbers of an option in its range, e.g. "(-1, 0.5]" or "[Rmin, inf)"?
static bool in_range(const Option& o, const Parameters& p) {
  const string range = o.range, low = range.substr(1, range.find(',') - 1);
  const real *smin = &p.smin.x, high = std::strtof(&range[range.find(',') + 1], nullptr);
  bool good = true;
  for (const real a : o.numbers()) {
    const real from = low == "Rmin"   ? p.Rmin
                      : low == "smin" ? *smin++
                                      : std::strtof(&low[0], nullptr);
    good = good && a >= from && (range[0] == '[' || a > from) && a <= high;
  }
  return good;
}
/// Number of letters to change, insert or remove between two names.
static size_t distance(const string& a, const string& b) {
  vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i)
    for (size_t j = 1, corner = std::exchange(row[0], i); j <= b.size(); ++j)
      corner = std::exchange(
          row[j], min(min(row[j], row[j - 1]) + 1, corner + (a[i - 1] != b[j - 1])));
  return row.back();
}
vector<Setting> read_scene(const string& path) {
  Reader in(path);
  vector<Setting> all;
  while (in.next('=')) {
    if (in.tokens.size() != 2) in.complain("'" + in.line + "' must be name = value");
    Setting s{in.tokens[0], in.tokens.back(), in.where()};
    if (s.name == "mesh" || s.name == "particles" || s.name == "output")
      s.text = (std::filesystem::path(path).parent_path() / s.text).string();
    for (const Setting& o : all)
      if (o.name == s.name)
        in.complain("'" + s.name + "' is repeated, it already stands in " + o.where);
    all.push_back(s);
  }
  return in.problems.stop_if_any(), all;
}
Parameters resolve(const vector<Setting>& settings) {
  Parameters p;
  Problems problems;
  std::map<string, Setting> used;
  const auto complain = [&](const Option& o, const Setting& s) {
    const std::map<char, string> shape{{'r', "a number in "},
                                       {'l', "an integer in "},
                                       {'R', "numbers in "},
                                       {'V', "three numbers like 0,0,-9.81 in "},
                                       {'s', "one of "}};
    problems.add(s.where, s.name + " = '" + s.text + "' must be " + shape.at(o.type) + o.range);
  };
  for (const Setting& s : settings) {
    const vector<Option> table = options(p);
    const auto closer = [&](const Option& a, const Option& b) {
      return distance(a.name, s.name) < distance(b.name, s.name);
    };
    const Option& o = *std::min_element(table.begin(), table.end(), closer);
    if (o.name != s.name)
      problems.add(s.where, "'" + s.name + "' is unknown; did you mean '" + o.name + "'?");
    else if (used[s.name] = s; !assign(o, s.text)) complain(o, s);
  }
  if (std::isnan(p.mut)) p.mut = 2 * p.mus / 3;                                 // Eq. (41)
  if (std::isnan(p.dt)) p.dt = p.Rmin * sqrt(p.rho * (1 - p.nu * p.nu) / p.E);  // Eq. (50)
  for (const Option& o : options(p))
    if (!in_range(o, p) && (used.count(o.name) || problems.count == 0))
      complain(o, used.count(o.name) ? used[o.name] : Setting{o.name, text(o), "default"});
  return problems.stop_if_any(), p;
}

// ---------------------------------------------------------------------------- 2 contact law
//
//        i          d = x_i - x_j points from j to i, n = d/|d|; forces act on i, and
//      ( ^ )        with the opposite sign on j. T is a number or a pack of W numbers:
//       -n-  delta  to change the law, write `select(condition, a, b)` where you would
//      (   )        write `if`, e.g. an attraction that ends at a depth h:
//        j            fn = fn - select(c.delta < h, F0 + T(), T());

/// Constants of the law between two particles; a wall is infinitely stiff, which doubles Estar and
/// Gstar.
template <class S> Material<S> material(const Parameters& p, bool wall) {
  const S E = S(p.E), nu = S(p.nu), en = S(p.en);
  const S bodies = wall ? 1 : 2;
  Material<S> m;
  m.Estar = E / (bodies * (1 - nu * nu));                                       // Eqs. (15, 22)
  m.Gstar = E / (bodies * 2 * (2 - nu) * (1 + nu));                             // Eqs. (16, 23)
  m.beta = 1 / std::sqrt(1 + std::pow(S(pi) / std::log(en), S(2)));             // Eq. (21)
  m.cs_cn = std::sqrt((1 - nu) / (10 * (2 - nu)));                              // Eq. (25)
  m.mus = S(p.mus), m.mur = S(p.mur), m.mut = S(p.mut), m.dt = S(p.dt);
  return m;
}

/// Position, radius, velocity, 1/m, angular velocity, 1/R (walls: 1/m = 1/R = 0).
template <class T> struct Body { Vec<T> x; T R; Vec<T> v; T m_inv; Vec<T> w; T R_inv; };
/// Geometry and relative motion of a contact.
template <class T> struct Approach { T delta, ri, rj, Rstar, mstar, vn, vt; Vec<T> n, vs, vr; };
template <bool wall, class T> INLINE Approach<T> approach(const Body<T>& i, const Body<T>& j) {
  Approach<T> c;
  const Vec<T> d = i.x - j.x;                                                   // Eq. (8)
  const T distance = norm(d);
  c.delta = i.R + j.R - distance;                                               // Eq. (7)
  c.n = (1 / distance) * d;                                                     // Eq. (9)
  c.Rstar = 1 / (i.R_inv + j.R_inv);                                            // Eq. (17)
  c.mstar = 1 / (i.m_inv + j.m_inv);                                            // Eqs. (20, 24)
  c.ri = i.R - c.delta / 2;                                                     // Eq. (29)
  c.rj = j.R - c.delta / 2;                                                     // Eq. (30)
  const Vec<T> v = i.v - j.v + cross(c.n, c.ri * i.w + c.rj * j.w);             // Eq. (26)
  c.vn = dot(v, c.n);                                                           // Eq. (27)
  c.vs = v - c.vn * c.n;                                                        // Eq. (28)
  const Vec<T> w = i.w - j.w;                                                   // Eq. (38)
  const T r = wall ? c.ri : c.ri * c.rj / (c.ri + c.rj);
  c.vr = r * cross(w, c.n);                                                     // Eq. (36)
  c.vt = c.Rstar * dot(w, c.n);                                                 // Eq. (37)
  return c;
}

/// The history of a contact: displacements of the three friction springs [L], Eq. (51).
template <class T> struct Springs { Vec<T> us, ur; T ut; };
/// Turns a spring into the tangent plane and keeps its length, Eq. (52).
template <class T> INLINE Vec<T> turn(const Vec<T>& u, const Vec<T>& n) {
  const Vec<T> flat = u - dot(u, n) * n;
  const T scale = sqrt(square(u) / square(flat));
  return select(square(flat) > T(), scale * flat, flat);
}

/// Stiffness, damping and largest force of one friction mode.
template <class T> struct Mode { T k, c, limit; };
/// Force of one friction mode m; advances its spring. V: a vector (s, r) or a number (t).
template <bool printed, class T, class V, class S>
INLINE V friction(V& u, const V& v, const Mode<T>& m, const S& dt) {
  if (!printed) u += dt * v;                                                    // Eq. (53) [D1]
  V f = -(m.k * u) - m.c * v;                                                   // Eqs. (6, 34, 35)
  if (printed) u += dt * v;                                                     // Eq. (53)
  const T length = norm(f);
  const auto slip = length > m.limit;                                           // Eqs. (11, 39, 40)
  if (any(slip)) {
    f = select(slip, m.limit / length * f, f);                                  // Eq. (54)
    const V rest = printed ? f + m.c * v : f;                                   // Eq. (55) [D2]
    u = select(slip, -(1 / m.k * rest), u);                                     // Eq. (55)
  }
  return f;
}

/// Force on i (and its opposite on j), torque on i, torque on j.
template <class T> struct Loads { Vec<T> f, ti, tj, fn; T kn, ks; };
/// The contact law. M says which friction modes the scene has.
template <class M, class T, class S>
INLINE Loads<T> contact_law(const Approach<T>& c, Springs<T>& u, const Material<S>& mat) {
  const T a = sqrt(c.Rstar * c.delta);                                          // Eq. (14)
  const T kn = S(4) / 3 * mat.Estar * a;                                        // Eq. (12)
  const T ks = 8 * mat.Gstar * a;                                               // Eq. (13)
  const T cn = mat.beta * sqrt(5 * c.mstar * kn);                               // Eq. (18)
  const T cs = mat.cs_cn * cn;                                                  // Eqs. (19, 25)
  const T fn = kn * c.delta - cn * c.vn;                                        // Eqs. (5, 10)
  const T load = norm(fn);
  Loads<T> r;
  r.f = r.fn = fn * c.n, r.kn = kn, r.ks = ks;
  if constexpr (M::sliding) {
    u.us = turn(u.us, c.n);                                                     // Eq. (52)
    const Vec<T> fs =
        friction<M::printed>(u.us, c.vs, Mode<T>{ks, cs, mat.mus * load}, mat.dt);  // Eq. (6)
    r.f += fs;
    r.ti = c.ri * cross(fs, c.n);                                               // Eq. (31)
    r.tj = c.rj * cross(fs, c.n);                                               // Eq. (60)
  }
  if constexpr (M::rolling) {
    u.ur = turn(u.ur, c.n);                                                     // Eq. (52)
    const Vec<T> fr =
        friction<M::printed>(u.ur, c.vr, Mode<T>{kn, cn, mat.mur * load}, mat.dt);  // Eq. (34)
    const Vec<T> tr = c.Rstar * cross(c.n, fr);                                 // Eq. (32)
    r.ti += tr, r.tj += -tr;                                                    // Eq. (58)
  }
  if constexpr (M::twisting) {
    const T ft =
        friction<M::printed>(u.ut, c.vt, Mode<T>{ks, cs, mat.mut * load}, mat.dt);  // Eq. (35)
    const Vec<T> tt = ft * c.Rstar * c.n;                                       // Eq. (33)
    r.ti += tt, r.tj += -tt;                                                    // Eq. (59)
  }
  return r;
}

// ------------------------------------------------------------------------------- 3 time step

template <bool s, bool r, bool t, bool p = false> struct Modes {  // what is compiled in
  static constexpr bool sliding = s, rolling = r, twisting = t, printed = p;
  static constexpr int rows = r ? 2 : s || t ? 1 : 0;  // of spring history: (us|ut) (ur|-)
};
static void fail(Slab& b, int i, const char* reason) {
  if (b.culprit < 0) b.culprit = i, b.reason = reason;
}
template <class T> INLINE Body<T> body(const Simulation& s, const int* i) {
  const auto x = gather<T>(&s.x[0], i), v = gather<T>(&s.v[0], i), w = gather<T>(&s.w[0], i);
  return {x.xyz(), x.c[3], v.xyz(), v.c[3], w.xyz(), w.c[3]};
}
/// A mesh element as a particle sees it: (closest point|radius).
static Row closest(const Simulation& s, int element, const Vec3& centre) {
  const Element& e = s.mesh.elements[element];
  return {closest_point(s.mesh, e, centre), s.p.Rmesh[e.group]};
}
/// Gives a pair that touches a place for its springs; a pair that parted loses them.
static void keep_history(const Simulation& s, Slab& b, Pair& pair) {
  if (pair.spring > Pair::never)
    std::fill_n(&b.springs[pair.spring * s.spring_rows], s.spring_rows, Row());
  if (pair.spring != Pair::never)
    pair.spring = Pair::never - 1 - pair.spring;  // place <-> former place
  else
    pair.spring = count(b.springs) / s.spring_rows,
    b.springs.resize(b.springs.size() + size_t(s.spring_rows));
}
/// Pairs that touch, by their places in the list; walls also by (closest point|radius).
template <int W> struct Touching {
  static constexpr int block = 256;
  int n = 0, pair[block + W];
  Row point[block + W];
};
/// Forces in n <= W touching pairs, computed together and added up in the order of the list.
template <class M, int W, bool wall>
INLINE void forces_on_pack(Simulation& s, Slab& b, const Touching<W>& touching, int first, int n) {
  typedef typename Pack<W>::type T;
  int i[W], j[W], place[W];
  for (int l = 0; l < W; ++l) {
    const int k = first + min(l, n - 1);
    const Pair& pair = (wall ? b.walls : b.pairs)[touching.pair[k]];
    i[l] = pair.i, j[l] = wall ? k : pair.j, place[l] = pair.spring * M::rows;
  }
  const Body<T> bi = body<T>(s, i);
  Body<T> bj{};  // a wall has no motion, 1/m = 0 and 1/R = 0
  if constexpr (wall) {
    const auto point = gather<T>(touching.point, j);
    bj.x = point.xyz(), bj.R = point.c[3];
  } else bj = body<T>(s, j);
  Approach<T> c = approach<wall>(bi, bj);
  T deepest = wall ? bi.R : smaller(bi.R, bj.R);
  if (any(c.delta > deepest))
    for (int l = 0; l < n; ++l)
      if (lane(c.delta, l) > lane(deepest, l))
        fail(b, i[l],
             wall ? "overlaps a mesh element by more than its radius"
                  : "overlaps another by more than a radius");
  Springs<T> u{};
  if constexpr (M::rows > 0) {
    const auto row = gather<T>(&b.springs[0], place);
    u.us = row.xyz(), u.ut = row.c[3];
  }
  if constexpr (M::rows > 1) u.ur = gather<T>(&b.springs[1], place).xyz();
  const Loads<T> load = contact_law<M>(c, u, wall ? s.wall_material : s.pair_material);
  Row f[W], ti[W], tj[W], u0[W], u1[W];
  scatter(load.f, T(), f);
  if constexpr (M::rows > 0)
    scatter(load.ti, T(), ti), scatter(load.tj, T(), tj), scatter(u.us, u.ut, u0);
  if constexpr (M::rows > 1) scatter(u.ur, T(), u1);
  for (int l = 0; l < n; ++l) {
    const bool own = !wall && j[l] >= b.first && j[l] < b.last;  // else the other slab adds to j
    s.f[i[l]] += f[l];                                                          // Eq. (1)
    if (own) s.f[j[l]] -= f[l];                                                 // Eqs. (56, 57)
    if constexpr (M::rows > 0) {
      s.t[i[l]] += ti[l];                                                       // Eq. (2)
      if (own) s.t[j[l]] += tj[l];
      b.springs[place[l]] = u0[l];
    }
    if constexpr (M::rows > 1) b.springs[place[l] + 1] = u1[l];
  }
}
/// Which pairs (or walls) of a slab touch, then their forces, W at a time.
template <class M, int W, bool wall> INLINE void forces_on_list(Simulation& s, Slab& b) {
  vector<Pair>& list = wall ? b.walls : b.pairs;
  Touching<W> touching;
  for (int k = 0, n = 0, done = 0; k < count(list); touching.n = n - done) {
    for (const int end = min(k + Touching<W>::block, count(list)); k < end; ++k) {
      const Row& xi = s.x[list[k].i];
      if (wall) touching.point[touching.n] = closest(s, list[k].j, xi.xyz());
      const Row& xj = wall ? touching.point[touching.n] : s.x[list[k].j];
      const bool touch = square(xi.xyz() - xj.xyz()) < square(xi.c[3] + xj.c[3]);  // Eq. (7)
      if (M::rows > 0 && touch != (list[k].spring > Pair::never)) keep_history(s, b, list[k]);
      touching.pair[touching.n] = k;
      touching.n += touch;
    }
    for (n = touching.n, done = 0; n - done >= W || (n > done && k == count(list));
         done += min(W, n - done))
      forces_on_pack<M, W, wall>(s, b, touching, done, min(W, n - done));
    std::copy(touching.pair + done, touching.pair + n, touching.pair);
    if (wall) std::copy(touching.point + done, touching.point + n, touching.point);
    b.contacts += done;
  }
}
template <class M> struct Forces {
  static constexpr bool portable = M::printed;  // not worth a kernel for each instruction set
  template <int W> static INLINE void run(Simulation& s, Slab& b) {
    b.contacts = 0;
    forces_on_list<M, W, false>(s, b), forces_on_list<M, W, true>(s, b);
  }
};

/// The quaternion (cos |h|, sin |h| h/|h|), by series where they are exact to the last digit.
template <class T> INLINE Columns<T> rotation(const Vec<T>& h) {
  constexpr auto over = [](int n) { return 1 / real(n); };
  T h2 = square(h);
  T c = 1 - h2 * (over(2) - h2 * (over(24) - h2 * (over(720) - h2 * over(40320))));
  T s = 1 - h2 * (over(6) - h2 * (over(120) - h2 * (over(5040) - h2 * over(362880))));
  if (any(h2 > real(0.004)))
    for (int l = 0; l < width<T>; ++l)
      if (const real h1 = sqrt(lane(h2, l)); lane(h2, l) > real(0.004))
        lane(c, l) = std::cos(h1), lane(s, l) = std::sin(h1) / h1;
  return {{c, s * h.x, s * h.y, s * h.z}};
}
template <class T>
INLINE Columns<T> hamilton(const Columns<T>& p, const Columns<T>& q) {          // Eq. (49)
  const Vec<T> pv{p.c[1], p.c[2], p.c[3]}, qv{q.c[1], q.c[2], q.c[3]};
  const Vec<T> v = p.c[0] * qv + q.c[0] * pv + cross(pv, qv);
  return {{p.c[0] * q.c[0] - dot(pv, qv), v.x, v.y, v.z}};
}
/// Eqs. (42)-(49) for n <= W particles; clears their forces.
template <int W, bool orientation, bool drag>
INLINE void move(Simulation& s, Slab& b, int first, int n) {
  typedef typename Pack<W>::type T;
  int i[W];
  for (int l = 0; l < W; ++l) i[l] = first + min(l, n - 1);
  const auto xR = gather<T>(&s.x[0], i), vm = gather<T>(&s.v[0], i), wR = gather<T>(&s.w[0], i);
  const auto f = gather<T>(&s.f[0], i), t = gather<T>(&s.t[0], i), x0 = gather<T>(&s.x0[0], i);
  T R = xR.c[3], m_inv = vm.c[3], R_inv = wR.c[3], I_inv = real(2.5) * m_inv * R_inv * R_inv;
  const real dt = s.p.dt;
  const Vec<T> g{s.p.g.x + T(), s.p.g.y + T(), s.p.g.z + T()};
  Vec<T> x = xR.xyz(), v = vm.xyz(), w = wR.xyz();
  Vec<T> a = m_inv * f.xyz() + g;                                               // Eq. (42)
  Vec<T> alpha = I_inv * t.xyz();                                               // Eq. (43)
  if constexpr (drag) {
    const T c = real(4.5) * s.p.eta / s.p.rho * R_inv * R_inv;                  // Eq. (3)
    const T gamma = real(10) / 3 * c;                                           // Eq. (4)
    a = a - c * v, alpha = alpha - gamma * w;
  }
  v += dt * a;                                                                  // Eq. (44)
  x += dt * v;                                                                  // Eq. (45)
  if constexpr (orientation) {
    const auto q = gather<T>(&s.q[0], i);
    const auto phi = rotation(dt / 2 * w), theta = rotation(dt * dt / 4 * alpha);  // Eq. (48)
    const auto turned = s.printed ? hamilton(hamilton(q, phi), theta)           // Eq. (47)
                                  : hamilton(theta, hamilton(phi, q));          // Eq. (47) [D3]
    scatter(turned.xyz(), turned.c[3], &s.q[first], n);
  }
  w += dt * alpha;                                                              // Eq. (46)
  T way = dt * norm(v), spin2 = square(w), excess = norm(x - x0.xyz()) - (x0.c[3] - R);
  for (int l = 0; l < n; ++l) {
    if (!(lane(way, l) <= lane(R, l))) fail(b, i[l], "moved more than its radius in one step");
    if (!(lane(spin2, l) < inf)) fail(b, i[l], "spins too fast for a finite energy");
    b.excess = max(b.excess, lane(excess, l));
  }
  scatter(x, R, &s.x[first], n), scatter(v, m_inv, &s.v[first], n),
      scatter(w, R_inv, &s.w[first], n);
  std::fill_n(&s.f[first], n, Row()), std::fill_n(&s.t[first], n, Row());
}
template <bool orientation, bool drag> struct Motion {
  static constexpr bool portable = false;
  template <int W> static INLINE void run(Simulation& s, Slab& b) {
    b.excess = -1;
    for (int i = b.first; i < b.last; i += W)
      move<W, orientation, drag>(s, b, i, min(W, b.last - i));
    b.failed = b.culprit >= 0;
  }
};

/// A phase of the step for each instruction set; the machine chooses when a run starts.
template <class Phase> struct Compiled {
  static constexpr int size = sizeof(real);
  static void base(Simulation& s, Slab& b) { Phase::template run<max(16 / size, 1)>(s, b); }
#if defined(__x86_64__) && !defined(__clang__)
#define TINYDEM_FOR(name, isa, bytes)                                                              \
  __attribute__((target(isa))) static void name(Simulation& s, Slab& b) {                          \
    Phase::template run<max(bytes / size, 1)>(s, b);                                               \
  }
  TINYDEM_FOR(avx2, "avx2", 32)
  TINYDEM_FOR(avx512, "avx512f,avx512vl,avx512dq", 64)
  static auto best() {
    if constexpr (size > 8 || Phase::portable) return base;
    else return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") ? avx512
              : __builtin_cpu_supports("avx2") ? avx2 : base;
  }
#else
  static auto best() { return base; }
#endif
};

Simulation::Simulation(const Parameters& parameters, const Mesh& geometry,
                       const vector<Particle>& initial)
    : p(parameters), mesh(geometry), printed(p.scheme == "paper"), random(std::uint64_t(p.seed)) {
  pair_material = material<real>(p, false), wall_material = material<real>(p, true);
  const bool turning = p.orientation == "on", drag = p.eta > 0;
  motion_phase = turning ? drag ? Compiled<Motion<1, 1>>::best() : Compiled<Motion<1, 0>>::best()
                         : drag ? Compiled<Motion<0, 1>>::best() : Compiled<Motion<0, 0>>::best();
  force_phase = printed     ? Compiled<Forces<Modes<1, 1, 1, 1>>>::best()
                : p.mur > 0 ? Compiled<Forces<Modes<1, 1, 1>>>::best()
                : p.mut > 0 ? Compiled<Forces<Modes<1, 0, 1>>>::best()
                : p.mus > 0 ? Compiled<Forces<Modes<1, 0, 0>>>::best()
                            : Compiled<Forces<Modes<0, 0, 0>>>::best();
  spring_rows = p.mur > 0 || printed ? 2 : p.mus > 0 || p.mut > 0 ? 1 : 0;
  sort_elements();
  for (const Particle& particle : initial) add(particle);
  list_neighbours();
  Problems problems;
  for (const Contact& c : contacts())
    if (!(c.delta <= c.R))
      problems.add("particle " + to_string(c.i + 1),
                   "overlaps " +
                       (c.j < 0 ? "mesh element " + to_string(c.element)
                                : "particle " + to_string(c.j + 1)) +
                       " by " + text(c.delta) + ", more than a radius " + text(c.R) + "; move it");
  supplied += summary().elastic;
  if (!std::isfinite(supplied))
    problems.add("particles", "their energy is not finite; slow them down");
  problems.stop_if_any();
}
/// Sorts mesh elements along a space-filling curve and puts boxes around them.
void Simulation::sort_elements() {
  Box all;
  for (const Vec3& a : mesh.vertices) all.add(a, a, 0);
  const real cell = norm(all.high - all.low) / 100000 + tiny;
  order.clear(), elements.clear();
  for (const Element& e : mesh.elements)
    order.push_back({place_on_curve(mesh.corner(e, 0) - all.low, cell), count(order)});
  std::sort(order.begin(), order.end());
  for (const auto& o : order) elements.push_back(o.second);
  mesh_tree.build(count(elements), [&](int k, Box& box) {
    const Element& e = mesh.elements[elements[k]];
    for (int c = 0; c < e.n; ++c) box.add(mesh.corner(e, c), mesh.corner(e, c), p.Rmesh[e.group]);
  });
}
void Simulation::add(const Particle& a) {
  const real m = 4 * pi / 3 * p.rho * a.R * a.R * a.R;
  x.emplace_back(a.x, a.R), v.emplace_back(a.v, 1 / m), w.emplace_back(a.w, 1 / a.R);
  q.emplace_back(Vec3{a.q[0], a.q[1], a.q[2]}, a.q[3]);
  f.emplace_back(), t.emplace_back(), x0.push_back(x.back()), id.push_back(count(id));
  radii += a.R, supplied += m * (square(a.v) / 2 + square(a.R) * square(a.w) / 5 - dot(p.g, a.x));
  stale = true;
}
/// Uniform in [0, 1): the 53 upper bits, the same on every machine.
real Simulation::uniform() { return ++draws, real(double(random() >> 11) * 0x1p-53); }
/// No particle and no mesh element within the sphere?
bool Simulation::is_free(const Vec3& centre, real R) const {
  bool free = true;
  real excess = 0;
  for (const Slab& b : slabs) excess = max(excess, b.excess);
  const auto check = [&](const Row& other) {
    free = free && square(centre - other.xyz()) >= square(R + other.c[3]);
  };
  const auto check_particle = [&](int j) { check(x[j]); };
  const auto check_element = [&](int k) { check(closest(*this, elements[k], centre)); };
  particle_tree.visit(centre, R + excess, 0, check_particle);
  for (int j = particle_tree.n; j < size(); ++j) check(x[j]);  // spawned a moment ago
  if (free) mesh_tree.visit(centre, R, 0, check_element);
  return free;
}
/// Draws places in the spawn box; a radius that found no room waits for the next attempt.
void Simulation::spawn() {
  const Vec3 box = p.smax - p.smin;
  for (long k = 0; k < p.Nspawn && size() < p.Nmax; ++k) {
    const Vec3 place = p.smin + Vec3{uniform() * box.x, uniform() * box.y, uniform() * box.z};
    if (spawn_radius <= 0) spawn_radius = p.Rmin + (p.Rmax - p.Rmin) * uniform();
    if (is_free(place, spawn_radius))
      add({place, std::exchange(spawn_radius, real(0)), p.v0, {1, 0, 0, 0}, p.w0});
  }
}

/// How far around itself a particle looks for partners: its radius, and what it covers until the
/// list is built anew. `horizon` balances the cost of building against that of idle pairs.
void Simulation::choose_reach() {
  constexpr double build = 200, carry = 1.5;  // measured [ns]: per particle, per idle pair and step
  double idle = 0;
  for (const Slab& b : slabs) idle += double(b.pairs.size() + b.walls.size()) - double(b.contacts);
  const bool early = build * size() > carry * idle * double(steps - listed_at);
  if (!stale) horizon = std::clamp(horizon * real(early ? 1.1 : 0.9), real(0.2), real(20));
  const real mean = radii / real(max(size(), 1));
  for (int i = 0; i < size(); ++i)
    x0[i] = Row(x[i].xyz(), x[i].c[3] + horizon * (mean / 50 + 10 * p.dt * norm(v[i].xyz())));
}
/// Sorts particles along a space-filling curve, so that neighbours in space are near in memory.
void Simulation::sort_particles() {
  const real cell = 2 * radii / real(max(size(), 1)) + tiny;
  order.clear();
  for (int i = 0; i < size(); ++i) order.push_back({place_on_curve(x[i].xyz(), cell), i});
  std::sort(order.begin(), order.end());
  Rows sorted(x.size());
  for (Rows* rows : {&x, &v, &w, &q, &x0}) {
    for (int i = 0; i < size(); ++i) sorted[i] = (*rows)[order[i].second];
    rows->swap(sorted);
  }
  vector<int> sorted_id;
  for (const auto& o : order) sorted_id.push_back(id[o.second]);
  id.swap(sorted_id);
  particle_tree.build(size(),
                      [&](int i, Box& box) { box.add(x[i].xyz(), x[i].xyz(), x0[i].c[3]); });
}
/// Appends a pair to a list of a slab, with the springs that it had before the particles were
/// sorted.
void Simulation::enlist(Slab& b, vector<Pair>& list, int i, int j) const {
  const bool wall = &list == &b.walls;
  const auto recall = [&](int owner, int partner, real sign) {
    if (owner >= count(first_pair) || spring_rows == 0) return false;
    const Slab& s = old[(long(owner + 1) * count(old) - 1) / count(first_pair)];
    const vector<Pair>& known = wall ? s.walls : s.pairs;
    for (int k = (wall ? first_wall : first_pair)[owner]; k < count(known) && known[k].i == owner;
         ++k) {
      if (known[k].j != partner || known[k].spring <= Pair::never) continue;
      const Row* u = &s.springs[known[k].spring * spring_rows];
      list.back().spring = count(b.springs) / spring_rows;
      b.springs.emplace_back(sign * u->xyz(),
                             u->c[3]);  // seen from the other side, us changes its sign
      b.springs.insert(b.springs.end(), u + 1, u + spring_rows);
      return true;
    }
    return false;
  };
  list.push_back({i, j, Pair::never});
  const int was_i = order[i].second, was_j = wall ? j : order[j].second;
  if (!recall(was_i, was_j, 1) && !wall) recall(was_j, was_i, -1);
}
/// Lists what the particles of a slab may touch before one of them has left its reach.
void Simulation::find_pairs(Slab& b) {
  for (int i = b.first; i < b.last; ++i) {
    const auto near = [&](const Row& other) {
      return square(x[i].xyz() - other.xyz()) < square(x0[i].c[3] + other.c[3]);
    };
    const auto particle = [&](int j) {  // half of the pairs in a slab, both halves across slabs
      if ((j > i || j < b.first) && near(x0[j])) enlist(b, b.pairs, i, j);
    };
    const auto element = [&](int k) {
      if (near(closest(*this, elements[k], x[i].xyz()))) enlist(b, b.walls, i, elements[k]);
    };
    particle_tree.visit(x[i].xyz(), x0[i].c[3], 0, particle);
    mesh_tree.visit(x[i].xyz(), x0[i].c[3], 0, element);
  }
}
/// Builds the neighbour list anew and carries the friction history over.
void Simulation::list_neighbours() {
#pragma omp barrier
#pragma omp single
  {
    choose_reach();
    first_pair.assign(size_t(slabs.back().last), 0), first_wall = first_pair;
    for (const Slab& b : slabs) {  // where the contacts of each particle start
      for (int c = count(b.pairs); c-- > 0;) first_pair[b.pairs[c].i] = c;
      for (int c = count(b.walls); c-- > 0;) first_wall[b.walls[c].i] = c;
    }
    old.swap(slabs);
    slabs.assign(size_t(std::clamp(2 * std::cbrt(size() / 1000.0), 1.0, 64.0)), Slab());
    for (long k = 0, n = count(slabs); k < n; ++k)
      slabs[k].first = int(size() * k / n), slabs[k].last = int(size() * (k + 1) / n);
    sort_particles();
  }
#pragma omp for schedule(static)
  for (int k = 0; k < count(slabs); ++k) find_pairs(slabs[k]);
#pragma omp single
  old.clear(), ++rebuilds, listed_at = steps, stale = false;
}

/// One time step, by all threads of a team; false when the run became unstable.
bool Simulation::step() {
  real excess = -1;
  for (const Slab& b : slabs) {
    if (b.failed) return false;
    excess = max(excess, b.excess);
  }
  if (stale || excess > 0) list_neighbours();
  const bool spawning = p.Nspawn > 0 && size() < p.Nmax;  // asked before a barrier, so by all alike
#pragma omp for schedule(static)
  for (int k = 0; k < count(slabs); ++k) force_phase(*this, slabs[k]);
#pragma omp for schedule(static)
  for (int k = 0; k < count(slabs); ++k) {
    motion_phase(*this, slabs[k]);
    if (k == 0) ++steps;
  }
  if (spawning) {
#pragma omp single
    spawn();
  }
  return true;
}
void Simulation::run(long n) {
#ifdef _OPENMP
#pragma omp parallel num_threads(min(omp_get_max_threads(), count(slabs)))
#endif
  for (long k = 0; k < n && step(); ++k) {}
  for (const Slab& b : slabs)
    if (b.failed)
      throw RunError("particle " + to_string(id[b.culprit] + 1) + " " + b.reason +
                     " at t = " + text(time()) + "; try a smaller --dt (now " + text(p.dt) +
                     "), a larger --E or thicker mesh elements");
}

vector<Particle> Simulation::particles() const {
  vector<Particle> all(x.size());
  for (int i = 0; i < size(); ++i)
    all[id[i]] = {x[i].xyz(),
                  x[i].c[3],
                  v[i].xyz(),
                  {q[i].c[0], q[i].c[1], q[i].c[2], q[i].c[3]},
                  w[i].xyz()};
  return all;
}
vector<Contact> Simulation::contacts() const {
  vector<Contact> all;
  const auto look = [&](const Slab& b, const Pair& pair, bool wall) {
    const Body<real> i = body<real>(*this, &pair.i);
    const Row point = wall ? closest(*this, pair.j, i.x) : Row();
    const Body<real> j =
        wall ? Body<real>{point.xyz(), point.c[3], {}, 0, {}, 0} : body<real>(*this, &pair.j);
    if (square(i.x - j.x) >= square(i.R + j.R)) return;
    const bool known = spring_rows > 0 && pair.spring > Pair::never;
    const Row u0 = known ? b.springs[pair.spring * spring_rows] : Row();
    const Row u1 = known && spring_rows > 1 ? b.springs[pair.spring * spring_rows + 1] : Row();
    Springs<real> u{u0.xyz(), u1.xyz(), u0.c[3]};
    const auto c = wall ? approach<true>(i, j) : approach<false>(i, j);
    Material<real> mat = wall ? wall_material : pair_material;
    mat.dt = 0;  // look, do not advance
    const Loads<real> load = contact_law<Modes<1, 1, 1>>(c, u, mat);
    const real energy = load.kn * (real(0.4) * square(c.delta) + square(u.ur) / 2) +
                        load.ks * (square(u.us) + square(u.ut)) / 2;
    all.push_back({id[pair.i], wall ? -1 : id[pair.j], wall ? pair.j : -1, c.delta,
                   wall ? i.R : min(i.R, j.R), c.mstar, load.kn, load.fn, load.f - load.fn, u.us,
                   u.ur, u.ut, energy});
  };
  for (const Slab& b : slabs) {
    for (const Pair& c : b.pairs)
      if (c.i < c.j) look(b, c, false);  // one half of those across slabs
    for (const Pair& c : b.walls) look(b, c, true);
  }
  return all;
}
Summary Simulation::summary() const {
  Summary s;
  for (int i = 0; i < size(); ++i) {
    const real m = 1 / v[i].c[3];
    s.kinetic += m / 2 * square(v[i].xyz()), s.potential -= m * dot(p.g, x[i].xyz());
    s.rotational += m / 5 * square(x[i].c[3]) * square(w[i].xyz());
  }
  real shortest = inf;  // An elastic collision lasts 2.943 delta/v, with m* v^2/2 = 2/5 kn delta^2
  for (const Contact& c : contacts()) {  // that is 3.29 sqrt(m*/kn).
    ++s.contacts, s.elastic += c.energy, s.overlap = max(s.overlap, c.delta / c.R);
    shortest = min(shortest, real(3.29) * sqrt(c.mstar / c.kn));
  }
  if (s.contacts > 0) s.steps = shortest / p.dt;
  return s;
}
/// Hands everything that a run needs to go on to `bytes`. A run that goes on after saving and one
/// that starts from loading both build a new list first: the same bits.
template <class F> void Simulation::archive(F bytes) {
  const auto array = [&](auto& a) {
    size_t n = a.size();
    bytes(&n, sizeof n), a.resize(n), bytes(a.data(), n * sizeof a[0]);
  };
  size_t n = slabs.size();
  bytes(&n, sizeof n), slabs.resize(n), array(id);
  for (long* a : {&steps, &rebuilds, &listed_at, &draws}) bytes(a, sizeof *a);
  for (real* a : {&supplied, &radii, &spawn_radius, &horizon}) bytes(a, sizeof *a);
  for (Rows* rows : {&x, &v, &w, &q}) array(*rows);
  for (Slab& b : slabs)
    bytes(&b.first, sizeof(int)), bytes(&b.last, sizeof(int)), array(b.pairs), array(b.walls),
        array(b.springs);
  stale = true;
}
void Simulation::save(std::ostream& file) {
  archive([&](void* data, size_t n) { file.write(static_cast<char*>(data), long(n)); });
}
void Simulation::load(std::istream& file) {
  archive([&](void* data, size_t n) {
    if (!file.read(static_cast<char*>(data), long(n)))
      throw InputError("restart.bin does not fit; use --overwrite");
  });
  f.assign(x.size(), {}), t = f, x0 = x, random.discard(std::uint64_t(draws));
}

}  // namespace tinydem

// --------------------------------------------------------------------------------- 4 program
#ifndef TINYDEM_NO_MAIN
namespace tinydem {
namespace fs = std::filesystem;

/// A file that gets its name when it is complete.
struct Output : std::ofstream {
  fs::path path, part;
  explicit Output(const fs::path& p) : path(p), part(p.string() + ".part") {
    open(part, std::ios::binary);
  }
  ~Output() override {
    std::error_code ignored;
    if (is_open()) fs::remove(part, ignored);
  }
  void commit() {
    close();
    if (!fail()) return fs::rename(part, path);
    fs::remove(part);
    throw RunError(path.string() +
                   ": cannot be written; check permissions and free space, then --resume");
  }
};
static fs::path numbered(const fs::path& folder, const string& name, long frame) {
  return folder / (name + to_string(1000000 + frame).substr(1) + ".csv");
}
static string restart_magic() {
  return string("TinyDEM ") + version + " " + to_string(sizeof(real)) + " ";
}
/// Writes particles*.csv, contacts*.csv, a line of log.csv and restart.bin.
static Summary write_frame(Simulation& s, long frame, double speed) {
  const fs::path folder = s.p.output;
  Output particles(numbered(folder, "particles", frame)), restart(folder / "restart.bin");
  particles << csv_header << "\n";
  for (Particle& a : s.particles()) {
    Reals values;
    for (const real* c : a.columns()) values.push_back(*c);
    particles << text(values, std::numeric_limits<real>::max_digits10) << "\n";
  }
  particles.commit();
  if (s.p.contacts == "on") {
    Output contacts(numbered(folder, "contacts", frame));
    contacts << "i,j,element,delta,fnx,fny,fnz,fsx,fsy,fsz,usx,usy,usz,urx,ury,urz,ut\n";
    for (const Contact& c : s.contacts())
      contacts << text({real(c.i), real(c.j), real(c.element), c.delta, c.fn.x, c.fn.y, c.fn.z,
                        c.fs.x, c.fs.y, c.fs.z, c.us.x, c.us.y, c.us.z, c.ur.x, c.ur.y, c.ur.z,
                        c.ut})
               << "\n";
    contacts.commit();
  }
  const Summary e = s.summary();
  std::ofstream log(folder / "log.csv", frame == 0 ? std::ios::trunc : std::ios::app);
  if (frame == 0)
    log << "frame,t,N,contacts,kinetic,rotational,potential,elastic,dissipated,overlap,"
           "steps_per_contact,updates_per_second\n";
  log << text({real(frame), s.time(), real(s.size()), real(e.contacts), e.kinetic, e.rotational,
               e.potential, e.elastic,
               s.supplied - e.kinetic - e.rotational - e.potential - e.elastic, e.overlap, e.steps,
               real(speed)})
      << "\n";
  if (!log.flush())
    throw RunError((folder / "log.csv").string() +
                   ": cannot be written; free some space, then --resume");
  restart << restart_magic() << frame << "\n";
  s.save(restart);
  return restart.commit(), e;
}
/// Goes back to the last complete frame; the next frame, or 0 when there is none.
static long resume(Simulation& s) {
  const fs::path folder = s.p.output;
  std::ifstream file(folder / "restart.bin", std::ios::binary), log(folder / "log.csv");
  string line;
  if (!fs::exists(folder / "restart.bin")) return 0;
  std::getline(file, line);
  const size_t magic = restart_magic().size();
  if (line.compare(0, magic, restart_magic()) != 0)
    throw InputError((folder / "restart.bin").string() +
                     ": does not fit this program; use --overwrite");
  const long frame = std::stol(line.substr(magic));
  s.load(file);
  for (long k = -1; k <= frame; ++k) std::getline(log, line);
  return fs::resize_file(folder / "log.csv", std::uintmax_t(log.tellg())), frame + 1;
}
/// Prepares the output directory: refuses to mix runs, keeps copies of what the run is made from.
static void open_folder(Parameters p, bool overwrite) {
  std::error_code error;
  const fs::path folder = p.output;
  if (fs::create_directories(folder, error); !fs::is_directory(folder))
    throw InputError(p.output + (fs::exists(folder) ? ": is a file" : ": cannot be created") +
                     "; name another directory");
  vector<fs::path> old;
  for (const auto& f : fs::directory_iterator(folder))
    for (const char* name : {"scene.ini", "log.csv", "restart.bin", "particles", "contacts"})
      if (f.path().filename().string().rfind(name, 0) == 0) old.push_back(f.path());
  if (!old.empty() && !overwrite)
    throw InputError(p.output +
                     ": holds a run; add --overwrite or --resume, or name another directory");
  const auto keep = [&](string& file, const char* name) {
    if (file.empty() || fs::equivalent(file, folder / name, error)) return;
    fs::copy_file(file, folder / name, fs::copy_options::overwrite_existing);
  };
  keep(p.mesh, "mesh.off"), keep(p.particles, "input.csv");
  for (const auto& f : old) fs::remove(f);
  Output ini(folder / "scene.ini");
  ini << "# TinyDEM " << version
      << ": tinydem --scene with this file repeats the run bit for bit\n";
  for (const Option& o : options(p)) {
    const string name = o.name, value = name == "mesh"        ? "mesh.off"
                                        : name == "particles" ? "input.csv"
                                                              : text(o);
    if (name != "output" && !text(o).empty()) ini << name << " = " << value << "\n";
  }
  ini.commit();
}

struct Command {
  bool overwrite = false, resume = false, quiet = false;
  string scene{};
  vector<Setting> settings{};
};
static Command read_command(int argc, char** argv) {
  Command c;
  Parameters defaults;
  std::map<string, std::pair<string, CLI::Option*>> given;
  CLI::App app{
      "TinyDEM, teaching edition: soft spheres with sliding, rolling and twisting friction"};
  app.set_version_flag("--version", version);
  app.add_option("--scene", c.scene, "scene file: lines name = value with the names below");
  app.add_flag("--overwrite", c.overwrite, "replace the run in the output directory");
  app.add_flag("--resume", c.resume, "go on with the run in the output directory");
  app.add_flag("--quiet", c.quiet, "no lines on the standard output");
  const auto write_contacts = [&] { c.settings.push_back({"contacts", "on", "command line"}); };
  app.add_flag_callback("--contacts", write_contacts, "write the contacts of every frame");
  for (const Option& o : options(defaults)) {
    if (o.name == string("contacts")) continue;
    const string name = o.name, formula = name == "dt" ? "Eq. 50" : name == "mut" ? "2/3 mus" : "";
    const string help = string(o.help) + " [" + o.dimension + "], " + o.range + ", default " +
                        (formula.empty() ? text(o) : formula);
    auto& [value, option] = given[name];
    option = app.add_option((string(o.range) == "path" ? "" : "--") + name, value, help);
    option->type_name("");
  }
  app.allow_extras();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) std::exit(app.exit(e));
    throw InputError(string("command line: ") + e.what() + "; see --help");
  }
  for (const auto& [name, a] : given)  // an empty string skips a path
    if (a.second->count() > 0 && !(a.first.empty() && a.second->get_positional()))
      c.settings.push_back({name, a.first, "command line"});
  for (const string& extra : app.remaining())
    c.settings.push_back(
        {extra.substr(min(extra.find_first_not_of('-'), extra.size())), "", "command line"});
  return c;
}
static void run(const Command& command) {
  const auto settings = [&](const string& scene) {
    auto all = scene.empty() ? vector<Setting>() : read_scene(scene);
    all.insert(all.end(), command.settings.begin(), command.settings.end());
    return resolve(all);
  };
  Parameters p = settings(command.scene);
  const string folder = p.output, ini = (fs::path(folder) / "scene.ini").string();
  const bool resuming = command.resume && fs::exists(ini);
  if (resuming) p = settings(ini), p.output = folder;
  Simulation s(p, p.mesh.empty() ? Mesh() : read_mesh(p.mesh, p.Rmesh.size()),
               p.particles.empty() ? vector<Particle>() : read_particles(p.particles));
  if (!resuming) open_folder(p, command.overwrite);
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  const long first = resuming ? resume(s) : 0;
  const double start = now();
  for (long frame = first; frame <= p.Nframes; ++frame) {
    const double begin = now();
    if (frame > 0) s.run(p.Nsteps);
    const Summary e = write_frame(s, frame, double(s.size()) * double(p.Nsteps) / (now() - begin));
    if (!command.quiet)
      std::cout << "frame " << frame << "/" << p.Nframes << "  t = " << s.time()
                << "  N = " << s.size() << "  contacts = " << e.contacts
                << "  kinetic energy = " << e.kinetic + e.rotational << std::endl;
    const double spent = now() - start,
                 left = spent / double(max(frame - first, 1L)) * double(p.Nframes - frame);
    if (isatty(2))
      std::cerr << "\r" << 100 * frame / max(p.Nframes, 1L) << " %, " << long(spent) << " s, "
                << long(left) << " s to go   " << (frame == p.Nframes ? "\n" : "") << std::flush;
  }
}
}  // namespace tinydem

int main(int argc, char** argv) {
  try {
    tinydem::run(tinydem::read_command(argc, argv));
  } catch (const tinydem::InputError& e) {
    return std::cerr << "error: " << e.what() << std::endl, 2;
  } catch (const std::exception& e) {
    return std::cerr << "error: " << e.what() << std::endl, 1;
  }
}
#endif
