// One contact, alone: two spheres, or a sphere and the plane z = 0, under the solver's contact law.
//
// The law is a template in tinydem.cpp, so it can be integrated here in any precision and by other
// methods than the solver's. one_contact.cpp is the only place that includes tinydem.cpp; it holds
// the whole library too, so a program links either of them:
//
//   g++ -std=c++17 -O2 -I../tinydem case.cpp one_contact.cpp -lgsl -lgslcblas
//
//   OneContact<double> c(p, true);          // p: Parameters; true: with a wall
//   c.i = {{0, 0, R}, {0, 0, -v}, {}, R};   // centre, velocity, spin, radius
//   while (c.i.v.z < 0 || c.delta() > 0) c.step(Method::rk4, c.p.dt);
#pragma once
#include "tinydem.hpp"

namespace verification {
using tinydem::Parameters;
template <class T> using Vec = tinydem::Vec<T>;

/// Centre [L], velocity [L/T], angular velocity [1/T], radius [L]; the mass follows from p.rho.
template <class T> struct Sphere {
  Vec<T> x{}, v{}, w{};
  T R = 0;
};
/// Displacements of the sliding, rolling and twisting spring [L].
template <class T> struct SpringState {
  Vec<T> us{}, ur{};
  T ut = 0;
};
/// What the law says about the present state: force on i, torques on i and j, the normal and the
/// sliding force, and the velocities of the three springs.
template <class T> struct Loading {
  Vec<T> f{}, ti{}, tj{}, fn{}, fs{}, vs{}, vr{};
  T vt = 0, kn = 0, ks = 0;
};
enum class Method { semi_implicit_euler, explicit_euler, velocity_verlet, rk4 };
const char* name(Method method);

/// T is float, double or long double. p.scheme and p.g count; p.dt does not, a step is an argument.
template <class T> struct OneContact {
  OneContact(const Parameters& parameters, bool with_wall) : p(parameters), wall(with_wall) {}
  Parameters p;
  bool wall;             ///< j is the plane z = 0, at rest
  Sphere<T> i{}, j{};    ///< j is ignored with a wall
  SpringState<T> u{};    ///< cleared while the bodies do not touch
  long evaluations = 0;  ///< of the contact law, apart or not

  T delta() const;  ///< overlap, negative when apart
  T mass(const Sphere<T>& s) const;
  Loading<T> look() const;  ///< the loads of the present state; springs stay as they are
  /// The same, with the springs advanced by v dt as the scheme demands.
  Loading<T> evaluate(T dt);
  void step(Method method, T dt);
  T energy() const;  ///< kinetic, rotational, Hertz and gravity; without friction springs

 private:
  Vec<T> ai{}, aj{}, bi{}, bj{};  // velocity Verlet: accelerations of the last step
  bool known = false;
  void accelerate(T dt);
  void verlet(T dt);
  void runge_kutta(T dt);
};
}  // namespace verification
