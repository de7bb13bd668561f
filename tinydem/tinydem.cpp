// TinyDEM, teaching edition: the physics of the solver. Equation numbers: R. Vetter, TinyDEM,
// Comput. Phys. Commun. (2025) 109942. [D1]-[D3] mark the three statements in which --scheme
// consistent differs from the printed algorithm, see docs/deviations.md. Build:
// g++ -std=c++17 -O3 -fopenmp -I/usr/include/eigen3 -o tinydem tinydem.cpp
#include "tinydem.hpp"
#include <map>
extern "C" int omp_get_max_threads() noexcept;
#ifdef __GLIBC__  // M_MMAP_THRESHOLD stays at 1 MB: the memory of large old lists is given back
extern "C" int mallopt(int, int) noexcept; [[maybe_unused]] const int done = mallopt(-3, 1 << 20);
#endif
namespace tinydem {
// ------------------------------------------------------------------------------ 1 parameters
/// A parameter; type is the first letter of its type in the table.
struct Option { const char *name, *dimension, *range, *help; void* at; char type;
  template <class T> T& as() const { return *static_cast<T*>(at); } Reals numbers() const {
    return type == 's' ? Reals() : type == 'R' ? as<Reals>() : type == 'l' ? Reals{real(as<long>())}
                       : Reals(&as<real>(), &as<real>() + (type == 'V' ? 3 : 1)); } };
#define TINYDEM_OPTION(name, type, value, ...) {#name, __VA_ARGS__, &p.name, #type[0]},
static vector<Option> options(Parameters& p) { return {TINYDEM_PARAMETERS(TINYDEM_OPTION)}; }
static string text(const Reals& values, int digits = 0) { string s;
  for (const real& a : values) { s += (&a == &values[0] ? "" : ",") + text(a, digits); } return s; }
static string text(const Option& o) { return o.type == 's' ? o.as<string>() : text(o.numbers()); }
/// Stores the text of a setting; false when it is malformed.
static bool assign(const Option& o, const string& s) { const auto words = split(o.range, '|');
  const bool known = words.size() == 1 || std::count(words.begin(), words.end(), s); Reals a;
  if (o.type == 's') return o.as<string>() = s, known;
  for (const string& word : split(s, ',')) if (a.push_back(0); !parse(word, a.back())) return false;
  if (o.type == 'R') return o.as<Reals>() = a, true;
  if (a.size() != o.numbers().size()) return false;
  if (o.type != 'l') return std::copy(a.begin(), a.end(), &o.as<real>()), true;
  return a[0] == std::floor(a[0]) && abs(a[0]) < real(4e18) && (o.as<long>() = long(a[0]), true); }
/// Reads the parameter `motion` into the groups that it names; false when it is malformed.
static bool read_motion(const Parameters& p, vector<Group>& groups) {
  for (const string& entry : split(p.motion, ';')) {
    const auto word = split(entry, ' '); const size_t n = word.size(); long k = -1;
    const auto put = [&](size_t i, void* at, char type) {
      return i < n && assign({"", "", "", "", at, type}, word[i]); }; if (n == 0) continue;
    if (!put(0, &k, 'l') || k < 0 || k >= count(groups) || n < 3 || groups[k].moves) return false;
    Group& g = groups[k]; const string& kind = word[1]; g.moves = true;
    if (!(kind == "translate" ? n == 3 && put(2, &g.V, 'V')
        : kind == "rotate" ? n == 4 && put(2, &g.P, 'V') && put(3, &g.W, 'V')
        : kind == "vibrate" && put(2, &g.A, 'V') && put(3, &g.F, 'r') && n <= 5 &&
          (n == 4 || put(4, &g.phase, 'r')))) return false; } return true; }
/// Are the numbers of an option in its range, e.g. "(-1, 0.5]", "[Rmin, inf)"?
static bool in_range(const Option& o, const Parameters& p) {
  double low = -HUGE_VAL, high = HUGE_VAL; std::sscanf(o.range + 1, "%lf, %lf", &low, &high);
  const Reals a = o.numbers(); vector<Group> groups(p.Rmesh.size()); for (const real v : a)
    if (!(v >= real(low) && v <= real(high)) || (v == real(low) && *o.range == '(')) return false;
  return (o.at != &p.Rmax || a[0] >= p.Rmin) && (o.at != &p.motion || read_motion(p, groups)) &&
         (o.at != &p.smax || (a[0] >= p.smin.x && a[1] >= p.smin.y && a[2] >= p.smin.z)); }
/// Number of letters that are in one name only.
static long distance(const string& a, const string& b) { long d = 0;
  const auto in = [](auto& s, int c) { return std::count_if(s.begin(), s.end(), [c](int l) {
    return std::tolower(l) == c; }); };
  for (int c = '0'; c <= 'z'; ++c) { d += abs(in(a, c) - in(b, c)); } return d; }
vector<Setting> read_scene(const string& path) { Reader in(path); vector<Setting> all;
  while (in.next('=')) {
    if (in.tokens.size() != 2) in.complain("'" + in.line + "' must be name = value");
    Setting s{in.tokens[0], in.tokens.back(), in.where()};
    if (s.name == "mesh" || s.name == "particles" || s.name == "output")
      s.text = (std::filesystem::path(path).parent_path() / s.text).string();
    for (const Setting& o : all)
      if (o.name == s.name) in.complain("'" + s.name + "' is repeated, it stands in " + o.where);
    all.push_back(s); } return in.problems.stop_if_any(), all; }
static real default_step(const Parameters& p) {
  return p.Rmin * sqrt(p.rho * (1 - p.nu * p.nu) / p.E); }                      // Eq. (50)
Parameters resolve(const vector<Setting>& settings) {
  Parameters p; Problems problems; std::map<string, Setting> used;
  const auto complain = [&](const Option& o, const Setting& s) {
    const char* shape = o.type == 'r' ? "a number in " : o.type == 'l' ? "an integer in "
        : o.type == 'R' ? "numbers in " : o.type == 's' ? "one of " : "three numbers (0,0,1) in ";
    problems.add(s.where, s.name + " = '" + s.text + "' must be " + shape + o.range); };
  const vector<Option> table = options(p); for (const Setting& s : settings) {
    const auto off = [&](const Option& o) { return distance(o.name, s.name); };
    const Option& o = *std::min_element(table.begin(), table.end(),
                                        [&](auto& a, auto& b) { return off(a) < off(b); });
    if (s.name != o.name)
      problems.add(s.where, "'" + s.name + "' is unknown; " + (2 * off(o) > count(s.name) + 1 ?
                                "see --help" : string("did you mean '") + o.name + "'?"));
    else if (used[s.name] = s; !assign(o, s.text)) complain(o, s); }
  const auto place = [&](const Option& o) {  // of a wrong default: what its range depends on
    const auto low = used.find(split(o.range + 1, ',')[0]);
    return low == used.end() ? "default" : low->second.where; };
  if (std::isnan(p.mut)) p.mut = 2 * p.mus / 3;                                 // Eq. (41)
  if (std::isnan(p.dt)) { p.dt = default_step(p); } for (const Option& o : table)
    if (!in_range(o, p) && (used.count(o.name) || problems.count == 0))
      complain(o, used.count(o.name) ? used[o.name] : Setting{o.name, text(o), place(o)});
  return problems.stop_if_any(), p; }
// ---------------------------------------------------------------------------- 2 contact law
//     i          d = x_i - x_j points from j to i, n = d/|d|; forces act on i, and with the
//   ( ^ )        opposite sign on j. T is the type of one number. The compiler turns these lines
//    -n-  delta  into vector instructions: to change the law, write `select(condition, a, b)`
//   (   )        where you would write `if`, e.g. for an attraction of range h:
//     j          fn = fn - select(c.delta < h, F0, T(0));
template <class T> INLINE T select(bool c, T a, T b) { return c ? a : b; }
template <class T> INLINE Vec<T> select(bool c, const Vec<T>& a, const Vec<T>& b) {
  return {select(c, a.x, b.x), select(c, a.y, b.y), select(c, a.z, b.z)}; }
template <class T> Material<T> material_of(const Parameters& p) {
  const T E = T(p.E), nu = T(p.nu), en = T(p.en); Material<T> m; m.unit = T(0.75 / pi / p.rho);
  m.Estar = E / (2 * (1 - nu * nu));                                            // Eq. (15)
  m.Gstar = E / (4 * (2 - nu) * (1 + nu));                                      // Eq. (16)
  m.beta = 1 / std::sqrt(1 + std::pow(T(pi) / std::log(en), T(2)));             // Eq. (21)
  m.cs_cn = std::sqrt((1 - nu) / (10 * (2 - nu)));                              // Eq. (25)
  m.kn_ks = m.Estar / (6 * m.Gstar);                                            // Eqs. (12, 13)
  m.mus = T(p.mus), m.mur = T(p.mur), m.mut = T(p.mut), m.dt = T(p.dt); return m; }
/// Geometry and relative motion of a contact; R: the smaller radius, stiff: 2 at a wall, else 1.
template <class T> struct Approach {
  T delta, R, ri, rj, Rstar, mstar, vn, vt, stiff; Vec<T> n, vs, vr; };
template <class T> INLINE Approach<T> approach(const Body<T>& i, const Body<T>& j) { Approach<T> c;
  const bool wall = j.R_inv == 0; c.R = select(wall, i.R, min(i.R, j.R));
  c.stiff = select(wall, T(2), T(1));                                           // Eqs. (22, 23)
  const Vec<T> d = i.x - j.x;                                                   // Eq. (8)
  const T distance = norm(d);
  c.delta = i.R + j.R - distance;                                               // Eq. (7)
  const T inverse = 1 / distance;
  c.n = inverse * d;                                                            // Eq. (9)
  const T R_inv = i.R_inv + j.R_inv, m_inv = i.m_inv + j.m_inv, product = 1 / (R_inv * m_inv);
  c.Rstar = product * m_inv;  // 1 / R_inv, with one division for both          // Eq. (17)
  c.mstar = product * R_inv;                                                    // Eqs. (20, 24)
  c.ri = i.R - c.delta / 2;                                                     // Eq. (29)
  c.rj = j.R - c.delta / 2;                                                     // Eq. (30)
  const Vec<T> v = i.v - j.v + cross(c.n, c.ri * i.w + c.rj * j.w);             // Eq. (26)
  c.vn = dot(i.v - j.v, c.n);  // spins add nothing along n                     // Eq. (27)
  c.vs = v - c.vn * c.n;                                                        // Eq. (28)
  const Vec<T> w = i.w - j.w;                                                   // Eq. (38)
  const T r = select(wall, c.ri, c.ri * c.rj * inverse);  // r_i + r_j = |d|
  c.vr = r * cross(w, c.n);                                                     // Eq. (36)
  c.vt = c.Rstar * dot(w, c.n); return c; }                                     // Eq. (37)
/// Turns a spring into the tangent plane and keeps its length, Eq. (52).
template <class T> INLINE Vec<T> turn(const Vec<T>& u, const Vec<T>& n) {
  const Vec<T> flat = u - dot(u, n) * n; const T scale = sqrt(square(u) / square(flat));
  return select(square(flat) > 0, scale * flat, flat); }
template <class T> struct Mode { T k, k_inv, c, dt; };  // stiffness, 1/k, damping, time step
template <class T> INLINE Vec<T> along(T length, const Vec<T>& f) { return length / norm(f) * f; }
template <class T> INLINE T along(T length, T f) { return f < 0 ? -length : length; }
/// Force of a friction mode, at most `limit`; advances its spring. V: vector (s, r) or number (t).
template <class M, class T, class V> INLINE V friction(V& u, const V& v, Mode<T> m, T limit) {
  if (!M::printed) u = u + m.dt * v;                                            // Eq. (53) [D1]
  V f = -m.k * u - m.c * v;                                                     // Eqs. (6, 34, 35)
  if (M::printed) u = u + m.dt * v;                                             // Eq. (53)
  const bool slip = norm(f) > limit;                                            // Eqs. (11, 39, 40)
  f = select(slip, along(limit, f), f);                                         // Eq. (54)
  const V rest = M::printed ? f + m.c * v : f;                                  // Eq. (55) [D2]
  u = select(slip, -m.k_inv * rest, u); return f; }                             // Eq. (55)
template <class T> struct Loads { Vec<T> f, ti, tj, fn; T kn, ks; };  // force on i, both torques
/// The contact law. M says which friction modes the scene has.
template <class M, class T>
INLINE Loads<T> contact_law(const Approach<T>& c, Springs<T>& u, const Material<T>& mat) {
  Loads<T> r; const T a = sqrt(c.Rstar * c.delta);                              // Eq. (14)
  const T kn = T(4) / 3 * (c.stiff * mat.Estar) * a;                            // Eq. (12)
  const T ks = 8 * (c.stiff * mat.Gstar) * a;                                   // Eq. (13)
  const T cn = mat.beta * sqrt(5 * c.mstar * kn);                               // Eq. (18)
  const T cs = mat.cs_cn * cn;                                                  // Eqs. (19, 25)
  const T fn = kn * c.delta - cn * c.vn;                                        // Eqs. (5, 10)
  const T load = norm(fn), kn_inv = 1 / kn;
  const Mode<T> n{kn, kn_inv, cn, mat.dt}, s{ks, mat.kn_ks * kn_inv, cs, mat.dt};
  r.f = fn * c.n, r.fn = fn * c.n, r.kn = kn, r.ks = ks;
  if constexpr (M::sliding) {
    u.us = turn(u.us, c.n);                                                     // Eq. (52)
    const Vec<T> fs = friction<M>(u.us, c.vs, s, mat.mus * load);               // Eq. (6)
    r.f += fs;
    r.ti = c.ri * cross(fs, c.n);                                               // Eq. (31)
    r.tj = c.rj * cross(fs, c.n); }                                             // Eq. (60)
  if constexpr (M::rolling) {
    u.ur = turn(u.ur, c.n);                                                     // Eq. (52)
    const Vec<T> fr = friction<M>(u.ur, c.vr, n, mat.mur * load);               // Eq. (34)
    const Vec<T> tr = c.Rstar * cross(c.n, fr);                                 // Eq. (32)
    r.ti += tr, r.tj += -tr; }                                                  // Eq. (58)
  if constexpr (M::twisting) {
    const T ft = friction<M>(u.ut, c.vt, s, mat.mut * load);                    // Eq. (35)
    const Vec<T> tt = ft * c.Rstar * c.n;                                       // Eq. (33)
    r.ti += tt, r.tj += -tt; } return r; }                                      // Eq. (59)
// ------------------------------------------------------------------------------- 3 time step
template <bool s, bool r, bool t, bool p = false> struct Modes {  // what is compiled in
  static constexpr bool sliding = s, rolling = r, twisting = t, printed = p, any = s || r || t; };
static void fail(Slab& b, int i, const char* s) { if (b.culprit < 0) b.culprit = i, b.reason = s; }
/// A mesh element as a particle of velocity v sees it: a body at its closest point. v is that of
/// the middle of the last step, Eqs. (44, 45); so is the velocity of the surface, where x was then.
Body<real> Simulation::wall(int element, const Vec3& centre, const Vec3& v) const {
  const Element& e = mesh.elements[element]; const Group& g = groups[e.group];
  const Pane& f = panes[element]; const Vec3 c = g.moves ? g.back(centre) : centre;
  const auto inside = [](real s) { return 0 < s && s < 1; };
  const bool above = e.n == 4 && inside(dot(c - f.a, f.u)) && inside(dot(c - f.a, f.v));
  Vec3 x = above ? c - dot(c - f.a, f.n) * f.n : closest_point(mesh, e, c);
  const real R = p.Rmesh[e.group]; if (!g.moves) return {{x, R, {}, 0}, {}, 0};
  return x = g.there(x), Body<real>{{x, R, g.v + cross(g.W, x - p.dt / 2 * v - g.P), 0}, g.W, 0}; }
/// Is pair k, a particle and the point c of a mesh element, a contact? A point that elements of a
/// group share counts once, for the nearest. `heir`: a former contact that lost its point to k.
bool Simulation::is_nearest(const Slab& b, int k, const Body<real>& c, Walls& w, int& heir) const {
  const auto& pairs = b.pairs; const int i = pairs[k].i; const Grain& a = grains[i];
  const auto rival = [&](int l) {
    return l >= 0 && l < count(pairs) && pairs[l].i == i && pairs[l].j < 0; };
  if (heir = -1; !rival(k - 1) && !rival(k + 1)) return true;
  const auto group = [&](int l) { return mesh.elements[-1 - pairs[l].j].group; };
  const auto point = [&](int l, const Vec3& x) { return wall(-1 - pairs[l].j, x).x; };
  const real tiny = same_point * a.R, near = tiny + p.dt * norm(a.v - c.v);  // a step moves c
  const auto on = [&](int l) { return norm(c.x - point(l, c.x)) < tiny; };
  if (w.i != i) { w.i = i, w.points.clear(), w.first = k; while (rival(w.first - 1)) --w.first;
    for (int l = w.first; rival(l); ++l) w.points.push_back(l == k ? c.x : point(l, a.x)); }
  const bool fresh = !(pairs[k].touching & 1); bool nearest = true; int l = w.first - 1;
  for (const Vec3& q : w.points) if (++l != k && nearest && group(l) == group(k)) {
    const Vec3 up = a.x - q; const real far = square(up) - square(a.x - c.x);
    if (far < 0 || (far == 0 && l < k)) nearest = dot(c.x - q, up) > tiny * a.R || !on(l);
    else if (fresh && (pairs[l].touching >> (l < k)) & 1 && norm(q - c.x) < near) heir = l; }
  return nearest; }
/// Updates the state of a contact with the mesh: its springs come over a seam, turn with the group.
bool Simulation::touch_mesh(Slab& b, int k, const Body<real>& c, Walls& w, bool touch) {
  Pair& at = b.pairs[k]; const Group& g = groups[mesh.elements[-1 - at.j].group]; int heir = -1;
  touch = touch && is_nearest(b, k, c, w, heir), at.touching = char(2 * (at.touching & 1) + touch);
  if (!touch || !friction || (at.touching == 3 && !g.moves)) return touch;
  if (at.touching == 3) { heir = k; } Springs<real> u{}; if (heir >= 0) u = b.springs.get(heir);
  if (g.moves) u.us = rotated(g.step, u.us), u.ur = rotated(g.step, u.ur);
  return b.springs.set(k, u), touch; }
struct Reaction { Vec3 f, ti, tj; real excess; };
/// Forces in all contacts of a slab, a block at a time, added up in a fixed order.
template <class M, bool vectors = true> INLINE void forces(Simulation& s, Slab& b) {
  const Material<real> mat = s.material; Walls walls; b.contacts = 0; Block<Springs<real>> spare{};
  int k[block]; Grain *ai[block], *aj[block], wall[block]; const bool far = s.size() > crowd;
  Grain *const grains = s.grains.data(), *const head = grains + b.first, *tail = grains + b.last;
  Block<std::conditional_t<M::any, Body<real>, Ball<real>>> bi, bj; Block<Reaction> reactions;
  for (int next = 0, n = 0, end = count(b.pairs); next < end; b.contacts += n, n = 0) {
    const bool held = next < b.held;
    auto* const us = held && M::any ? &b.springs[next / block] : &spare;
    if (held) for (; n < block; ++n, ++next) {  // not asked: no force acts where they have parted
      const Pair& p = b.pairs[next]; k[n] = next, ai[n] = &grains[p.i], aj[n] = &grains[p.j]; }
    else for (; next < end && n < block; ++next) {
      if (far) __builtin_prefetch(&grains[max(b.pairs[min(next + 16, end - 1)].j, 0)]);
      Pair& p = b.pairs[next]; Grain &a = grains[p.i], &c = p.j < 0 ? wall[n] : grains[p.j];
      if (p.j < 0) static_cast<Body<real>&>(c) = s.wall(-1 - p.j, a.x, a.v);
      const Vec3 d = a.x - c.x; bool touch = square(d) < square(a.R + c.R);     // Eq. (7)
      const real ahead = p.j < 0 ? dot(d, d + mat.dt * (a.v - c.v)) : 0;
      if (ahead < 0) fail(b, p.i, "passes through a mesh element");  // a fast wall may not touch it
      if (p.j < 0) { if (touch || p.touching) touch = s.touch_mesh(b, next, c, walls, touch); }
      else if (touch != p.touching) { p.touching = touch; if (M::any) b.springs.set(next, {}); }
      k[n] = next, ai[n] = &a, aj[n] = &c, n += touch; }
    bi.gather(n, [&](int l) { return ai[l]; }, vectors);
    bj.gather(n, [&](int l) { return aj[l]; }, vectors);
    if (M::any && !held) for (int l = 0; l < n; ++l) us->set(l, b.springs.get(k[l]));
    for (int m = 0; m < n; m += wide) {  // and meanwhile the next ones come into the cache
      if (held && far) for (int l = m; l < m + wide; ++l) {
        grains[b.pairs[min(next + l, b.held - 1)].j].fetch();
        if (M::any) __builtin_prefetch(us[1].c[0] + 8L * l); }
      for (int l = m; l < m + wide; ++l) {  // becomes vector instructions
        const Approach<real> c = approach(body(bi.get(l), mat.unit), body(bj.get(l), mat.unit));
        Springs<real> u{}; if (M::any) u = us->get(l);
        const Loads<real> r = contact_law<M>(c, u, mat); const bool parted = c.delta < 0;
        reactions.set(l, {r.f, r.ti, r.tj, parted ? -inf : c.delta - c.R - mat.dt * c.vn});
        if (M::any) us->set(l, {select(parted, {}, u.us), select(parted, {}, u.ur),
                                select(parted, {}, u.ut)}); }}
    for (int l = 0; l < n; ++l) {
      const Reaction r = reactions.get(l); if (r.excess == -inf) continue;
      Grain &i = *ai[l], &j = *aj[l]; if (!(r.excess <= 0)) fail(b, int(&i - grains), j.R_inv > 0 ?
          "overlaps another by more than a radius" : "passes through a mesh element");
      if (M::any && !held) b.springs[k[l] / block].set(k[l] % block, us->get(l));  // no call
      const Four f{r.f.x, r.f.y, r.f.z}, ti{r.ti.x, r.ti.y, r.ti.z}, tj{r.tj.x, r.tj.y, r.tj.z};
      four(i.f) += f; if (M::any) four(i.t) += ti;                              // Eqs. (1, 2)
      if (&j < head || &j >= tail) continue;  // a wall, or the other slab adds to j
      four(j.f) -= f; if (M::any) four(j.t) += tj; }} }                         // Eqs. (56, 57)
/// p q for side = 1, q p for side = -1.
INLINE Quaternion product(const Quaternion& p, const Quaternion& q, real side) {  // Eq. (49)
  return {p.s * q.s - dot(p.v, q.v), p.s * q.v + q.s * p.v + side * cross(p.v, q.v)}; }
constexpr real small_angle2 = real(0.004);  // below it the series are exact to the last digit
/// The quaternion (cos |h|, sin |h| h/|h|).
template <bool large> INLINE Quaternion rotation(const Vec3& h) {
  constexpr auto over = [](int n) { return 1 / real(n); }; const real h2 = square(h);
  if (large && h2 > small_angle2) return {std::cos(sqrt(h2)), std::sin(sqrt(h2)) / sqrt(h2) * h};
  return {1 - h2 * (over(2) - h2 * (over(24) - h2 * (over(720) - h2 * over(40320)))),
          (1 - h2 * (over(6) - h2 * (over(120) - h2 * (over(5040) - h2 * over(362880))))) * h}; }
template <bool large>
INLINE Quaternion turned(const Quaternion& q, const Vec3& h, const Vec3& k, real side) {
  const Quaternion phi = rotation<large>(h), theta = rotation<large>(k);        // Eq. (48)
  return product(theta, product(phi, q, side), side); }                         // Eq. (47)
struct alignas(4 * sizeof(real)) Turn { Vec3 h; real a; Vec3 k; real b; };  // a, b: fillers
/// Eqs. (42)-(49) for the particles of a slab; clears their forces. R, 1/m, 1/R have no step.
template <bool spins, bool orientation> INLINE void motion(Simulation& s, Slab& b) {
  const real dt = s.p.dt, stokes = real(4.5) * s.p.eta / s.p.rho;
  const bool far = s.size() > crowd; const real side = s.printed ? -1 : 1;      // Eq. (47) [D3]
  const Four gravity{s.p.g.x, s.p.g.y, s.p.g.z, 0}, step{dt, dt, dt, 0}; b.excess = -1;
  Turn turn[block]; Block<Turn> hk; real angle2[block];
  for (int at = b.first; at < b.last; at += block) { const int n = min(block, b.last - at);
    for (int l = 0; l < n; ++l) { Grain& g = s.grains[at + l]; const real room = g.room;
      if (far) s.grains[min(at + l + block, b.last - 1)].fetch();
      Four &x = four(g.x), &v = four(g.v), &w = four(g.w), &f = four(g.f), &t = four(g.t);
      const real R2_inv = square(g.R_inv);
      const real c = stokes * R2_inv, gamma = real(10) / 3 * c;                 // Eqs. (3, 4)
      const Four a = g.m_inv * f + gravity - c * v;                             // Eq. (42)
      v += step * a;                                                            // Eq. (44)
      x += step * v, f = Four{};                                                // Eq. (45)
      if (spins) { const Four alpha = real(2.5) * g.m_inv * R2_inv * t - gamma * w; // Eq. (43)
        four(turn[l].h) = dt / 2 * w, four(turn[l].k) = dt * dt / 4 * alpha;
        w += step * alpha, t = Four{};                                          // Eq. (46)
        if (!(square(g.w) < inf)) fail(b, at + l, "spins too fast for a finite energy"); }
      const real way = norm(dt * g.v); g.room = room - way, b.excess = max(b.excess, -g.room);
      if (!(way <= g.R)) fail(b, at + l, "moved more than its radius in one step"); }
    if (orientation) { auto& q = s.turns[at / block]; hk.gather(n, [&](int l) { return turn + l; });
      for (int l = 0; l < padded(n); ++l) {  // becomes vector instructions
        const Turn o = hk.get(l); auto was = q.get(l), is = turned<false>(was, o.h, o.k, side);
        angle2[l] = square(o.h) + square(o.k); const bool small = angle2[l] <= small_angle2;
        q.set(l, {select(small, is.s, was.s), select(small, is.v, was.v)}); }
      for (int l = 0; l < n; ++l) if (angle2[l] > small_angle2)
        q.set(l, turned<true>(q.get(l), turn[l].h, turn[l].k, side)); }}
  b.failed = b.culprit >= 0; }
template <Phase* phase> void base(Simulation& s, Slab& b) { phase(s, b); }
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)  // one is enough to check
#define TINYDEM_FOR(set) template <Phase* phase> __attribute__((target(set))) void
TINYDEM_FOR("avx2") avx2(Simulation& s, Slab& b) { phase(s, b); }
TINYDEM_FOR("avx512f,avx512vl,avx512dq") avx512(Simulation& s, Slab& b) { phase(s, b); }
template <Phase* phase, Phase* narrow = phase> static Phase* best() {
  const bool most = __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return most ? avx512<phase> : __builtin_cpu_supports("avx2") ? avx2<phase> : base<narrow>; }
#else
template <Phase* phase, Phase* narrow = phase> static Phase* best() { return base<narrow>; }
#endif
template <bool... modes> static Phase* best_forces() {
  return best<forces<Modes<modes...>>, forces<Modes<modes...>, false>>(); }
Simulation::Simulation(const Parameters& table, const Mesh& m, const vector<Particle>& initial)
    : p(table), mesh(m), printed(p.scheme == "paper"), friction(printed || p.mus > 0 || p.mur > 0 ||
      p.mut > 0), random(std::uint64_t(p.seed)), material(material_of<real>(p)) {
  spins = friction || square(p.w0) > 0; for (auto& a : initial) spins |= square(a.w) > 0;
  motion_phase = !spins ? best<motion<0, 0>>()
               : p.orientation == "on" ? best<motion<1, 1>>() : best<motion<1, 0>>();
  force_phase = printed ? best_forces<1, 1, 1, 1>() : p.mur > 0 ? best_forces<1, 1, 1>()
                : p.mut > 0 ? best_forces<1, 0, 1>() : p.mus > 0 ? best_forces<1, 0, 0>()
                : best_forces<0, 0, 0>(); groups.resize(p.Rmesh.size()), read_motion(p, groups);
  sort_elements(); for (const Particle& particle : initial) add(particle);
  list_neighbours(); Problems problems; real elastic = 0; each_contact([&](const Contact& c) {
    if (elastic += c.energy; !(c.delta <= c.R))
      problems.add("particle " + to_string(c.i + 1), "overlaps " +
          (c.j < 0 ? "mesh element " + to_string(c.element) : "particle " + to_string(c.j + 1)) +
          " by " + text(c.delta) + ", more than a radius " + text(c.R) + "; move it"); });
  supplied += elastic; if (problems.count == 0 && !std::isfinite(supplied))
    problems.add("particles", "have no finite energy; slow them down");
  problems.stop_if_any(); }
void Simulation::sort_elements() {
  for (const Element& e : mesh.elements) { panes.push_back({}); if (e.n < 4) continue;
    const Vec3 o = mesh.corner(e, 0), u = mesh.corner(e, 1) - o, v = mesh.corner(e, 3) - o;
    panes.back() = {o, 1 / square(u) * u, 1 / square(v) * v, 1 / norm(cross(u, v)) * cross(u, v)}; }
  for (int group = 0; group < count(groups); ++group) {
    Group& g = groups[group]; vector<int> all; vector<Box> boxes; real far = 0;
    for (const Element& e : mesh.elements) if (e.group == group) {
      all.push_back(int(&e - &mesh.elements[0])), boxes.push_back(Box());
      for (int c = 0; c < e.n; ++c)
        boxes.back().add(Box::around(mesh.corner(e, c), p.Rmesh[group])),
        far = max(far, norm(mesh.corner(e, c) - g.P)); }
    g.tree.build(count(all), [&](int k) { return boxes[k]; });
    for (int& k : g.tree.order) { k = all[k]; } g.step = rotation<true>(p.dt / 2 * g.W);
    g.speed = 2 * pi * abs(g.F) * norm(g.A) + norm(g.V) + far * norm(g.W); } move_mesh(); }
void Simulation::move_mesh() { for (Group& g : groups) if (g.moves) {
    const real angle = 2 * pi * g.F * time() + g.phase;
    g.shift = (std::sin(angle) - std::sin(g.phase)) * g.A + time() * g.V;
    g.v = 2 * pi * g.F * std::cos(angle - pi * g.F * p.dt) * g.A + g.V;
    g.q = rotation<true>(time() / 2 * g.W); }}
void Simulation::add(const Particle& a) {
  Grain g{body(Ball<real>{a.x, a.R, a.v, 1 / a.R}, material.unit), {}, 0, {}, 0};
  g.w = a.w, grains.push_back(g); const real m = 1 / g.m_inv;
  id.push_back(count(id)), turns.set(size() - 1, {a.q[0], {a.q[1], a.q[2], a.q[3]}});
  radii += a.R, supplied += m * (square(a.v) / 2 + square(a.R) * square(a.w) / 5 - dot(p.g, a.x)); }
/// Is a sphere free? `near`: what it may touch before it has gone that `way`.
bool Simulation::is_free(const Vec3& x, real R, real way, vector<int>& near) const {
  bool free = true; real far = way; for (const Slab& b : slabs) far = max(far, b.excess);
  const auto check = [&](int j, const Ball<real>& other, real slack) {
    const real d2 = square(x - other.x); free &= d2 >= square(R + other.R);
    if (d2 < square(R + way + other.R + slack)) near.push_back(j); };
  const auto check_grain = [&](int j) { check(j, grains[j], grains[j].room); };
  near.clear(), particle_tree.visit(Box::around(x, R + far), check_grain);
  for (int j = count(particle_tree.order); j < size(); ++j) check_grain(j);  // spawned since then
  for (auto& g : groups) if (free) g.tree.visit(Box::around(g.back(x), R + way + g.slack),
      [&](int k) { check(-1 - g.tree.order[k], wall(g.tree.order[k], x), g.slack); });
  return free; }
/// Draws places in the spawn box; a radius that found no room waits for the next attempt.
void Simulation::spawn() { const Vec3 box = p.smax - p.smin; const real way = slack(norm(p.v0));
  const auto uniform = [&] { return ++draws, real(double(random() >> 11) * 0x1p-53); };  // [0, 1)
  vector<int> near; for (long k = 0; k < p.Nspawn && size() < p.Nmax; ++k) {
    const Vec3 at = p.smin + Vec3{uniform() * box.x, uniform() * box.y, uniform() * box.z};
    if (spawn_radius <= 0) spawn_radius = p.Rmin + (p.Rmax - p.Rmin) * uniform();
    if (!is_free(at, spawn_radius, way, near)) continue;
    add({at, std::exchange(spawn_radius, real(0)), p.v0, {1, 0, 0, 0}, p.w0});
    const int i = size() - 1; grains[i].room = way, slabs.back().last = size();
    for (const int j : near) for (Slab& b : slabs) {  // the list goes on with the new pairs
      const bool home = b.first <= j && j < b.last;
      if (home || &b == &slabs.back()) b.pairs.push_back(home ? Pair{j, i, 0} : Pair{i, j, 0}); }
    stale = stale || size() > count(particle_tree.order) + 100; }}  // is_free asks them one by one
/// Sorts particles; `horizon` balances the cost of a list against that of its idle pairs.
void Simulation::sort_particles() {
  double list = 50. * size(), idle = 0; for (const Slab& b : slabs)  // costs, in idle pairs
    list += 25. * double(b.contacts), idle += double(b.pairs.size()) - double(b.contacts);
  idle *= double(steps - listed_at) * double(1 + 2 * rooms / (rooms + radii));
  const real change = real(std::clamp(sqrt(sqrt(list / max(1., idle))), 0.8, 1.5));
  if (!stale) horizon = std::clamp(change * horizon, real(0.2), real(20));
  rooms = 0; for (Grain& g : grains) g.room = slack(norm(g.v)), rooms += g.room;
  for (Group& g : groups) g.slack = g.moves ? slack(g.speed) : 0;
  const bool sort = particle_tree.order.empty() || rebuilds % 16 == 0;
  particle_tree.build(size(), [&](int i) { return grains[i].box(); }, sort);
  const auto permute = [&](auto& all) { const auto from = all;
    for (int i = 0; i < size(); ++i) all.set(i, from.get(particle_tree.order[i])); };
  if (sort) permute(grains), permute(turns), permute(id); }
/// Gives a pair the springs that it had before the particles were sorted.
void Simulation::recall(Slab& b, int k) const { Pair& a = b.pairs[k];
  const int was_i = particle_tree.order[a.i], was_j = a.j < 0 ? a.j : particle_tree.order[a.j];
  const bool mirrored = 0 <= was_j && was_j < was_i;  // a pair always stands with its lower index
  const int owner = mirrored ? was_j : was_i, partner = mirrored ? was_i : was_j;
  if (owner >= count(last_pair)) return;
  const Slab* s = &old[(long(owner + 1) * count(old) - 1) / count(last_pair)];
  while (s->last <= owner) ++s;  // the last slab grows when particles are spawned
  for (int l = last_pair[owner]; l >= 0; l = s->pairs[l].i) if (s->pairs[l].j == partner) {
    a.touching = a.j < 0 ? s->pairs[l].touching : 1; if (!friction) return;
    Springs<real> u = s->springs.get(l); if (mirrored) u.us = -u.us; b.springs.set(k, u); }}
/// Lists what the particles of a slab may touch before one of them has left its reach.
void Simulation::find_pairs(Slab& b) { vector<int> found;
  struct Other { Vec3 x; real reach; int j; }; vector<Other> near; vector<Pair> f[3];  // see Slab
  for (int i = b.first, last = i; i < b.last; ++i) { const Grain& g = grains[i];
    const auto close = [&](auto& x, real R) { return square(g.x - x) < square(g.reach() + R); };
    if (i == last) { Box box; near.clear(), last = min(i + 8, b.last);  // search together
      for (int k = i; k < last; ++k) box.add(grains[k].box());
      particle_tree.visit(box, [&](int j) {
        if (j > i || j < b.first) near.push_back({grains[j].x, grains[j].reach(), j}); }); }
    int n = 0; found.resize(near.size()); for (const Other& o : near)  // a pair of a slab once
      found[n] = o.j, n += (o.j > i || o.j < b.first) & close(o.x, o.reach);  // without a branch
    for (int k = 0; k < n; ++k) { const Grain& c = grains[found[k]];
      f[square(g.x - c.x) >= square(g.R + c.R)].push_back({i, found[k], 0}); }
    for (const Group& w : groups)
      w.tree.visit(Box::around(w.back(g.x), g.reach() + w.slack), [&](int k) {
        const Body<real> j = wall(w.tree.order[k], g.x);
        if (close(j.x, j.R + w.slack)) f[2].push_back({i, -1 - w.tree.order[k], 0}); }); }
  b.pairs.reserve(f[0].size() + f[1].size() + f[2].size()); b.held = count(f[0]) / block * block;
  for (const auto* a : {f, f + 2, f + 1}) b.pairs.insert(b.pairs.end(), a->begin(), a->end());
  b.springs.reserve(friction ? b.pairs.size() / block + 1 : 0);  // memory that nothing touches yet
  b.springs.resize(friction ? f[0].size() / block + 1 : 0);
  for (int k = 0; k < count(b.pairs); ++k) if (k < count(f[0]) || b.pairs[k].j < 0) recall(b, k); }
/// Builds the neighbour list anew and carries the friction history over.
void Simulation::list_neighbours() {
#pragma omp barrier
#pragma omp single
  { last_pair.assign(size_t(slabs.back().last), -1);  // pairs that may have springs become chains
    for (Slab& b : slabs) for (int k = 0; k < count(b.pairs); ++k)
      if (Pair& a = b.pairs[k]; k < b.held || a.touching) a.i = std::exchange(last_pair[a.i], k);
    sort_particles(), old.swap(slabs);
    const double halvings = std::log2(max(size(), 1) / 125.0) / 3;  // slabs end as boxes do
    slabs.assign(size_t(1) << std::clamp(int(halvings), 0, 6), Slab());
    for (long k = count(slabs) - 1, last = size(); k >= 0; last = slabs[k--].first)
      slabs[k].first = int(size() * k / count(slabs)) / block * block, slabs[k].last = int(last); }
#pragma omp for schedule(static)
  for (int k = 0; k < count(slabs); ++k) find_pairs(slabs[k]);
#pragma omp single
  old.clear(), ++rebuilds, listed_at = steps, stale = false; }
/// One time step, by all threads of a team; false when the run became unstable.
bool Simulation::step() { real excess = -1;
  for (const Slab& b : slabs) if (excess = max(excess, b.excess); b.failed) return false;
  for (const Group& g : groups)
    excess = max(excess, real(steps - listed_at) * p.dt * g.speed - g.slack - real(!g.moves));
  if (stale || excess > 0) list_neighbours();
  const bool spawning = p.Nspawn > 0 && size() < p.Nmax;  // asked before a barrier, so by all alike
#pragma omp for schedule(static)
  for (int k = 0; k < count(slabs); ++k) force_phase(*this, slabs[k]);
#pragma omp for schedule(static)
  for (int k = 0; k < count(slabs); ++k)
    if (motion_phase(*this, slabs[k]), k == 0) ++steps, move_mesh();
  if (spawning) {
#pragma omp single
    spawn(); } return true; }
void Simulation::run(long n) {
#pragma omp parallel num_threads(min(omp_get_max_threads(), count(slabs)))
  for (long k = 0; k < n && step(); ++k) {}
  for (const Slab& b : slabs) if (b.failed)
      throw RunError("particle " + to_string(id[b.culprit] + 1) + " " + b.reason + " at t = " +
                     text(time()) + "; try a smaller --dt (now " + text(p.dt) +
                     "), a larger --E or thicker mesh elements"); }
vector<Particle> Simulation::particles() const { vector<Particle> all(grains.size());
  for (int i = 0; i < size(); ++i) { const Grain& g = grains[i]; const auto [s, v] = turns.get(i);
    all[id[i]] = {g.x, g.R, g.v, {s, v.x, v.y, v.z}, g.w}; } return all; }
template <class F> void Simulation::each_contact(const F& found) const {
  Material<real> mat = material; mat.dt = 0;  // look, do not advance
  for (const Slab& b : slabs) { Walls walls; for (int k = 0; k < count(b.pairs); ++k) {
    const auto [i, j, touching] = b.pairs[k]; if (0 <= j && j < i) continue;  // across slabs: once
    const Body<real> bi = grains[i], bj = j < 0 ? wall(-1 - j, bi.x, bi.v) : Body<real>(grains[j]);
    if (square(bi.x - bj.x) >= square(bi.R + bj.R)) continue;
    int heir = -1; if (j < 0 && !is_nearest(b, k, bj, walls, heir)) continue;
    Springs<real> u{}; if (touching & 1 || k < b.held) heir = k;
    if (friction && heir >= 0) u = b.springs.get(heir);
    const auto c = approach(bi, bj); const auto r = contact_law<Modes<1, 1, 1>>(c, u, mat);
    const real normal = real(0.4) * r.kn * square(c.delta), rolling = r.kn * square(u.ur) / 2;
    const real energy = normal + rolling + r.ks * (square(u.us) + square(u.ut)) / 2;
    found(Contact{id[i], j < 0 ? -1 : id[j], j < 0 ? -1 - j : -1, c.delta, c.R, c.mstar, r.kn,
                  r.fn, r.f - r.fn, u.us, u.ur, u.ut, energy}); }} }
vector<Contact> Simulation::contacts() const { vector<Contact> all;
  return each_contact([&](const Contact& c) { all.push_back(c); }), all; }
Summary Simulation::summary() const { Summary s; for (const Grain& g : grains) {
    const real m = 1 / g.m_inv; s.kinetic += m / 2 * square(g.v), s.potential -= m * dot(p.g, g.x);
    s.rotational += m / 5 * square(g.R) * square(g.w); }
  real shortest = inf;  // An elastic collision lasts 2.943 delta/v, with m* v^2/2 = 2/5 kn delta^2
  each_contact([&](const Contact& c) {  // that is 3.29 sqrt(m*/kn).
    ++s.contacts, s.elastic += c.energy, s.overlap = max(s.overlap, c.delta / c.R);
    shortest = min(shortest, real(3.29) * sqrt(c.mstar / c.kn)), s.steps = shortest / p.dt; });
  return s; }
/// Writes or reads all that a run needs to go on. After both it builds a new list: the same bits.
void Simulation::archive(std::fstream& file, bool loading) {
  std::uint64_t sum = 14695981039346656037u;  // FNV-1a
  const auto bytes = [&](void* at, size_t n) { char* const c = static_cast<char*>(at);
    if (loading) file.read(c, long(n)); else file.write(c, long(n));
    if (loading && !file) throw InputError("restart.bin is not complete; use --overwrite");
    for (size_t k = 0; k < n; ++k) sum = (sum ^ std::uint8_t(c[k])) * 1099511628211u; };
  const auto array = [&](auto& a) {
    size_t n = a.size(); bytes(&n, sizeof n), a.resize(n), bytes(a.data(), n * sizeof a[0]); };
  size_t n = slabs.size(); bytes(&n, sizeof n), slabs.resize(n), array(id), array(grains);
  for (long* a : {&steps, &rebuilds, &listed_at, &draws}) bytes(a, sizeof *a);
  array(turns); for (real* a : {&supplied, &radii, &spawn_radius, &horizon}) bytes(a, sizeof *a);
  for (Slab& b : slabs) bytes(&b.first, 3 * sizeof(int)), array(b.pairs), array(b.springs);
  std::uint64_t stored = sum; const std::uint64_t expected = sum; bytes(&stored, sizeof stored);
  if (stored != expected) throw InputError("restart.bin is damaged; use --overwrite");
  stale = true, particle_tree.order.clear();
  if (loading) move_mesh(), random.discard(std::uint64_t(draws)); }
}  // namespace tinydem
// --------------------------------------------------------------------------------- 4 program
#ifndef TINYDEM_NO_MAIN
#include <unistd.h>
#include <chrono>
#include <iostream>
#ifndef __clang__
#pragma GCC optimize("O0")  // options need no speed: compiles in half the time
#endif
#include <CLI/CLI.hpp>
namespace tinydem { namespace fs = std::filesystem; using namespace std::chrono_literals;
static string magic() { return string("TinyDEM ") + version + " " + to_string(sizeof(real)) + " "; }
/// Writes a file that gets its name when it is complete.
template <class F> static void write(const fs::path& path, const F& fill) {
  const string part = path.string() + ".part";
  std::fstream file(part, std::ios::binary | std::ios::out); std::error_code error;
  if (fill(file), file.close(), file.good()) fs::rename(part, path, error);
  if (!file || error) fs::remove(part, error); else return;
  throw RunError(path.string() + ": cannot be written; free some space, then --resume"); }
/// Writes particles*.csv, contacts*.csv, a line of log.csv and restart.bin.
static Summary write_frame(Simulation& s, long frame, double speed) {
  const fs::path folder(s.p.output); const auto tag = to_string(1000000 + frame).substr(1) + ".csv";
  write(folder / ("particles" + tag), [&](auto& file) { file << csv_header << "\n";
    for (const Particle& a : s.particles())
      file << text(Reals(&a.x.x, &a.w.z + 1), std::numeric_limits<real>::max_digits10) << "\n"; });
  if (s.p.contacts == "on") write(folder / ("contacts" + tag), [&](auto& file) {
    file << "i,j,element,delta,fnx,fny,fnz,fsx,fsy,fsz,usx,usy,usz,urx,ury,urz,ut\n";
    for (const Contact& c : s.contacts())
      file << c.i << "," << c.j << "," << c.element << "," << text(c.delta) << ","
           << text(Reals(&c.fn.x, &c.ut + 1)) << "\n"; });
  const Summary e = s.summary();
  std::ofstream log(folder / "log.csv", frame == 0 ? std::ios::trunc : std::ios::app);
  if (frame == 0) log << "frame,t,N,contacts,kinetic,rotational,potential,elastic,dissipated,"
                         "overlap,steps_per_contact,updates_per_second\n";
  log << text({real(frame), s.time(), real(s.size()), real(e.contacts), e.kinetic, e.rotational,
               e.potential, e.elastic, s.supplied - e.energy(), e.overlap, e.steps, real(speed)});
  if (log << std::endl; !log) throw RunError(folder.string() + "/log.csv: cannot be written");
  write(folder / "restart.bin",
        [&](auto& file) { file << magic() << frame << "\n"; s.archive(file, false); }); return e; }
/// Goes back to the last complete frame; the next frame, or 0 when there is none.
static long resume(Simulation& s) {
  const fs::path folder = s.p.output, restart = folder / "restart.bin";
  std::fstream file(restart, std::ios::binary | std::ios::in);
  std::ifstream log(folder / "log.csv"); string line, first = magic(), p = restart.string();
  if (!fs::exists(restart)) return 0;
  if (std::getline(file, line); line.compare(0, first.size(), first) != 0)
    throw InputError(p + ": does not fit this program; use --overwrite");
  long frame = 0; try { frame = std::stol(line.substr(first.size())), s.archive(file, true); }
  catch (const std::exception&) { throw InputError(p + ": is damaged; use --overwrite"); }
  for (long k = -1; k <= frame; ++k) std::getline(log, line);
  return fs::resize_file(folder / "log.csv", std::uintmax_t(log.tellg())), frame + 1; }
/// Prepares the output directory: refuses to mix runs, keeps copies of what the run is made from.
static void open_folder(Parameters p, bool overwrite) {
  std::error_code error; const fs::path folder = p.output; vector<fs::path> old;
  if (fs::create_directories(folder, error); access((p.output + "/.").c_str(), W_OK | X_OK) != 0)
    throw InputError(p.output + ": cannot be a directory to write in; name another");
  for (const auto& f : fs::directory_iterator(folder))
    for (const char* name : {"scene.ini", "log.csv", "restart.bin", "particles", "contacts"})
      if (f.path().filename().string().rfind(name, 0) == 0) old.push_back(f.path());
  if (!old.empty() && !overwrite)
    throw InputError(p.output + ": holds a run; add --overwrite or --resume, or name another");
  fs::remove(folder / "scene.ini", error);  // from here on there is no run to go on with
  for (auto& [path, name] : {std::pair(&p.mesh, "mesh.off"), {&p.particles, "input.csv"}})
    if (!path->empty()) {
      if (std::ifstream from(*path); !fs::equivalent(*path, folder / name, error))
        write(folder / name, [&](auto& file) { file << from.rdbuf(); });
      *path = name; }
  for (const auto& f : old) { fs::remove(f); } write(folder / "scene.ini", [&](auto& ini) {
    ini << "# TinyDEM " << version << ": tinydem --scene scene.ini repeats the run bit for bit\n";
    for (const Option& o : options(p))
      if (o.at != &p.output && !text(o).empty()) ini << o.name << " = " << text(o) << "\n"; }); }
struct Command { bool overwrite, resume, quiet; string scene{}; vector<Setting> settings{}; };
static Command read_command(int argc, char** argv) { Command c{}; Parameters defaults;
  CLI::App app{"TinyDEM: soft spheres with sliding, rolling and twisting friction"};
  app.set_version_flag("--version", version);
  app.add_option("--scene", c.scene, "scene file: lines name = value with the names below");
  const auto flag = [&](const char* name, bool& on, const char* help) {
    return app.add_flag(name, on, help)->disable_flag_override(); };
  flag("--overwrite", c.overwrite, "replace the run in the output directory")
      ->excludes(flag("--resume", c.resume, "go on with the run in the output directory"));
  flag("--quiet", c.quiet, "no lines on the standard output");
  for (const Option& o : options(defaults)) { const string name = o.name;
    const string value = name == "dt" ? "Eq. 50" : name == "mut" ? "2/3 mus" : text(o);
    const string help = string(o.help) + " [" + o.dimension + "], " + o.range + ", default ";
    const bool path = string(o.range) == "path"; const string dashes = path ? name + ",--" : "--";
    const auto store = [&c, name, path](const string& s) {  // an empty string skips a path
      if (!s.empty() || !path) c.settings.push_back({name, s, "command line"}); };
    if (name == "contacts") app.add_flag_callback("--contacts", [store] { store("on"); }, o.help);
    else app.add_option_function<string>(dashes + name, store, help + value)->type_name(""); }
  app.allow_extras(); try { app.parse(argc, argv); } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) std::exit(app.exit(e));
    throw InputError(string("command line: ") + e.what() + "; see --help"); }
  bool unknown = false;  // what follows an unknown option is its value
  for (const string& a : app.remaining()) {
    const size_t from = min(a.find_first_not_of('-'), a.size()), to = a.find(from < 2 ? '\0' : '=');
    if (!unknown || from > 0) c.settings.push_back({a.substr(from, to - from), "", "command line"});
    unknown = from > 0; } return c; }
static void run(const Command& command) { const auto settings = [&](const string& scene) {
    auto all = scene.empty() ? vector<Setting>() : read_scene(scene);
    all.insert(all.end(), command.settings.begin(), command.settings.end()); return resolve(all); };
  Parameters p = settings(command.scene); const auto folder = p.output, ini = folder + "/scene.ini";
  const bool resuming = command.resume && fs::exists(ini);
  if (resuming) p = settings(ini), p.output = folder;
  Simulation s(p, p.mesh.empty() ? Mesh() : read_mesh(p.mesh, p.Rmesh.size()),
               p.particles.empty() ? vector<Particle>() : read_particles(p.particles));
  if (!resuming) open_folder(p, command.overwrite || command.resume);
  const real times = p.dt / default_step(p), mu = min(p.mus, real(3));  // limit: a fit, case 26
  if (times > real(1.01)) std::cerr << "warning: dt is " << text(times, 3) << " times Eq. (50): "
      << text(13 / times, 2) << " steps per contact, errors of " << text(2 * times, 2)
      << " %, unstable from " << text((24 - 12 * s.material.beta) / (5 + mu), 2) << " times\n";
  const auto now = [] { return double(std::chrono::steady_clock::now().time_since_epoch() / 1ns); };
  const long first = resuming ? resume(s) : 0; const double start = now();
  for (long frame = first; frame <= p.Nframes; ++frame) {
    const double begin = now(); if (frame > 0) s.run(p.Nsteps);
    const Summary e = write_frame(s, frame, 1e9 * double(s.size() * p.Nsteps) / (now() - begin));
    if (!command.quiet) std::cout << "frame " << frame << "/" << p.Nframes << "  t = " << s.time()
                << "  N = " << s.size() << "  contacts = " << e.contacts
                << "  kinetic energy = " << e.kinetic + e.rotational << std::endl;
    const double each = 1e-9 * (now() - start) / double(max(frame - first, 1L));
    if (isatty(2)) std::cerr << "\r" << long(each * double(p.Nframes - frame)) << " s to go   "; }}
}  // namespace tinydem
int main(int argc, char** argv) try { tinydem::run(tinydem::read_command(argc, argv)); }
catch (const std::exception& e) { std::cerr << "error: " << e.what() << std::endl;
  return dynamic_cast<const tinydem::InputError*>(&e) ? 2 : 1; }
#endif
