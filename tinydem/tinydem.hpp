// TinyDEM, teaching edition: the machinery of the solver.
//
//   numbers     packs of W numbers that share one instruction, vectors, rows of memory
//   parameters  Table 2: one line per parameter serves every use
//   files       particles (CSV), meshes (OFF); mistakes are reported with their lines
//   geometry    closest points of mesh elements; a space-filling curve and a tree of boxes along it
//   interface   Simulation: what the program, the tests and the exercises use
//
// The physics is in tinydem.cpp. Units are consistent: [M] mass, [L] length, [T] time.
#pragma once
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF  // no fused multiply-add: the same bits on every instruction set
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-math-errno")
#pragma GCC diagnostic ignored "-Wpsabi"  // packs never cross a real call, see INLINE
#endif
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#ifdef __SSE2__
#include <emmintrin.h>
#endif
#ifndef TINYDEM_REAL
#define TINYDEM_REAL double
#endif
#define INLINE inline __attribute__((always_inline))

namespace tinydem {
typedef TINYDEM_REAL real;  ///< the precision of everything: float, double or long double
using std::abs, std::max, std::min, std::size_t, std::sqrt, std::string, std::to_string;
const real pi = real(3.14159265358979323846264338327950288L);
const real inf = std::numeric_limits<real>::infinity(), tiny = std::numeric_limits<real>::min();
const real unset = std::numeric_limits<real>::quiet_NaN();  ///< stands for "use the formula"
const char* const version = "0.1.0";
template <class V> int count(const V& v) { return int(v.size()); }
/// std::vector with indices of any type of whole number.
template <class T> struct vector : std::vector<T> {
  using std::vector<T>::vector;
  vector(const std::vector<T>& v) : std::vector<T>(v) {}
  template <class I> T& operator[](I i) { return this->data()[i]; }
  template <class I> const T& operator[](I i) const { return this->data()[i]; }
};
typedef vector<real> Reals;

// ---------------------------------------------------------------------------------- numbers

/// W numbers that are computed with one instruction; they read like one: + - * / < > and these.
template <int W> struct Pack { typedef real type __attribute__((vector_size(W * sizeof(real)))); };
template <> struct Pack<1> { typedef real type; };
template <class T> constexpr int width = int(sizeof(T) / sizeof(real));
template <int W> constexpr auto lanes = std::make_index_sequence<size_t(W)>();

template <class M, class T> INLINE T select(const M& c, const T& a, const T& b) {
  return c ? a : b;
}
template <class T> INLINE T smaller(const T& a, const T& b) { return select(b < a, b, a); }
template <class T> INLINE real& lane(T& a, int l) { return reinterpret_cast<real*>(&a)[l]; }
template <int first, class V, size_t... k> INLINE auto part(const V& a, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, a, first + int(k)...);
}
template <class V, size_t... k>
INLINE auto join(const V& a, const V& b, std::index_sequence<k...>) {
  return __builtin_shufflevector(a, b, int(k)...);
}
template <class M> INLINE bool any(const M& mask) {
  if constexpr (std::is_same_v<M, bool>) return mask;
  else if constexpr (constexpr int half = width<M> / 2; half > 1)
    return any(part<0>(mask, lanes<half>) | part<half>(mask, lanes<half>));
  else return (mask[0] | mask[1]) != 0;
}
/// Square roots of a pack, halved until the smallest machine has an instruction for it.
template <class T> INLINE T sqrt(const T& a) {
  constexpr int W = width<T>;
#ifdef __SSE2__
  if constexpr (sizeof a == 16 && W == 2) return T(_mm_sqrt_pd(__m128d(a)));
  if constexpr (sizeof a == 16 && W == 4) return T(_mm_sqrt_ps(__m128(a)));
#endif
  T r{};
  if constexpr (sizeof a > 16)
    r = join(sqrt(part<0>(a, lanes<W / 2>)), sqrt(part<W / 2>(a, lanes<W / 2>)), lanes<W>);
  else for (int l = 0; l < W; ++l) r[l] = std::sqrt(a[l]);
  return r;
}

/// Three components, each a number or a pack.
template <class T> struct Vec {
  T x{}, y{}, z{};
  INLINE Vec operator-() const { return {-x, -y, -z}; }
  INLINE Vec operator+(const Vec& b) const { return {x + b.x, y + b.y, z + b.z}; }
  INLINE Vec operator-(const Vec& b) const { return {x - b.x, y - b.y, z - b.z}; }
  INLINE void operator+=(const Vec& b) { *this = *this + b; }
};
typedef Vec<real> Vec3;
template <class S, class T> INLINE Vec<T> operator*(const S& s, const Vec<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T> INLINE T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> INLINE Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> INLINE T square(const Vec<T>& a) { return dot(a, a); }
template <class T> INLINE T square(const T& a) { return a * a; }
template <class T> INLINE T norm(const Vec<T>& a) { return sqrt(square(a)); }
template <class T> INLINE T norm(const T& a) { return select(a < T(), -a, a); }
template <class M, class T> INLINE Vec<T> select(const M& c, const Vec<T>& a, const Vec<T>& b) {
  return {select(c, a.x, b.x), select(c, a.y, b.y), select(c, a.z, b.z)};
}

/// Memory of a vector and a companion, e.g. (x, y, z | R).
struct alignas(4 * sizeof(real)) Row {
  real c[4];
  INLINE Row(const Vec3& a = {}, real s = 0) : c{a.x, a.y, a.z, s} {}
  INLINE Vec3 xyz() const { return {c[0], c[1], c[2]}; }
  INLINE void operator+=(const Row& b) { for (int k = 0; k < 4; ++k) c[k] += b.c[k]; }
  INLINE void operator-=(const Row& b) { for (int k = 0; k < 4; ++k) c[k] -= b.c[k]; }
};
typedef vector<Row> Rows;
/// Rows side by side: lane l of c[k] is component k of row l.
template <class T> struct Columns {
  T c[4];
  INLINE Vec<T> xyz() const { return {c[0], c[1], c[2]}; }
};
/// In every group of four lanes: which of p (0 ... 3) and q (4 ... 7) to pick.
template <int... pick, class V, size_t... k>
INLINE V mix(const V& p, const V& q, std::index_sequence<k...>) {
  constexpr int from[] = {pick...}, other = int(sizeof...(k)) - 4;
  return __builtin_shufflevector(p, q,
                                 int(k / 4 * 4) + from[k % 4] + (from[k % 4] > 3 ? other : 0)...);
}
/// Transposes every group of four lanes of four packs: rows to columns and back.
template <class T> INLINE void transpose(Columns<T>& m) {
  constexpr auto all = lanes<width<T>>;
  const T a = mix<0, 4, 2, 6>(m.c[0], m.c[1], all), b = mix<1, 5, 3, 7>(m.c[0], m.c[1], all);
  const T c = mix<0, 4, 2, 6>(m.c[2], m.c[3], all), d = mix<1, 5, 3, 7>(m.c[2], m.c[3], all);
  m = {{mix<0, 1, 4, 5>(a, c, all), mix<0, 1, 4, 5>(b, d, all), mix<2, 3, 6, 7>(a, c, all),
        mix<2, 3, 6, 7>(b, d, all)}};
}
/// Rows index[0], index[4], ... behind each other in one pack of W.
template <int W> INLINE auto concatenate(const Row* rows, const int* index) {
  typename Pack<W>::type r;
  if constexpr (W == 4) std::memcpy(&r, rows + *index, sizeof r);
  else r = join(concatenate<W / 2>(rows, index), concatenate<W / 2>(rows, index + W / 2), lanes<W>);
  return r;
}
template <class T> INLINE Columns<T> gather(const Row* rows, const int* index) {
  constexpr int W = width<T>;
  Columns<T> m;
  if constexpr (W < 4)
    for (int k = 0; k < 4 * W; ++k) lane(m.c[k / W], k % W) = rows[index[k % W]].c[k / W];
  else for (int k = 0; k < 4; ++k) m.c[k] = concatenate<W>(rows, index + k);
  if constexpr (W >= 4) transpose(m);
  return m;
}
/// Writes the first n lanes of (a|d) to rows.
template <class T> INLINE void scatter(const Vec<T>& a, const T& d, Row* rows, int n = width<T>) {
  Columns<T> m{{a.x, a.y, a.z, d}};
  if constexpr (width<T> >= 4) transpose(m);
  for (int l = 0; l < n; ++l)
    if constexpr (width<T> >= 4) std::memcpy(rows[l].c, &lane(m.c[l % 4], l / 4 * 4), sizeof(Row));
    else for (int k = 0; k < 4; ++k) rows[l].c[k] = lane(m.c[k], l);
}

// ------------------------------------------------------------------------------- parameters

/// Table 2 and the options of a run, a line each: name, type, default, dimension, range, text.
/// The line serves scene files, the command line, --help, range checks and the written scene.ini.
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
  X(particles, string, "", "-", "path", "particles to start with (CSV)")                           \
  X(output, string, "output", "-", "path", "output directory")

struct Parameters {
#define X(name, type, value, ...) type name = value;
  TINYDEM_PARAMETERS(X)
#undef X
};
/// What a scene file or the command line says about one parameter, and where.
struct Setting { string name, text, where; };

/// Wrong input (exit code 2, nothing written) and a run that cannot go on (1, good frames kept).
struct InputError : std::runtime_error { using std::runtime_error::runtime_error; };
struct RunError : std::runtime_error { using std::runtime_error::runtime_error; };
/// Collects mistakes, so that they are reported together.
struct Problems {
  string all{};
  int count = 0;
  void add(const string& where, const string& what) {
    if (++count <= 20) all += "\n" + where + ": " + what;
  }
  void stop_if_any() const { if (count > 0) throw InputError(all.substr(1)); }
};

// ------------------------------------------------------------------------------------- files

/// The shortest digits that bring a number back bit for bit, or a fixed number of digits.
inline string text(real a, int digits = 0) {
  char b[64];
  const auto general = std::chars_format::general;
  return {b,
          (digits > 0 ? std::to_chars(b, b + 64, a, general, digits) : std::to_chars(b, b + 64, a))
              .ptr};
}
/// Reads a whole token as a finite number.
inline bool parse(const string& token, real& a) {
  const bool plus = token[0] == '+' && token[1] != '-';
  const char *first = token.c_str() + plus, *last = token.c_str() + token.size();
  const auto [end, error] = std::from_chars(first, last, a);
  return error == std::errc() && end == last && std::isfinite(a);
}
/// Splits at every separator and trims; blanks separate as often as they like.
inline vector<string> split(const string& s, char separator) {
  vector<string> tokens;
  for (size_t a = 0, b; a <= s.size(); a = b + 1) {
    size_t first = a,
           last = b =
               min(s.find_first_of(separator == ' ' ? " \t\r" : string(1, separator), a), s.size());
    while (first < last && std::isspace(s[first])) ++first;
    while (first < last && std::isspace(s[last - 1])) --last;
    if (first < last || separator != ' ') tokens.push_back(s.substr(first, last - first));
  }
  return tokens;
}
/// A text file, line by line and value by value; skips comments (#), blank lines, carriage returns
/// and a byte order mark, and notes every value that is missing, malformed or out of range.
struct Reader {
  string path, line{};
  vector<string> tokens{};
  size_t column = 0, number = 0;  // of the next value, of the line
  Problems problems{};
  std::ifstream file;
  explicit Reader(const string& p) : path(p), file(p) {
    if (!file || std::filesystem::is_directory(p))
      throw InputError(p + ": cannot be read; check the path");
  }
  string where() const { return path + ":" + to_string(number); }
  void complain(const string& what) { problems.add(where(), what); }
  bool next(char separator = ' ') {
    for (column = 0; std::getline(file, line);) {
      if (++number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);
      line.erase(min(line.find('#'), line.size()));
      if (line.find_first_not_of(" \t\r") != string::npos)
        return tokens = split(line, separator), true;
    }
    return tokens.clear(), false;
  }
  real value(const string& what, bool whole = false, real low = -inf, real high = inf) {
    const string token = column < tokens.size() ? tokens[column] : "";
    real a = 0;
    if (++column; parse(token, a) && a >= low && a <= high && (!whole || a == std::floor(a)))
      return a;
    const string range =
        whole ? "an integer in [" + text(low) + ", " + text(high) + "]" : "a finite number";
    return complain(what + " = '" + token + "' must be " + range), whole ? low : 0;
  }
  void end_line() {
    if (column < tokens.size()) complain("'" + tokens[column] + "' is one value too many");
  }
};

/// A particle as it stands in a CSV file: position, radius [L], velocity [L/T], quaternion,
/// angular velocity [1/T]; all in the frame of the laboratory.
struct Particle {
  Vec3 x;
  real R = 0;
  Vec3 v;
  std::array<real, 4> q{1, 0, 0, 0};
  Vec3 w;
  std::array<real*, 14> columns() {
    return {&x.x, &x.y, &x.z, &R, &v.x, &v.y, &v.z, &q[0], &q[1], &q[2], &q[3], &w.x, &w.y, &w.z};
  }
};
const char* const csv_header = "x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz";

/// Reads particles; columns are found by name. Throws InputError with every mistake.
inline vector<Particle> read_particles(const string& path) {
  Reader in(path);
  in.next(',');
  const vector<string> names = split(csv_header, ','), header = in.tokens;
  vector<size_t> at;
  for (const string& name : names) {
    at.push_back(size_t(std::find(header.begin(), header.end(), name) - header.begin()));
    if (std::count(header.begin(), header.end(), name) != 1)
      in.complain("column '" + name + "' must stand here once; the header is " + csv_header);
  }
  if (header.size() > names.size())
    in.complain(string("unknown columns; the header is ") + csv_header);
  in.problems.stop_if_any();
  vector<Particle> particles;
  while (in.next(',')) {
    Particle a;
    for (size_t k = 0; k < at.size(); ++k) in.column = at[k], *a.columns()[k] = in.value(names[k]);
    in.column = at.size(), in.end_line();
    if (!(a.R > 0)) in.complain("R = " + text(a.R) + " must be > 0");
    const real q = sqrt(square(a.q[0]) + square(a.q[1]) + square(a.q[2]) + square(a.q[3]));
    if (!(abs(q - 1) < real(1e-3)))
      in.complain("q0 ... q3 has norm " + text(q) + ", must be 1; try 1,0,0,0");
    particles.push_back(a);
  }
  return in.problems.stop_if_any(), particles;
}

/// A point, an edge, a triangle or a rectangle (n = 1 ... 4 vertices) of radius Rmesh[group].
struct Element { int n, vertex[4], group; };
struct Mesh {
  vector<Vec3> vertices{};
  vector<Element> elements{};
  const Vec3& corner(const Element& e, int k) const { return vertices[e.vertex[k]]; }
};
/// Reads an OFF file; throws InputError with every mistake. radii: the length of Rmesh.
inline Mesh read_mesh(const string& path, size_t radii) {
  Reader in(path);
  Mesh mesh;
  if (!in.next() || in.tokens[0] != "OFF")
    in.complain("must start with OFF; convert other formats");
  if (in.tokens.size() > 1) in.column = 1; else in.next();
  const auto total = [&](const char* what) { return size_t(in.value(what, true, 0, 2e9)); };
  const size_t nv = total("number of vertices"), nf = total("number of faces");
  total("number of edges");
  in.end_line();
  while (mesh.vertices.size() < nv && in.next())
    mesh.vertices.push_back({in.value("x"), in.value("y"), in.value("z")}), in.end_line();
  while (mesh.vertices.size() == nv && mesh.elements.size() < nf && in.next()) {
    const int mistakes = in.problems.count;
    const auto good = [&] { return in.problems.count == mistakes; };
    Element e{int(in.value("vertices of a face", true, 1, 4)), {}, 0};
    for (int k = 0; k < e.n && good(); ++k)
      e.vertex[k] = int(in.value("vertex index", true, 0, real(nv) - 1));
    if (good() && in.column < in.tokens.size())
      e.group = int(in.value("index into Rmesh (--Rmesh adds radii)", true, 0, real(radii) - 1)),
      in.end_line();
    mesh.elements.push_back(e);
    if (e.n < 4 || !good()) continue;
    const Vec3 a = mesh.corner(e, 0), ab = mesh.corner(e, 1) - a, ad = mesh.corner(e, 3) - a;
    const real size = norm(ab) + norm(ad), off = norm(mesh.corner(e, 2) - a - ab - ad);
    if (abs(dot(ab, ad)) > real(1e-6) * size * size || off > real(1e-6) * size)
      in.complain("four vertices must be the corners of a rectangle, in order; or split the face");
  }
  if (in.problems.count == 0 && mesh.elements.size() < nf)
    in.complain("the file ends after " + to_string(mesh.vertices.size()) + " of " + to_string(nv) +
                " vertices, " + to_string(mesh.elements.size()) + " of " + to_string(nf) +
                " faces");
  if (in.problems.count == 0 && in.next()) in.complain("more lines than the counts declare");
  return in.problems.stop_if_any(), mesh;
}

// ---------------------------------------------------------------------------------- geometry

/// The point of an edge from a to b that is closest to p; also for an edge of length zero. The
/// cross products keep bodies in their plane bit for bit: components along an axis-parallel edge
/// are p's.
inline Vec3 closest_on_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a;
  const real e2 = square(e), along = dot(p - a, e);
  return along <= 0 ? a : along >= e2 ? b : p - 1 / e2 * cross(e, cross(p - a, e));
}
/// The same for a triangle. One that is flatter than the root of the rounding error counts as its
/// edges: beyond that its normal means less than they do.
inline Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = cross(b - a, c - a);
  const auto inside = [&](const Vec3& from, const Vec3& to) {
    return dot(cross(to - from, p - from), normal) >= 0;
  };
  const real flat = std::numeric_limits<real>::epsilon() * square(b - a) * square(c - a);
  if (square(normal) > flat && inside(a, b) && inside(b, c) && inside(c, a))
    return p - dot(p - a, normal) / square(normal) * normal;
  Vec3 best = closest_on_edge(p, a, b);
  for (const Vec3& q : {closest_on_edge(p, b, c), closest_on_edge(p, c, a)})
    if (square(p - q) < square(p - best)) best = q;
  return best;
}
/// The same for any mesh element; the two sides of a rectangle are independent.
inline Vec3 closest_point(const Mesh& m, const Element& e, const Vec3& p) {
  const Vec3& a = m.corner(e, 0);
  if (e.n == 1) return a;
  if (e.n == 3) return closest_on_triangle(p, a, m.corner(e, 1), m.corner(e, 2));
  const Vec3 q = closest_on_edge(p, a, m.corner(e, 1));
  return e.n == 2 ? q : closest_on_edge(p, q, q + (m.corner(e, 3) - a));
}

/// Place of a point on a space-filling curve through cells of edge h: 20 interleaved bits for each
/// direction. What is near on the curve is near in space; far away, the curve repeats itself.
inline std::uint64_t place_on_curve(const Vec3& x, real h) {
  const auto spread = [h](real a) {  // two free bits behind each bit
    auto i = std::uint64_t(std::int64_t(std::floor(std::clamp(a / h, real(-1e18), real(1e18))))) &
             0xfffff;
    i = (i | i << 32) & 0x1f00000000ffff, i = (i | i << 16) & 0x1f0000ff0000ff;
    i = (i | i << 8) & 0x100f00f00f00f00f, i = (i | i << 4) & 0x10c30c30c30c30c3;
    return (i | i << 2) & 0x1249249249249249;
  };
  return spread(x.x) | spread(x.y) << 1 | spread(x.z) << 2;
}
struct Box {
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  void add(const Vec3& a, const Vec3& b, real R) {
    low = {min(low.x, a.x - R), min(low.y, a.y - R), min(low.z, a.z - R)};
    high = {max(high.x, b.x + R), max(high.y, b.y + R), max(high.z, b.z + R)};
  }
  bool within(const Vec3& p, real reach) const {
    const auto gap = [](real a, real from, real to) { return max(max(from - a, a - to), real(0)); };
    const Vec3 d{gap(p.x, low.x, high.x), gap(p.y, low.y, high.y), gap(p.z, low.z, high.z)};
    return square(d) <= reach * reach;
  }
};
/// Boxes around boxes around things in their order on the curve: a query costs log(things), however
/// different their sizes are, and the memory follows their number, not the volume they span.
struct Tree {
  static constexpr int leaf = 4;  // things in a box of the lowest level
  int n = 0, first = 1;  // things; boxes[first ...] are the lowest, box k holds 2k and 2k + 1
  vector<Box> boxes{};
  /// add(k, box) must enlarge box by thing k.
  template <class F> void build(int things, F add) {
    for (n = things, first = 1; first * leaf < n;) first *= 2;
    boxes.assign(2 * size_t(first), Box());
    for (int k = 0; k < n; ++k) add(k, boxes[first + k / leaf]);
    for (int k = first; k-- > 1;)
      for (const Box& half : {boxes[2 * k], boxes[2 * k + 1]}) boxes[k].add(half.low, half.high, 0);
  }
  /// Calls found(k) for every thing k >= from whose lowest box comes within reach of p; `box` has
  /// `below` lowest boxes below it (0: all).
  template <class F>
  void visit(const Vec3& p, real reach, int from, F& found, int box = 1, int below = 0) const {
    if (below == 0) below = first;
    const int begin = (box * below - first) * leaf, end = min(begin + below * leaf, n);
    if (end <= max(begin, from) || !boxes[box].within(p, reach)) return;
    if (below == 1) for (int k = max(begin, from); k < end; ++k) found(k);
    else
      for (const int half : {2 * box, 2 * box + 1}) visit(p, reach, from, found, half, below / 2);
  }
};

// --------------------------------------------------------------------------------- interface

/// What a scene file says; throws InputError with every mistake.
vector<Setting> read_scene(const string& path);
/// Defaults, overwritten by the settings in turn, checked, with Eqs. (41) and (50) filled in.
Parameters resolve(const vector<Setting>& settings = {});

/// Constants of the contact law; S is the type of one number.
template <class S> struct Material { S Estar, Gstar, beta, cs_cn, mus, mur, mut, dt; };
/// Particles i and j (or mesh element j) that may touch. spring: place of their history, or never,
/// or below never: the place that it had, for the next time that they touch.
struct Pair {
  int i, j, spring;
  static constexpr int never = -1;
};
/// Consecutive particles that one thread looks after. How many slabs there are follows from N
/// alone and every sum has a fixed order: the same bits for every number of threads.
struct Slab {
  int first = 0, last = 0;
  vector<Pair> pairs{}, walls{};  // by i; a pair that crosses slabs stands in both of them
  Rows springs{};
  long contacts = 0;  // that touched in the last step
  real excess = -1;   // how far a particle is out of the sphere that was listed [L]
  int culprit = -1;   // particle at which the run became unstable
  bool failed = false;
  string reason{};
};
/// A contact of particles i and j, or of i and a mesh element; the other one is -1.
struct Contact {
  int i, j, element;
  real delta, R, mstar, kn;  // overlap, smaller radius [L], effective mass [M], stiffness [M/T^2]
  Vec3 fn, fs, us, ur;       // forces on i [ML/T^2], springs [L]
  real ut, energy;           // twisting spring [L], elastic energy [ML^2/T^2]
};
struct Summary {
  long contacts = 0;
  real kinetic = 0, rotational = 0, potential = 0, elastic = 0;  // [ML^2/T^2]
  real overlap = 0,
       steps = 0;  // largest delta/R; time steps in the shortest collision, see summary()
};

/// The solver. Mesh and initial particles may be empty. Throws InputError for particles that
/// coincide or overlap by more than a radius.
struct Simulation {
  explicit Simulation(const Parameters&, const Mesh& = {}, const vector<Particle>& initial = {});
  void run(long count);                ///< time steps; RunError when the run is unstable
  vector<Particle> particles() const;  ///< in the order of creation
  vector<Contact> contacts() const;    ///< with indices in the order of creation
  Summary summary() const;
  void save(std::ostream& file);       ///< the state of a run, to resume it bit for bit
  void load(std::istream& file);
  int size() const { return int(x.size()); }
  real time() const { return real(steps) * p.dt; }

  Parameters p;
  Mesh mesh;
  Rows x{}, v{}, w{}, q{};  // (x|R) (v|1/m) (w|1/R) (quaternion), sorted along a curve
  Rows f{}, t{}, x0{};      // (force) (torque) (x|reach when the list was built)
  vector<int> id{};                // place in the order of creation
  vector<Slab> slabs{1};
  long steps = 0, rebuilds = 0, listed_at = 0, draws = 0;  // draws: random numbers used
  real supplied = 0, radii = 0;  // energy that came in with the particles [ML^2/T^2], sum of R [L]

  bool step();  // all threads of a team call these together
  void list_neighbours();
  void find_pairs(Slab& b);  // one thread calls these
  void choose_reach();
  void sort_particles();
  void sort_elements();
  void spawn();
  void add(const Particle& particle);
  bool is_free(const Vec3& centre, real R) const;
  real uniform();
  void enlist(Slab& b, vector<Pair>& list, int i, int j) const;
  template <class F> void archive(F bytes);

  bool printed, stale = true;                     // --scheme paper; the list must be built
  std::mt19937_64 random;
  real spawn_radius = 0, horizon = 1;             // drawn but not yet placed [L]; see choose_reach
  int spring_rows;                                // per contact: (us|ut) (ur|-)
  Material<real> pair_material{}, wall_material{};
  Tree particle_tree{}, mesh_tree{};
  vector<int> elements{};                         // of the mesh, along the curve
  vector<std::pair<std::uint64_t, int>> order{};  // place on the curve, index before sorting
  vector<Slab> old{};                             // slabs before sorting
  vector<int> first_pair{}, first_wall{};         // of each particle in them
  void (*force_phase)(Simulation&, Slab&) = nullptr;
  void (*motion_phase)(Simulation&, Slab&) = nullptr;
};

}  // namespace tinydem
