"""What the teaching scenes measure: fits with error bars, flow profiles, rates, waves, theory.

A scene's measure.py reads a run with frames.py, takes what it needs from here and hands its results
to report(), which prints them and writes result.csv. Arrays are numpy arrays, units are those of
the scene; every error is one standard error. Nothing here knows of files except report(), figure
and run_solver().
"""
import os
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import matplotlib
import numpy as np

from frames import fail

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)

ROOT = Path(__file__).resolve().parents[1]
plt.rcParams.update({
    "font.family": "DejaVu Sans", "font.size": 8.5, "mathtext.fontset": "dejavusans",
    "axes.titlesize": 9, "axes.labelsize": 8.5, "legend.fontsize": 7.5, "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5, "lines.linewidth": 1.4, "lines.markersize": 4.2, "savefig.dpi": 170,
    "axes.linewidth": 0.7, "axes.grid": True, "grid.color": "0.88", "grid.linewidth": 0.5,
    "axes.axisbelow": True, "legend.framealpha": 0.9, "legend.edgecolor": "0.8",
    "legend.fancybox": False, "legend.handlelength": 2.6, "figure.constrained_layout.use": True,
})
COLORS = ["#00429d", "#d1495b", "#3d8f5f", "#8a5fb0", "#e39a1f", "#4fb3d9", "#7a7a7a"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]
LAW = {"color": "0.0", "linewidth": 1.0, "zorder": 1.5}  # a closed form or a published law


# ----------------------------------------------------------------------------------- reporting

class Value(NamedTuple):
    """A measured quantity with its error, and what was expected of it (text, with its source)."""
    quantity: str
    value: float
    error: float
    unit: str
    expected: str


def report(folder, values, more=()):
    """Print Values, one a line, and write them to folder/result.csv.

    more: lines of text to print after them.
    """
    lines = ["quantity,value,error,unit,expected"]
    for v in values:
        unit = f" {v.unit}" if v.unit else ""
        print(f"{v.quantity} = {v.value:.5g} +- {v.error:.2g}{unit} (expected {v.expected})")
        lines.append(f'"{v.quantity}",{v.value:.10g},{v.error:.4g},"{v.unit}","{v.expected}"')
    for line in more:
        print(line)
    (Path(folder) / "result.csv").write_text("\n".join(lines) + "\n")


def figure(rows=1, columns=1, width=3.35, height=2.65):
    """A figure of panels [inches] in the look of all figures; axes as plt.subplots gives them."""
    return plt.subplots(rows, columns, figsize=(columns * width, rows * height))


def points(k, **more):
    """Keywords of plot() for measured points of family k: colour and marker differ."""
    k %= len(COLORS)
    return {"color": COLORS[k], "marker": MARKERS[k], "markerfacecolor": "white",
            "markeredgewidth": 1.0, "linestyle": "none", **more}


def label(ax, x, y, title=None):
    """Name the axes, with units; the title stands at the left."""
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    if title:
        ax.set_title(title, loc="left")


def save(fig, folder):
    """folder/result.png, the same bytes for the same data."""
    fig.savefig(Path(folder) / "result.png", metadata={"Software": None})
    plt.close(fig)


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
