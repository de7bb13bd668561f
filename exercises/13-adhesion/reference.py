"""Exercise 13: adhesion, as plain formulas. Radius 0 of j stands for a flat wall."""
import math


def effective(R, other):
    return R if other == 0 else R * other / (R + other)


def stiffness(R, other, E, nu, delta):
    """kn and ks of Eqs. (12)-(16), (22), (23)."""
    a = math.sqrt(effective(R, other) * delta)
    stiff = 2 if other == 0 else 1
    return (4 / 3 * stiff * E / (2 * (1 - nu * nu)) * a,
            8 * stiff * E / (4 * (2 - nu) * (1 + nu)) * a)


def pull_off(R, other, gamma):
    return 4 * math.pi * gamma * effective(R, other)


def force(R, other, E, nu, gamma, delta):
    """The force on i along n, at rest."""
    return stiffness(R, other, E, nu, delta)[0] * delta - pull_off(R, other, gamma)


def friction(R, other, E, nu, mus, en, rho, delta, vn):
    """Size of the friction force in slip: without adhesion in it."""
    mass = [4 / 3 * math.pi * rho * r ** 3 for r in (R, other)]
    mstar = mass[0] * mass[1] / (mass[0] + mass[1])
    kn = stiffness(R, other, E, nu, delta)[0]
    beta = 1 / math.sqrt(1 + (math.pi / math.log(en)) ** 2)
    return mus * abs(kn * delta - beta * math.sqrt(5 * mstar * kn) * vn)


def equilibrium(R, other, E, nu, gamma):
    """The overlap at which a contact without load is at rest."""
    unit = stiffness(R, other, E, nu, 1)[0]
    return (pull_off(R, other, gamma) / unit) ** (2 / 3)
