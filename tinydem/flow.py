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
    """y = a + b x with standard errors; chi2: of the fit per degree of freedom (1 if dy unknown)."""
    a: float
    b: float
    da: float
    db: float
    chi2: float


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
    return Line(a, b, *np.sqrt(np.diag(covariance)), chi2)


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
    k = -line.a / line.b
    dk = abs(k) * np.hypot(line.da / line.a, line.db / line.b)
    return line.b**exponent, k, exponent * line.b**(exponent - 1) * line.db, dk, line.chi2


def beverloo_exponent(D, W, dW, k):
    """Exponent and its error of W = C (D - k)^n with a given k."""
    fit = power_fit(np.asarray(D) - k, W, dW)
    return fit.b, fit.db
