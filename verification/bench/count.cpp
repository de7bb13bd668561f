// Counts the arithmetic of one contact, one pair that is tested and one particle that is moved,
// with a number type that counts. Prints lines `name,value,unit`.
//
// The contact law is the solver's own template. The motion of a particle is no template there; its
// equations stand here a second time and must give the solver's bits, or the program fails.
#include <cstdio>
#include <iostream>

#include "tinydem.cpp"

namespace bench {
using namespace tinydem;

/// Operations; `plain` are additions, subtractions and multiplications.
struct Operations {
  long plain = 0, divisions = 0, roots = 0, comparisons = 0;
};
Operations done;

/// A real number that counts what is done with it.
struct Counted {
  real v = 0;
  Counted() = default;
  template <class A> Counted(A a) : v(real(a)) {}
  Counted operator-() const { return -v; }
  friend Counted operator+(Counted a, Counted b) { return ++done.plain, a.v + b.v; }
  friend Counted operator-(Counted a, Counted b) { return ++done.plain, a.v - b.v; }
  friend Counted operator*(Counted a, Counted b) { return ++done.plain, a.v * b.v; }
  friend Counted operator/(Counted a, Counted b) { return ++done.divisions, a.v / b.v; }
  friend Counted sqrt(Counted a) { return ++done.roots, std::sqrt(a.v); }
  friend Counted abs(Counted a) { return std::abs(a.v); }
  friend bool operator<(Counted a, Counted b) { return ++done.comparisons, a.v < b.v; }
  friend bool operator>(Counted a, Counted b) { return ++done.comparisons, a.v > b.v; }
  friend bool operator==(Counted a, Counted b) { return ++done.comparisons, a.v == b.v; }
};

void print(const string& name, double value, const char* unit) {
  std::printf("%s,%.9g,%s\n", name.c_str(), value, unit);
}
/// Prints what was counted since the last report.
void report(const string& name) {
  print(name + "_plain", double(done.plain), "1");
  print(name + "_divisions", double(done.divisions), "1");
  print(name + "_roots", double(done.roots), "1");
  print(name + "_comparisons", double(done.comparisons), "1");
  done = {};
}
/// Two spheres of 5 mm that overlap by 0.1 mm, and what the solver does for such a pair.
template <class Modes> void count_contact(const string& name) {
  typedef Counted T;
  const Parameters p = resolve();
  const Material<real> m = material_of<real>(p);
  const Material<T> mat{m.Estar, m.Gstar, m.beta, m.cs_cn, m.kn_ks, m.mus, m.mur, m.mut,
                        m.dt, m.unit};
  const Body<T> i{{{T(0.0), T(0.0), T(0.0)}, 0.005, {T(0.1), T(0.0), T(0.2)}, 200.0},
                  {T(1.0), T(2.0), T(3.0)}, 1900.0};
  const Body<T> j{{{T(0.0), T(0.0), T(0.0099)}, 0.005, {T(0.0), T(0.0), T(0.0)}, 200.0},
                  {T(0.0), T(1.0), T(0.0)}, 1900.0};
  Vec<T> fi, fj, ti, tj;
  Springs<T> u{{T(1e-6), T(1e-6), T(0.0)}, {T(1e-6), T(0.0), T(1e-6)}, T(1e-6)};
  const auto seen = [&](const Body<T>& b) {  // without friction 1/m follows from 1/R
    return Modes::any ? b : body(static_cast<const Ball<T>&>(b), mat.unit);
  };
  done = {};
  const Approach<T> c = approach(seen(i), seen(j));
  const Loads<T> r = contact_law<Modes>(c, u, mat);
  if (c.delta - c.R > 0) std::cerr << "overlap\n";
  fi += r.f, ti += r.ti, fj += -r.f, tj += r.tj;
  report(name);
}
void count_test() {
  const Vec<Counted> a, b{Counted(1), Counted(2), Counted(3)};
  const Counted Ri(1), Rj(1);
  done = {};
  if (square(a - b) < square(Ri + Rj)) std::cerr << "touch\n";
  report("pair");
}

// ------------------------------------------------------------------------------ motion once more

template <class T> struct Turn {
  T s;
  Vec<T> v;
};
template <class T> Turn<T> multiply(const Turn<T>& p, const Turn<T>& q, T side) {  // Eq. (49)
  return {p.s * q.s - dot(p.v, q.v), p.s * q.v + q.s * p.v + side * cross(p.v, q.v)};
}
template <class T> Turn<T> small_rotation(const Vec<T>& h) {
  const T h2 = square(h);
  const auto over = [](int n) { return T(1 / real(n)); };
  return {1 - h2 * (over(2) - h2 * (over(24) - h2 * (over(720) - h2 * over(40320)))),
          (1 - h2 * (over(6) - h2 * (over(120) - h2 * (over(5040) - h2 * over(362880))))) * h};
}
/// Eqs. (42)-(49) without drag, and the checks of the solver.
template <class T> struct Mover {
  Vec<T> x, v, w, f, t;
  T R, m_inv, R_inv;
  Turn<T> q;
  T left;
  void move(T dt, const Vec<T>& g) {
    const T R2_inv = R_inv * R_inv, I_inv = T(2.5) * m_inv * R2_inv;
    const Vec<T> a = m_inv * f + g, alpha = I_inv * t, x0 = x;
    const Vec<T> h = dt / 2 * w, k = dt * dt / 4 * alpha;
    q = multiply(small_rotation(k), multiply(small_rotation(h), q, T(-1)), T(-1));
    v = v + dt * a, x = x + dt * v, w = w + dt * alpha;
    left = norm(x - x0) - (R - R) + (square(h) + square(k)) + square(dt * v) + square(w);
  }
};
/// The same particle by the solver and by Mover<real>; counts a step of Mover<Counted>.
void count_motion() {
  const Parameters p = resolve({{"Nspawn", "0", ""}});
  const Vec3 x{0, 0, 1}, v{real(0.1), real(0.2), real(0.3)}, w{1, 2, 3};
  Simulation s(p, {}, {Particle{x, real(0.005), v, {1, 0, 0, 0}, w}});
  s.run(1);
  const Grain& a = s.grains[0];
  Mover<real> b{x, v, w, {}, {}, a.R, a.m_inv, a.R_inv, {1, {}}, 0};
  b.move(p.dt, p.g);
  const Quaternion q = s.turns.get(0);
  const Vec3 off[] = {a.x - b.x, a.v - b.v, a.w - b.w, q.v - b.q.v};
  for (const Vec3& d : off)
    if (square(d) > 0 || q.s != b.q.s)
      throw RunError("count.cpp: its motion differs from that of the solver; bring it up to date");
  Mover<Counted> c{};
  c.R_inv = c.m_inv = c.R = c.q.s = 1.0;
  done = {};
  c.move(p.dt, {Counted(0), Counted(0), Counted(-9.81)});
  report("motion");
}
}  // namespace bench

int main() {
  using namespace tinydem;
  try {
    bench::count_contact<Modes<0, 0, 0>>("frictionless");
    bench::count_contact<Modes<1, 0, 0>>("sliding");
    bench::count_contact<Modes<1, 1, 1>>("contact");
    bench::count_test(), bench::count_motion();
    bench::print("grain", sizeof(Grain), "bytes");
    bench::print("pair", sizeof(Pair), "bytes");
    bench::print("springs", sizeof(Springs<real>), "bytes");
  } catch (const std::exception& e) {
    std::cerr << "error: " << e.what() << std::endl;
    return 1;
  }
}
