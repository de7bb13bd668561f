// TinyDEM, teaching edition: the machinery of the solver. The physics is in tinydem.cpp.
// Units are consistent: [M] mass, [L] length, [T] time.
#pragma once
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF  // no fused multiply-add: the same bits on every instruction set
#else                         // the same, and leave to compute what a condition then discards
#pragma GCC optimize("fp-contract=off,no-trapping-math,no-tree-sink,schedule-insns,sched-pressure")
#endif
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <utility>
#include <vector>
#ifndef TINYDEM_REAL
#define TINYDEM_REAL double
#endif
#define INLINE inline __attribute__((always_inline))
extern "C" double sqrt(double) noexcept __attribute__((const));  // sets no errno, so it is one
extern "C" float sqrtf(float) noexcept __attribute__((const));   // instruction for many numbers
namespace tinydem {
typedef TINYDEM_REAL real;  ///< the precision of everything: float, double or long double
using std::abs, std::max, std::min, std::size_t, std::string, std::to_string;
const real pi = real(3.14159265358979323846264338327950288L); const char* const version = "0.1.1";
const real inf = real(HUGE_VAL), unset = real(NAN);  ///< unset stands for "use the formula"
const real same_point = std::cbrt(std::numeric_limits<real>::epsilon());  ///< distance / radius
/// std::vector with indices of any type of whole number.
template <class T> struct vector : std::vector<T> { using std::vector<T>::vector;
  vector(const std::vector<T>& v) : std::vector<T>(v) {}
  template <class I> T& operator[](I i) { return this->data()[i]; }
  template <class I> const T& operator[](I i) const { return this->data()[i]; }
  T get(int i) const { return (*this)[i]; } void set(int i, const T& a) { (*this)[i] = a; } };
template <class V> int count(const V& v) { return int(v.size()); } typedef vector<real> Reals;
// ---------------------------------------------------------------------------------- numbers
template <class T> INLINE T sqrt(T a) {
  return sizeof a == 4 ? T(sqrtf(float(a))) : sizeof a == 8 ? T(::sqrt(double(a))) : std::sqrt(a); }
/// Three components; T is the type of one number.
template <class T> struct Vec { T x{}, y{}, z{};
  INLINE Vec operator-() const { return {-x, -y, -z}; }
  INLINE Vec operator+(const Vec& b) const { return {x + b.x, y + b.y, z + b.z}; }
  INLINE Vec operator-(const Vec& b) const { return {x - b.x, y - b.y, z - b.z}; }
  INLINE void operator+=(const Vec& b) { *this = *this + b; }
  INLINE friend Vec operator*(T s, const Vec& a) { return {s * a.x, s * a.y, s * a.z}; }
  INLINE friend T dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  INLINE friend Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
  INLINE friend T square(const Vec& a) { return dot(a, a); }
  INLINE friend T norm(const Vec& a) { return sqrt(dot(a, a)); } };
typedef Vec<real> Vec3; template <class T> INLINE T norm(T a) { return abs(a); }
template <class T> INLINE T square(T a) { return a * a; }
typedef real Four __attribute__((vector_size(4 * sizeof(real)), may_alias));  // numbers at a time
INLINE Four& four(Vec3& a) { return reinterpret_cast<Four&>(a); }  // a and the number behind it
/// Structs of real numbers side by side: number k of struct l is c[k][l]. A loop over l that holds
/// nothing but arithmetic and `condition ? a : b` becomes vector instructions of `wide` numbers.
constexpr int block = 32, wide = int(64 / sizeof(real)), crowd = 20000;  // too many for the cache
constexpr int padded(int n) { return (n + wide - 1) / wide * wide; }
template <class S> struct alignas(64) Block {
  static constexpr int size = int(sizeof(S) / sizeof(real)); real c[size][block];
  INLINE S get(int l) const { S s; return copy(l, s), s; } INLINE void copy(int l, S& s) const {
#pragma GCC unroll 64
    for (int k = 0; k < size; ++k) reinterpret_cast<real*>(&s)[k] = c[k][l]; }
  INLINE void set(int l, const S& s) {
#pragma GCC unroll 64
    for (int k = 0; k < size; ++k) c[k][l] = reinterpret_cast<const real*>(&s)[k]; }
  /// Collects *at(0) ... *at(n - 1), of 4, 8 ... numbers; at(0) fills up the last instruction.
  /// vectors: four bodies at a time; slow where the processor has no vectors of four numbers.
  template <class F> INLINE void gather(int n, const F& at, [[maybe_unused]] bool vectors = true) {
    for (int l = 0; l < padded(n); l += 4) { const real* r[4]; int k = 0;
      for (int m = 0; m < 4; ++m) r[m] = reinterpret_cast<const real*>(at(l + m < n ? l + m : 0));
#if __has_builtin(__builtin_shufflevector) && !defined(__clang_analyzer__)  // transposed, 4 x 4
#define TINYDEM_MIX(a, b, ...) __builtin_shufflevector(row(a), row(b), __VA_ARGS__)
      const auto row = [&](int m) -> auto& { return *reinterpret_cast<const Four*>(r[m] + k); };
      if (vectors && sizeof(real) <= 8) for (; k < size; k += 4) for (int h = 0; h < 2; ++h) {
        const Four a = h ? TINYDEM_MIX(0, 1, 1, 5, 3, 7) : TINYDEM_MIX(0, 1, 0, 4, 2, 6);
        const Four b = h ? TINYDEM_MIX(2, 3, 1, 5, 3, 7) : TINYDEM_MIX(2, 3, 0, 4, 2, 6);
        reinterpret_cast<Four&>(c[k + h][l]) = __builtin_shufflevector(a, b, 0, 1, 4, 5);
        reinterpret_cast<Four&>(c[k + 2 + h][l]) = __builtin_shufflevector(a, b, 2, 3, 6, 7); }
#endif
#pragma GCC unroll 64
      for (; k < size; ++k) for (int m = 0; m < 4; ++m) c[k][l + m] = r[m][k]; }} };
template <class S> struct Blocks : vector<Block<S>> {  // a long array, which set() extends
  S get(int k) const { return (*this)[k / block].get(k % block); }
  void set(int k, const S& s) { if (k / block >= count(*this)) this->resize(size_t(k) / block + 1);
    (*this)[k / block].set(k % block, s); } };
// ------------------------------------------------------------------------------- parameters
/// Table 2 and the options of a run, a line each for all uses: name, type, default, dimension, ...
#define TINYDEM_PARAMETERS(X)                                                                      \
  X(Rmin, real, 0.002, "L", "(0, inf)", "minimum particle radius")                                 \
  X(Rmax, real, 0.01, "L", "[Rmin, inf)", "maximum particle radius")                               \
  X(Rmesh, Reals, (Reals{0.002, 0.02, 0.01}), "L", "[0, inf)", "mesh radii (a list)")              \
  X(smin, Vec3, (Vec3{-0.1, -0.1, 0.3}), "L", "(-inf, inf)", "lower corner of the spawn box")      \
  X(smax, Vec3, (Vec3{0.1, 0.1, 0.4}), "L", "[smin, inf)", "upper corner of the spawn box")        \
  X(rho, real, 1e3, "M/L^3", "(0, inf)", "mass density")                                           \
  X(E, real, 1e6, "M/LT^2", "(0, inf)", "Young's modulus")                                         \
  X(nu, real, 0.3, "-", "(-1, 0.5]", "Poisson's ratio")                                            \
  X(en, real, 0.5, "-", "[0, 1]", "coefficient of normal restitution")                             \
  X(mus, real, 0.3, "-", "[0, inf)", "Coulomb friction coefficient for sliding")                   \
  X(mur, real, 0.3, "-", "[0, inf)", "Coulomb friction coefficient for rolling")                   \
  X(mut, real, unset, "-", "[0, inf)", "Coulomb friction coefficient for twisting")                \
  X(eta, real, 0, "M/LT", "[0, inf)", "dynamic viscosity for Stokes drag")                         \
  X(v0, Vec3, (Vec3{0, 0, -1}), "L/T", "(-inf, inf)", "initial linear particle velocity")          \
  X(w0, Vec3, (Vec3{0, 0, 0}), "1/T", "(-inf, inf)", "initial angular particle velocity")          \
  X(g, Vec3, (Vec3{0, 0, -9.81}), "L/T^2", "(-inf, inf)", "gravitational acceleration")            \
  X(dt, real, unset, "T", "(0, inf)", "time step")                                                 \
  X(Nmax, long, 1000, "-", "[0, 2e9]", "maximum number of particles")                              \
  X(Nframes, long, 100, "-", "[0, 999999]", "number of output frames")                             \
  X(Nsteps, long, 500, "-", "[0, 1e15]", "number of time steps per frame")                         \
  X(Nspawn, long, 100, "-", "[0, 1e9]", "number of spawn attempts per time step")                  \
  X(seed, long, 1, "-", "[0, 1e15]", "seed of the random numbers")                                 \
  X(scheme, string, "consistent", "-", "consistent|paper", "update of the friction springs")       \
  X(orientation, string, "on", "-", "on|off", "integrate the quaternions")                         \
  X(contacts, string, "off", "-", "on|off", "write the contacts of every frame")                   \
  X(mesh, string, "", "-", "path", "mesh file (OFF)")                                              \
  X(motion, string, "", "-", "GROUP vibrate A F [PHASE]; GROUP translate V; GROUP rotate P W "     \
    "with GROUP an index into Rmesh", "motion of mesh groups, each at most once; A, V, P, W are "  \
    "vectors, PHASE is in radians")                                                                \
  X(particles, string, "", "-", "path", "particles to start with (CSV)")                           \
  X(output, string, "output", "-", "path", "output directory")
#define TINYDEM_MEMBER(name, type, value, ...) type name = value;
struct Parameters { TINYDEM_PARAMETERS(TINYDEM_MEMBER) };
/// What a scene file or the command line says about one parameter, and where.
struct Setting { string name, text, where; };
/// Wrong input (exit code 2, nothing written) and a run that cannot go on (1, good frames kept).
struct InputError : std::runtime_error { using std::runtime_error::runtime_error; };
struct RunError : std::runtime_error { using std::runtime_error::runtime_error; };
/// Collects mistakes, so that they are reported together.
struct Problems { string all{}; int count = 0; void add(const string& at, string what) {
    for (char& c : what) if (c >= 0 && c < ' ') c = '?';
    if (what.size() > 240) what.replace(100, what.size() - 220, " ... ");
    if (++count <= 20) all += "\n" + at + ": " + what; }
  void stop_if_any() const {
    const string more = count > 20 ? "\n" + to_string(count - 20) + " more mistakes" : "";
    if (count > 0) throw InputError(all.substr(1) + more); } };
// ------------------------------------------------------------------------------------- files
/// The shortest digits that bring a number back bit for bit, or a fixed number of digits.
inline string text(real a, int digits = 0) { char b[64], *end = b + sizeof b;
  return {b, (digits > 0 ? std::to_chars(b, end, a, std::chars_format::general, digits)
                         : std::to_chars(b, end, a)).ptr}; }
/// Reads a whole token as a finite number.
inline bool parse(const string& token, real& a) {
  const char *first = token.c_str() + (token[0] == '+'), *last = token.c_str() + token.size();
  const auto [end, error] = std::from_chars(first, last, a);
  return error == std::errc() && end == last && std::isfinite(a) && token.find("+-") != 0; }
/// Splits at every separator and trims; blanks separate as often as they like.
inline vector<string> split(const string& s, char separator) {
  vector<string> tokens; std::istringstream in(s + separator);
  for (string a; std::getline(in, a, separator);) {
    a.erase(0, a.find_first_not_of(" \t\r")), a.erase(a.find_last_not_of(" \t\r") + 1);
    if (!a.empty() || separator != ' ') tokens.push_back(a); } return tokens; }
/// A text file, value by value; skips comments (#), blank lines and a byte order mark.
struct Reader { string path, line{}, hint{}; vector<string> tokens{};
  size_t column = 0, number = 0;  // of the next value, of the line
  Problems problems{}; std::ifstream file;
  explicit Reader(const string& p) : path(p), file(p) { file.peek();
    if (file.bad() || !file.is_open()) throw InputError(p + ": cannot be read; check the path"); }
  string where() const { return path + ":" + to_string(number); }
  void complain(const string& what) { problems.add(where(), what); }
  bool next(char separator = ' ') {
    for (tokens.clear(), column = 0; tokens.empty() && std::getline(file, line);) {
      if (++number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);
      for (char& c : line) if (c == '\t' || c == '\r') c = ' ';
      line.erase(min(line.find('#'), line.size()));
      if (line.find_first_not_of(' ') != string::npos) tokens = split(line, separator); }
    return !tokens.empty(); }
  real value(const string& what, bool whole = false, real low = -inf, real high = inf) {
    const string token = column < tokens.size() ? tokens[column] : ""; real a = 0; ++column;
    if (parse(token, a) && a >= low && a <= high && (!whole || a == std::floor(a))) return a;
    const string range = "an integer in [" + text(low) + ", " + text(high) + "]";
    complain(what + " = '" + token + "' must be " + (whole ? range : "a finite number") + hint);
    return whole ? low : 0; }
  void end_line() {
    if (column < tokens.size()) complain("'" + tokens[column] + "' is one value too many"); } };
/// A line of a CSV file: position, radius [L], velocity [L/T], quaternion, angular velocity [1/T].
struct Particle { Vec3 x; real R = 0; Vec3 v; std::array<real, 4> q{1, 0, 0, 0}; Vec3 w; };
const char* const csv_header = "x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz";
/// Reads particles; columns are found by name. Throws InputError with every mistake.
inline vector<Particle> read_particles(const string& path) { Reader in(path); in.next(',');
  const vector<string> names = split(csv_header, ','), header = in.tokens; vector<size_t> at;
  string wrong; for (const string& name : header)
    if (!std::count(names.begin(), names.end(), name)) wrong = "'" + name + "' is unknown";
  for (const string& name : names) {
    at.push_back(size_t(std::find(header.begin(), header.end(), name) - header.begin()));
    if (std::count(header.begin(), header.end(), name) != 1)
      wrong = "'" + name + "' must stand here once"; }
  if (!wrong.empty())
    in.complain("column " + wrong + "; the header is " + csv_header + ", not '" + in.line + "'");
  in.problems.stop_if_any(); vector<Particle> particles;
  while (in.next(',')) { Particle a; const int before = in.problems.count;
    for (size_t k = 0; k < at.size(); ++k)  // a line that is too short is one mistake
      if (in.column = at[k]; in.column < in.tokens.size() || in.problems.count == before)
        reinterpret_cast<real*>(&a)[k] = in.value(names[k]);
    if (in.column = at.size(), in.end_line(); in.problems.count > before) continue;
    if (!(a.R > 0)) in.complain("R = " + text(a.R) + " must be > 0");
    const real q = sqrt(square(a.q[0]) + square(a.q[1]) + square(a.q[2]) + square(a.q[3]));
    if (!(abs(q - 1) < real(1e-3))) in.complain("q0 ... q3 must have norm 1, not " + text(q));
    particles.push_back(a); } return in.problems.stop_if_any(), particles; }
/// A point, an edge, a triangle or a rectangle (n = 1 ... 4 vertices) of radius Rmesh[group].
struct Element { int n, vertex[4], group; };
struct Mesh { vector<Vec3> vertices{}; vector<Element> elements{};
  const Vec3& corner(const Element& e, int k) const { return vertices[e.vertex[k]]; } };
/// Reads an OFF file; throws InputError with every mistake. radii: the length of Rmesh.
inline Mesh read_mesh(const string& path, size_t radii) { Reader in(path); Mesh m;
  const auto whole = [&](auto what, real a, real b) { return int(in.value(what, true, a, b)); };
  if (!in.next() || in.tokens[0] != "OFF")
    in.complain("must start with OFF, not '" + in.line + "'; convert it");
  if (in.tokens.size() > 1) in.column = 1; else in.next();
  const int nv = whole("number of vertices", 0, 2e9), nf = whole("number of faces", 0, 2e9);
  whole("number of edges", 0, 2e9), in.end_line();
  in.hint = ", one of " + to_string(nv) + " vertices"; while (count(m.vertices) < nv && in.next())
    m.vertices.push_back({in.value("x"), in.value("y"), in.value("z")}), in.end_line();
  in.hint = ""; while (count(m.vertices) == nv && count(m.elements) < nf && in.next()) {
    const int& mistakes = in.problems.count, before = mistakes;
    Element e{whole("vertices of a face", 1, 4), {}, 0};
    for (int k = 0; k < e.n && mistakes == before; ++k)
      e.vertex[k] = whole("vertex index", 0, real(nv - 1));
    if (mistakes == before && in.column < in.tokens.size())
      e.group = whole("index into Rmesh (--Rmesh adds radii)", 0, real(radii) - 1), in.end_line();
    if (m.elements.push_back(e); e.n < 4 || mistakes > before) continue;
    const Vec3 a = m.corner(e, 0), ab = m.corner(e, 1) - a, ad = m.corner(e, 3) - a;
    const real size = norm(ab) + norm(ad), off = norm(m.corner(e, 2) - a - ab - ad);
    if (abs(dot(ab, ad)) > real(1e-6) * size * size || off > real(1e-6) * size)
      in.complain("four vertices must be the corners of a rectangle in order; or split the face"); }
  if (in.problems.count == 0 && (count(m.elements) < nf || in.next()))
    in.complain("must end after " + to_string(nv) + " vertices, " + to_string(nf) + " faces, has " +
                to_string(count(m.vertices)) + ", " + to_string(count(m.elements)));
  return in.problems.stop_if_any(), m; }
// ---------------------------------------------------------------------------------- geometry
/// The point of an edge (also of length zero) that is closest to p. The cross products keep bodies
/// in their plane: components along an axis-parallel edge are p's, bit for bit.
inline Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a; const real e2 = square(e), along = dot(p - a, e);
  return along <= 0 ? a : along >= e2 ? b : p - 1 / e2 * cross(e, cross(p - a, e)); }
/// The same for a triangle; one flatter than the root of the rounding error counts as its edges.
inline Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const auto inside = [&](auto& u, auto& v) { return dot(cross(v - u, p - u), n) >= 0; };
  const real flat = std::numeric_limits<real>::epsilon() * square(b - a) * square(c - a);
  if (square(n) > flat && inside(a, b) && inside(b, c) && inside(c, a))
    return p - dot(p - a, n) / square(n) * n;
  Vec3 best = closest_on_edge(p, a, b);
  for (const Vec3& q : {closest_on_edge(p, b, c), closest_on_edge(p, c, a)}) {
    if (square(p - q) < square(p - best)) best = q; } return best; }
/// The same for any mesh element; the sides of a rectangle are independent.
inline Vec3 closest_point(const Mesh& m, const Element& e, const Vec3& p) {
  const Vec3& a = m.corner(e, 0); if (e.n == 1) return a;
  if (e.n == 3) return closest_on_triangle(p, a, m.corner(e, 1), m.corner(e, 2));
  const Vec3 q = closest_on_edge(p, a, m.corner(e, 1));
  return e.n == 2 ? q : closest_on_edge(p, q, q + m.corner(e, 3) - a); }
struct Pane { Vec3 a{}, u{}, v{}, n{}; };  // a rectangle: corner, sides / square, unit normal
struct Box { Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  static Box around(const Vec3& x, real R) { return {x - Vec3{R, R, R}, x + Vec3{R, R, R}}; }
  void add(const Box& b) { low = {min(low.x, b.low.x), min(low.y, b.low.y), min(low.z, b.low.z)};
    high = {max(high.x, b.high.x), max(high.y, b.high.y), max(high.z, b.high.z)}; }
  bool meets(const Box& b) const {
    return low.x <= b.high.x && low.y <= b.high.y && low.z <= b.high.z &&
           b.low.x <= high.x && b.low.y <= high.y && b.low.z <= high.z; } };
/// Boxes in boxes (k holds 2k and 2k + 1), halved across their longest side until `leaf` things are
/// left: a query costs log(things), whatever their sizes. What is near in `order` is near in space.
struct Tree { static constexpr int leaf = 4; vector<int> order{}; vector<Box> boxes{};
  /// Without sorting, the things keep their order: right as well, and fast enough for small moves.
  template <class F> void build(int things, const F& box_of, bool sort = true) {
    int n = 1; while (n * leaf < things) { n *= 2; } order.resize(size_t(things));
    boxes.assign(2 * size_t(n), Box()); for (int i = 0; i < things; ++i) order[i] = i;
#pragma omp taskgroup
    halve(box_of, sort, 1, 0, things); }
  template <class F> void halve(const F& box_of, bool sort, int k, int first, int last) {
    for (int i = first; i < last; ++i) boxes[k].add(box_of(order[i]));
    const Vec3 d = boxes[k].high - boxes[k].low; if (last - first <= leaf) return;
    const auto side = d.x >= max(d.y, d.z) ? &Vec3::x : d.y >= d.z ? &Vec3::y : &Vec3::z;
    const auto place = [&](int i) { const Box b = box_of(i); return b.low.*side + b.high.*side; };
    const int middle = (first + last) / 2;
    if (sort) std::nth_element(&order[first], &order[middle], &order[0] + last,
                               [&](int i, int j) { return place(i) < place(j); });
#pragma omp task if (last - first > 4000) default(shared) firstprivate(sort, k, first, middle)
    halve(box_of, sort, 2 * k, first, middle);
    halve(box_of, sort, 2 * k + 1, middle, last); }
  /// Calls f(i) for the places i in `order` of all things whose boxes may meet a box.
  template <class F> void visit(const Box& q, const F& f, int a = 0, int b = -1, int k = 1) const {
    if (b = b < 0 ? count(order) : b; a == b || !boxes[k].meets(q)) return;
    if (b - a <= leaf) for (int i = a; i < b; ++i) f(i);
    else visit(q, f, a, (a + b) / 2, 2 * k), visit(q, f, (a + b) / 2, b, 2 * k + 1); } };
// --------------------------------------------------------------------------------- interface
/// What a scene file says; throws InputError with every mistake.
vector<Setting> read_scene(const string& path);
/// Defaults, overwritten by the settings in turn, checked, with Eqs. (41) and (50) filled in.
Parameters resolve(const vector<Setting>& settings = {});
/// Position, radius, velocity, 1/R; Body: also angular velocity, 1/m (walls: 1/m = 1/R = 0).
template <class T> struct Ball { Vec<T> x; T R; Vec<T> v; T R_inv; };  // enough without friction
template <class T> struct Body : Ball<T> { Vec<T> w; T m_inv; };
template <class T> INLINE Body<T> body(const Body<T>& b, T) { return b; }
template <class T> INLINE Body<T> body(const Ball<T>& b, T unit) {
  return {b, {}, unit * b.R_inv * square(b.R_inv)}; }
/// Constants of the contact law; T is the type of one number; unit: 1/m of a sphere of radius 1.
template <class T> struct Material { T Estar, Gstar, beta, cs_cn, kn_ks, mus, mur, mut, dt, unit; };
/// The history of a contact: displacements of the three friction springs [L], Eq. (51).
template <class T> struct Springs { Vec<T> us, ur; T ut; };
struct Quaternion { real s = 1; Vec3 v{}; };
inline Vec3 rotated(const Quaternion& q, const Vec3& a) {
  return a + 2 * cross(q.v, q.s * a + cross(q.v, a)); }
/// A particle of the solver: also force, way that it may go with the list, torque, and a filler.
struct alignas(4 * sizeof(real)) Grain : Body<real> { Vec3 f; real room = 0; Vec3 t; real none = 0;
  INLINE void fetch() const { for (const real* a : {&x.x, &w.x, &t.x}) __builtin_prefetch(a); }
  real reach() const { return R + room; } Box box() const { return Box::around(x, reach()); } };
/// Particle i and what it may touch: particle j >= 0 or mesh element -1 - j.
struct Pair { int i, j; char touching; };  // bit 0: now; bit 1, of a mesh element: a step before
/// The mesh elements of one index into Rmesh and how they move from where they are in the file:
/// displacement A (sin(2 pi F t + phase) - sin phase), velocity V or angular velocity W about the
/// axis through P. They are searched where they were at t = 0: back() brings a place there.
struct Group { Tree tree{}; bool moves = false;
  Vec3 A{}, V{}, P{}, W{}, shift{}, v{};  // now: rotated by q about P, then shifted at velocity v
  real F = 0, phase = 0, speed = 0, slack = 0;  // largest speed; way that the list allows for
  Quaternion q{}, step{};                       // rotation since t = 0, in one time step
  Vec3 back(const Vec3& x) const { return P + rotated({q.s, -q.v}, x - P - shift); }
  Vec3 there(const Vec3& x) const { return P + rotated(q, x - P) + shift; } };
/// Consecutive particles that one thread looks after. How many slabs there are follows from N
/// alone and every sum has a fixed order: the same bits for every number of threads.
struct Slab { int first = 0, last = 0, held = 0;  // so many pairs touched when they were listed
  vector<Pair> pairs{};  // these, with the mesh, apart, spawned; a pair of two slabs is in both
  Blocks<Springs<real>> springs{};  // of pairs, up to the last that touched, if there is friction
  long contacts = 0; real excess = -1;  // in the last step; way out of the sphere of the list [L]
  int culprit = -1; const char* reason = ""; bool failed = false; };  // an unstable particle
struct Walls { int i = -1, first = 0; vector<Vec3> points{}; };  // near i, pairs from first on
/// A contact of particles i and j, or of i and a mesh element; the other one is -1.
struct Contact { int i, j, element;
  real delta, R, mstar, kn;  // overlap, smaller radius [L], effective mass [M], stiffness [M/T^2]
  Vec3 fn, fs, us, ur;       // forces on i [ML/T^2], springs [L]
  real ut, energy; };        // twisting spring [L], elastic energy [ML^2/T^2]
/// Energies [ML^2/T^2], largest delta/R, time steps in the shortest collision.
struct Summary { long contacts = 0;
  real kinetic = 0, rotational = 0, potential = 0, elastic = 0, overlap = 0, steps = 0;
  real energy() const { return kinetic + rotational + potential + elastic; } };
struct Simulation; typedef void Phase(Simulation&, Slab&);  // of a step, for an instruction set
/// The solver. Throws InputError for particles that coincide or overlap by more than a radius.
struct Simulation {
  explicit Simulation(const Parameters&, const Mesh& = {}, const vector<Particle>& initial = {});
  void run(long count);                ///< time steps; RunError when the run is unstable
  vector<Particle> particles() const;  ///< in the order of creation
  vector<Contact> contacts() const;    ///< with indices in the order of creation
  template <class F> void each_contact(const F& found) const; Summary summary() const;
  void archive(std::fstream& file, bool loading);  ///< the state of a run, to resume it bit for bit
  int size() const { return count(grains); } real time() const { return real(steps) * p.dt; }
  Parameters p; Mesh mesh; vector<Pane> panes{};     // of each mesh element
  vector<Grain> grains{}; Blocks<Quaternion> turns{};  // sorted: near in space, near in memory
  vector<int> id{}, last_pair{};  // place in the order of creation; begin of a chain in old
  vector<Slab> slabs{1}, old{};  // old: before sorting
  Tree particle_tree{}; vector<Group> groups{};  // one for each index into Rmesh
  long steps = 0, rebuilds = 0, listed_at = 0, draws = 0;  // random numbers used
  real supplied = 0, radii = 0;  // energy that came in with the particles [ML^2/T^2], sum of R [L]
  real spawn_radius = 0, horizon = 2, rooms = 0;  // not yet placed; see sort_particles [L]
  bool printed, friction, spins, stale = true;  // --scheme paper; the list must be built
  std::mt19937_64 random; Material<real> material; Phase *force_phase, *motion_phase;
  bool step(); void list_neighbours();  // all threads of a team call these, one thread the others
  void sort_elements(), move_mesh(), sort_particles(), find_pairs(Slab& b), spawn();
  bool is_nearest(const Slab& b, int k, const Body<real>& c, Walls& w, int& heir) const;
  bool touch_mesh(Slab& b, int k, const Body<real>& c, Walls& w, bool touch);
  void add(const Particle& a), recall(Slab& b, int k) const;
  real slack(real v) const { return horizon * (radii / real(size() + 1) / 50 + 10 * p.dt * v); }
  bool is_free(const Vec3& x, real R, real way, vector<int>& near) const;
  Body<real> wall(int element, const Vec3& centre, const Vec3& v = {}) const; };
}  // namespace tinydem
