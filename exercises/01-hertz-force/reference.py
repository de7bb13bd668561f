"""The right results of exercise 01, in plain formulas."""
import math


def hertz_force(xi, yi, zi, Ri, Ei, nui, xj, yj, zj, Rj, Ej, nuj):
    """F = 4/3 E* sqrt(R*) delta^(3/2), from j to i: Eqs. (5), (7)-(10), (12), (14), (15), (17)."""
    d = (xi - xj, yi - yj, zi - zj)
    distance = math.sqrt(d[0] ** 2 + d[1] ** 2 + d[2] ** 2)
    delta = Ri + Rj - distance
    if delta <= 0:
        return 0.0, 0.0, 0.0
    modulus = 1 / ((1 - nui ** 2) / Ei + (1 - nuj ** 2) / Ej)
    force = 4 / 3 * modulus * math.sqrt(Ri * Rj / (Ri + Rj)) * delta ** 1.5
    return tuple(force * c / distance for c in d)


def compression(v, m, R, E, nu):
    """Largest overlap of a sphere that meets its fixed twin at speed v: all of the kinetic energy
    m v^2 / 2 becomes elastic, 8/15 E* sqrt(R*) delta^(5/2) with E* = E/(2(1 - nu^2)), R* = R/2."""
    modulus, radius = E / (2 * (1 - nu ** 2)), R / 2
    return (15 * m * v ** 2 / (16 * modulus * math.sqrt(radius))) ** 0.4
