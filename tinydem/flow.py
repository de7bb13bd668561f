"""What the teaching scenes measure: fits with error bars, profiles, rates, waves, kinetic theory.

A scene's measure.py reads a run with frames.py, takes what it needs from here and reports with
result.py. Arrays are numpy arrays, units are those of the scene; an error is one standard error.
Closed forms and published laws stand here too, each with its source.
"""
from typing import NamedTuple

import numpy as np


# ------------------------------------------------------------------------------ rows of spheres

def hertz_chain(x, v, R, scene, times):
    """Positions and velocities (times, n) of elastic spheres in a row, by an ODE solver.

    x (n,), v (n,), R (n,): start, in the order of x; scene: rho, E, nu; times (times,), increasing.
    Independent of the program: F = 4/3 E* sqrt(R*) delta^(3/2) between neighbours, Hertz 1882,
    integrated by DOP853 with a relative error of 1e-10 per step.
    """
    from scipy.integrate import solve_ivp
    x, v, R = (np.asarray(a, float) for a in (x, v, R))
    mass = 4 / 3 * np.pi * scene["rho"] * R**3
    stiffness = 4 / 3 * scene["E"] / (2 * (1 - scene["nu"]**2)) * \
        np.sqrt(R[1:] * R[:-1] / (R[1:] + R[:-1]))

    def rate(_, state):
        place, velocity = np.split(state, 2)
        overlap = np.maximum(R[1:] + R[:-1] - np.diff(place), 0)
        push = np.concatenate([[0], stiffness * overlap**1.5, [0]])
        return np.concatenate([velocity, -np.diff(push) / mass])

    speed, length = np.abs(v).max(), R.min()
    solution = solve_ivp(rate, (0, times[-1]), np.concatenate([x, v]), "DOP853", times, rtol=1e-10,
                         atol=1e-12 * min(speed, length), max_step=length / speed / 50)
    return np.split(solution.y.T, 2, axis=1)


def peaks(t, f):
    """Time and height (n,) of the largest value of each column of f (times, n), at times t.

    A parabola through the logarithms of the three highest samples: exact for a Gaussian, good to
    some 1e-4 of the height for a bell that is wider than four samples at half its height.
    """
    k = np.clip(f.argmax(axis=0), 1, len(t) - 2)
    a, b, c = (np.log(f[k + d, np.arange(f.shape[1])]) for d in (-1, 0, 1))
    shift = (a - c) / (2 * (a - 2 * b + c))
    return t[k] + shift * (t[1] - t[0]), np.exp(b - (a - c) * shift / 4)


def width_at_half(t, f):
    """Full width [T] at half of its largest value of a bell f (times,), by linear interpolation."""
    top = peaks(t, f[:, None])[1][0] / 2
    inside = np.flatnonzero(f > top)
    first, last = inside[0], inside[-1]
    left = np.interp(top, f[first - 1:first + 1], t[first - 1:first + 1])
    return np.interp(-top, -f[last:last + 2], t[last:last + 2]) - left


def nesterenko_speed(v, scene):
    """Speed [L/T] of the solitary wave in a row of equal, just touching elastic spheres.

    v: largest speed of a sphere; long-wave theory, V = (16/25)^(1/5) c^(4/5) v^(1/5) with
    c^2 = 2E / (pi rho (1 - nu^2)): V. F. Nesterenko, J. Appl. Mech. Tech. Phys. 24, 733 (1983).
    """
    c = np.sqrt(2 * scene["E"] / (np.pi * scene["rho"] * (1 - scene["nu"]**2)))
    return (16 / 25)**0.2 * c**0.8 * v**0.2


#: Full width at half height of that wave in diameters: of cos^4(sqrt(10)/5 x), |x| < 5 pi/sqrt(40).
NESTERENKO_WIDTH = 2 * np.arccos(0.5**0.25) * 5 / np.sqrt(10)


# ---------------------------------------------------------------------------------------- fits

class Line(NamedTuple):
    """y = a + b x: standard errors, covariance of a and b, chi^2 per degree of freedom (1 if the
    errors of y were not known)."""
    a: float
    b: float
    da: float
    db: float
    covariance: float
    chi2: float

    def zero(self):
        """Where the line meets y = 0, and its error."""
        x = -self.a / self.b
        variance = self.da**2 + x**2 * self.db**2 + 2 * x * self.covariance
        return x, np.sqrt(max(variance, 0)) / abs(self.b)


def line_fit(x, y, dy=None):
    """Line through points (n >= 3) with errors dy (n,); without dy they follow from the scatter."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    weight = np.ones(len(x)) if dy is None else 1 / np.asarray(dy, float)
    A = weight[:, None] * np.column_stack([np.ones(len(x)), x])
    (a, b), *_ = np.linalg.lstsq(A, weight * y, rcond=None)
    covariance = np.linalg.inv(A.T @ A)
    chi2 = np.sum((weight * (y - a - b * x))**2) / (len(x) - 2)
    if dy is None:
        covariance, chi2 = covariance * chi2, 1.0
    return Line(a, b, *np.sqrt(np.diag(covariance)), covariance[0, 1], chi2)


def power_fit(x, y, dy=None):
    """y = A x^p as a Line in ln x, ln y: a = ln A, b = p; dy: errors of y."""
    return line_fit(np.log(x), np.log(y), None if dy is None else np.asarray(dy) / np.asarray(y))


def block_mean(values, blocks=5):
    """Mean of a series in time and its standard error from the scatter of averages over blocks."""
    parts = [part.mean() for part in np.array_split(np.asarray(values, float), blocks)]
    return np.mean(parts), np.std(parts, ddof=1) / np.sqrt(blocks)


# --------------------------------------------------------------------------------------- silos

def discharge_rate(t, passed, blocks=6):
    """Rate (slope of passed (n,) against t (n,)) and its standard error from the slopes of blocks.

    Neighbouring blocks share a point, so that no grain is lost between them.
    """
    edges = np.linspace(0, len(t) - 1, blocks + 1).round().astype(int)
    rates = np.diff(np.asarray(passed, float)[edges]) / np.diff(np.asarray(t)[edges])
    weight = np.diff(np.asarray(t)[edges])
    mean = np.average(rates, weights=weight)
    return mean, np.sqrt(np.average((rates - mean)**2, weights=weight) / (blocks - 1))


def beverloo_fit(D, W, dW, exponent=1.5):
    """C, k and their errors of W = C (D - k)^exponent, and chi^2 per degree of freedom.

    D (n,): orifices in grain diameters; W, dW (n,): rates and errors. exponent: 5/2 for a hole,
    3/2 for a slot or in two dimensions: W. A. Beverloo et al., Chem. Eng. Sci. 15, 260 (1961).
    W^(1/exponent) is a line in D.
    """
    W, p = np.asarray(W, float), 1 / exponent
    line = line_fit(D, W**p, p * W**(p - 1) * np.asarray(dW))
    k, dk = line.zero()
    return line.b**exponent, k, exponent * line.b**(exponent - 1) * line.db, dk, line.chi2


def beverloo_exponent(D, W, dW, k):
    """Exponent and its error of W = C (D - k)^n with a given k."""
    fit = power_fit(np.asarray(D) - k, W, dW)
    return fit.b, fit.db


# ------------------------------------------------------------------------ deposits and profiles

def height_profile(frame, edges, packing=0.6):
    """Height (bins,) [L] of a round deposit over the distance from the z axis.

    frame: its grains; edges (bins + 1,) [L]. Height: volume of the grains per area of a ring, over
    the share of space that they fill.
    """
    volume = np.histogram(np.hypot(frame["x"], frame["y"]), edges,
                          weights=4 / 3 * np.pi * frame["R"]**3)[0]
    return volume / (np.pi * np.diff(np.square(edges))) / packing


def runout(r, h, low, high):
    """Where a line through the slope of a deposit meets the ground, and its error [L].

    r, h (bins,): heights over distance; the slope is what lies between the heights low and high,
    outside of all that is higher. A front of single grains does not matter.
    """
    last = np.flatnonzero(h > high).max(initial=-1)
    use = (np.arange(len(h)) > last) & (h > low)
    if np.count_nonzero(use) < 3:
        return np.nan, np.nan
    return line_fit(r[use], h[use]).zero()


def lube_runout(a):
    """(r_end - r_0)/r_0 of a column of aspect ratio a: G. Lube et al., J. Fluid Mech. 508, 175
    (2004): 1.24 a for a < 1.7, 1.6 sqrt(a) above; sand, salt, rice, couscous and sugar alike."""
    return np.where(np.asarray(a) < 1.7, 1.24 * np.asarray(a), 1.6 * np.sqrt(a))


def binned(place, value, edges):
    """Mean (bins,) of the values in bins of place, and how many (bins,); nan where there are none.
    """
    number = np.histogram(place, edges)[0]
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.histogram(place, edges, weights=value)[0] / number, number


def bagnold(z, h, slip, rise, exponent=1.5):
    """Speed at height z of a flow of depth h: slip + rise (1 - (1 - z/h)^exponent).

    3/2 where the shear stress is as the square of the rate of shear: R. A. Bagnold, Proc. R. Soc.
    A 225, 49 (1954); L. E. Silbert et al., Phys. Rev. E 64, 051302 (2001).
    """
    return slip + rise * (1 - np.maximum(1 - z / h, 0)**exponent)


def bagnold_fit(z, v, dv, h):
    """Fit of bagnold() with a free exponent: slip, rise, exponent and their errors (3,), (3,)."""
    from scipy.optimize import curve_fit
    best, covariance = curve_fit(lambda *a: bagnold(a[0], h, *a[1:]), z, v,
                                 (v[0], v[-1] - v[0], 1.5), dv, absolute_sigma=True,
                                 bounds=([-np.inf, 0, 0.5], [np.inf, np.inf, 4]))
    return best, np.sqrt(np.diag(covariance))


# ----------------------------------------------------------------------------------------- gases

def haff_time(scene, radius, number, side, energy):
    """Time tau [T] of Haff's law E = E_0/(1 + t/tau)^2 for a gas of smooth spheres in a cube.

    Kinetic theory with Maxwell's distribution, P. K. Haff, J. Fluid Mech. 134, 401 (1983): a
    collision takes (1 - e^2) of the energy of the normal motion. Pairs: Enskog's rate with g of
    Carnahan and Starling, times the share of directions in which a neighbour has room at a wall;
    walls: the pressure n T Z on their area. Valid while the gas is uniform: e_n near 1, some mean
    free paths across. number spheres, cube of inner side [L], energy: at t = 0.
    """
    d, inner = 2 * radius, side - 2 * radius  # centres are in a cube of side `inner`
    mass = 4 / 3 * np.pi * scene["rho"] * radius**3
    T = 2 * energy / (3 * number)  # [ML^2/T^2]
    n, q = number / inner**3, d / inner
    room = 1 - 3 / 2 * q + 2 / np.pi * q**2 - q**3 / (4 * np.pi)
    n /= 1 + 6 / inner * np.pi * d**4 / 4 * n  # away from the walls, which attract to first order
    phi = np.pi / 6 * n * d**3
    g = (1 - phi / 2) / (1 - phi)**3
    loss = 1 - scene["en"]**2
    pairs = 4 / 3 * loss * number / inner**3 * room * d**2 * g * np.sqrt(np.pi * T / mass)
    walls = 2 / 3 * loss / number * n * (1 + 4 * phi * g) * 6 * inner**2 * np.sqrt(
        T / (2 * np.pi * mass))
    return 2 / (pairs + walls), 2 / pairs, 2 / walls


def haff_fit(t, E, blocks=6):
    """tau and its error of E = E[0]/(1 + t/tau)^2, for t[0] = 0, from y = sqrt(E[0]/E) - 1 = t/tau.

    The steps of y are independent: each is the work of other collisions. A block spans equal steps
    of ln(1 + y), so that equally many collisions happen in each and their slopes weigh the same.
    """
    y = np.sqrt(E[0] / np.asarray(E, float)) - 1
    marks = np.linspace(0, np.log1p(y[-1]), blocks + 1)
    at = np.unique(np.abs(np.log1p(y) - marks[:, None]).argmin(axis=1))
    slopes = np.diff(y[at]) / np.diff(np.asarray(t)[at])
    error = slopes.std(ddof=1) / np.sqrt(len(slopes))
    return 1 / slopes.mean(), error / slopes.mean()**2


def haff_exponent(t, E, tau, blocks=5):
    """Exponent p and its error of E = E[0]/(1 + t/tau)^p for a given tau: the mean of the slopes of
    ln E over blocks that span equal steps of ln(1 + t/tau)."""
    x, y = np.log1p(np.asarray(t) / tau), -np.log(np.asarray(E) / E[0])
    at = np.abs(x - np.linspace(0, x[-1], blocks + 1)[:, None]).argmin(axis=1)
    slopes = np.diff(y[at]) / np.diff(x[at])
    return slopes.mean(), slopes.std(ddof=1) / np.sqrt(blocks)


# ------------------------------------------------------------------------------------- billiard

def rolling_share(radius, overlap):
    """Speed of rolling over that of the sliding start of a sphere: r^2/(r^2 + 2/5 R^2).

    The lever arm r = R - overlap/2 [L] ends in the middle of the overlap; 5/7 for a hard table.
    """
    r = radius - overlap / 2
    return r**2 / (r**2 + 0.4 * radius**2)


def hertz_duration(speed, radius, scene):
    """Duration [T] of the elastic collision of two equal spheres at a normal speed: Hertz 1882."""
    mass = 2 / 3 * np.pi * scene["rho"] * radius**3  # effective
    stiffness = 4 / 3 * scene["E"] / (2 * (1 - scene["nu"]**2)) * np.sqrt(radius / 2)
    depth = (5 / 4 * mass * speed**2 / stiffness)**0.4
    return 2.94326 * depth / speed


def sliding_throw(cut, speed, radius, scene):
    """Throw angle [rad] of a cut shot (cut [rad]) without spin while the balls slide on each other.

    atan(mu_s) for hard balls (Coulomb). Soft ones: the line of centres turns in the middle of the
    contact by the tangential way of half its duration over the distance of the centres.
    """
    duration = hertz_duration(speed * np.cos(cut), radius, scene)
    return np.arctan(scene["mus"]) - speed * np.sin(cut) * duration / 2 / (2 * radius)


def sticking_throw(cut, scene):
    """Throw angle [rad] if the contact of hard balls stops sliding: 2/7 of the tangential motion
    goes over; tan = 2/7 tan(cut)/(1 + e_n)."""
    return np.arctan(2 / 7 * np.tan(cut) / (1 + scene["en"]))
