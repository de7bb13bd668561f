// The contact law of the solver as a function of one contact, and four ways to integrate it.
#include "one_contact.hpp"

#include "tinydem.cpp"

namespace verification {
using namespace tinydem;

const char* name(Method method) {
  const char* const names[] = {"semi-implicit Euler", "explicit Euler", "velocity Verlet", "RK4"};
  return names[int(method)];
}

template <class T> T OneContact<T>::mass(const Sphere<T>& s) const {
  return 4 * T(pi) / 3 * T(p.rho) * s.R * s.R * s.R;
}
template <class T> T OneContact<T>::delta() const {
  return wall ? i.R - i.x.z : i.R + j.R - norm(i.x - j.x);
}

/// The law with `printed` known to the compiler, as in the solver.
template <bool printed, class T>
static Loading<T> load(const OneContact<T>& c, SpringState<T>& u, T dt) {
  const auto body = [&](const Sphere<T>& s) {
    return Body<T>{{s.x, s.R, s.v, 1 / s.R}, s.w, 1 / c.mass(s)};
  };
  const Body<T> bi = body(c.i);
  const Body<T> bj = c.wall ? Body<T>{{{c.i.x.x, c.i.x.y, T()}, T(), {}, T()}, {}, T()} : body(c.j);
  const Approach<T> a = approach(bi, bj);
  Material<T> m = material_of<T>(c.p);
  m.dt = dt;
  Springs<T> springs{u.us, u.ur, u.ut};
  const Loads<T> r = contact_law<Modes<1, 1, 1, printed>>(a, springs, m);
  u = {springs.us, springs.ur, springs.ut};
  return {r.f, r.ti, r.tj, r.fn, r.f - r.fn, a.vs, a.vr, a.vt, r.kn, r.ks};
}
template <class T> Loading<T> OneContact<T>::evaluate(T dt) {
  ++evaluations;
  if (!(delta() > 0)) return u = {}, Loading<T>{};
  return p.scheme == "paper" ? load<true>(*this, u, dt) : load<false>(*this, u, dt);
}
template <class T> Loading<T> OneContact<T>::look() const {
  OneContact<T> copy = *this;
  return copy.evaluate(0);
}
/// Accelerations of the present state, Eqs. (42, 43); advances the springs by dt.
template <class T> void OneContact<T>::accelerate(T dt) {
  const Loading<T> r = evaluate(dt);
  const Vec<T> g{T(p.g.x), T(p.g.y), T(p.g.z)};
  const auto inertia = [&](const Sphere<T>& s) { return T(2) / 5 * mass(s) * s.R * s.R; };
  ai = 1 / mass(i) * r.f + g, bi = 1 / inertia(i) * r.ti;
  if (!wall) aj = 1 / mass(j) * -r.f + g, bj = 1 / inertia(j) * r.tj;
}
template <class T> void OneContact<T>::step(Method method, T dt) {
  if (method == Method::rk4) return runge_kutta(dt);
  if (method == Method::velocity_verlet) return verlet(dt);
  const bool symplectic = method == Method::semi_implicit_euler;
  accelerate(dt);
  if (!symplectic) i.x += dt * i.v, j.x += dt * j.v;
  i.v += dt * ai, j.v += dt * aj, i.w += dt * bi, j.w += dt * bj;
  if (symplectic) i.x += dt * i.v, j.x += dt * j.v;
}
/// The force depends on the velocity, so the new one is predicted first.
template <class T> void OneContact<T>::verlet(T dt) {
  if (!known) accelerate(0), known = true;
  const Vec<T> half_i = i.v + dt / 2 * ai, half_j = j.v + dt / 2 * aj;
  const Vec<T> spin_i = i.w + dt / 2 * bi, spin_j = j.w + dt / 2 * bj;
  i.x += dt * half_i, j.x += dt * half_j;
  i.v += dt * ai, j.v += dt * aj, i.w += dt * bi, j.w += dt * bj;
  accelerate(dt);
  i.v = half_i + dt / 2 * ai, j.v = half_j + dt / 2 * aj;
  i.w = spin_i + dt / 2 * bi, j.w = spin_j + dt / 2 * bj;
}
/// The classical method; springs are part of the state, and slip shortens them in every stage.
template <class T> void OneContact<T>::runge_kutta(T dt) {
  struct Rates {
    Vec<T> vi, vj, ai, aj, bi, bj, us, ur;
    T ut;
  };
  const OneContact<T> start = *this;
  const auto rates = [&]() -> Rates {
    const bool touch = delta() > 0;
    const Loading<T> r = look();
    accelerate(0);
    if (!touch) return {i.v, j.v, ai, aj, bi, bj, {}, {}, T()};
    return {i.v, j.v, ai, aj, bi, bj, r.vs, r.vr, r.vt};
  };
  const auto add = [&](const Rates& k, T h) {
    i.x += h * k.vi, j.x += h * k.vj, i.v += h * k.ai, j.v += h * k.aj;
    i.w += h * k.bi, j.w += h * k.bj;
    u.us += h * k.us, u.ur += h * k.ur, u.ut += h * k.ut;
  };
  const auto stage = [&](const Rates& k, T h) {
    i = start.i, j = start.j, u = start.u;
    add(k, h);
    return rates();
  };
  const Rates k1 = rates(), k2 = stage(k1, dt / 2), k3 = stage(k2, dt / 2), k4 = stage(k3, dt);
  i = start.i, j = start.j, u = start.u;
  add(k1, dt / 6), add(k2, dt / 3), add(k3, dt / 3), add(k4, dt / 6);
  evaluate(0);  // slip, and a new tangent plane
  evaluations = start.evaluations + 4;
}
template <class T> T OneContact<T>::energy() const {
  const Vec<T> g{T(p.g.x), T(p.g.y), T(p.g.z)};
  const auto body = [&](const Sphere<T>& s) {
    return mass(s) * (square(s.v) / 2 + s.R * s.R * square(s.w) / 5 - dot(g, s.x));
  };
  const T d = delta();
  return body(i) + (wall ? T() : body(j)) + (d > 0 ? T(0.4) * look().kn * d * d : T());
}

template struct OneContact<float>;
template struct OneContact<double>;
template struct OneContact<long double>;
}  // namespace verification
