"""The right results of exercise 03, in plain formulas."""
import math


def rates(R, rho, eta):
    """Mass, moment of inertia, and the drag rates c and gamma from Stokes' force and torque."""
    m = 4 / 3 * math.pi * rho * R ** 3
    inertia = 0.4 * m * R ** 2
    return m, inertia, 6 * math.pi * eta * R / m, 8 * math.pi * eta * R ** 3 / inertia


def step(*n):
    """Eqs. (42)-(46). n: x, v, w, f, t (3 numbers each), R, rho, eta, g (3), dt."""
    x, v, w, f, t, (R, rho, eta), g, dt = n[0:3], n[3:6], n[6:9], n[9:12], n[12:15], n[15:18], \
        n[18:21], n[21]
    m, inertia, c, gamma = rates(R, rho, eta)
    new_v = tuple(b + dt * (p / m + a - c * b) for b, p, a in zip(v, f, g))
    new_w = tuple(b + dt * (p / inertia - gamma * b) for b, p in zip(w, t))
    return tuple(a + dt * b for a, b in zip(x, new_v)) + new_v + new_w


def mass(R, rho):
    """Mass of a solid sphere."""
    return rates(R, rho, 0)[0]


def rate(R, rho, eta):
    """c, gamma."""
    return rates(R, rho, eta)[2:]


def fall(R, rho, eta, g, v, T):
    """Depth and speed after a time T of fall along g, from speed v: v' = g - c v, solved."""
    c = rates(R, rho, eta)[2]
    end = g / c
    return end * T + (v - end) * (1 - math.exp(-c * T)) / c, end + (v - end) * math.exp(-c * T)
