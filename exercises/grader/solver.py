"""Exercises about the solver as a whole: copies with changes, and runs of a copy.

KIND = "solver" in checks.py: the answer is a folder with the two files of the solver. Solutions and
mutants are lists CHANGES = [(old, new), ...]; `old` must stand exactly once in the two files.
"""
import math
from pathlib import Path

from .program import Lost

FILES = ("tinydem.hpp", "tinydem.cpp")
PARTICLE, CONTACT = 14, 13  # numbers that simulate.cpp sends for each


# ------------------------------------------------------------------------ copies with changes

def read(folder, otherwise=None):
    """{name: text} of the two files in `folder`; one that is not there is taken from `otherwise`."""
    folders = {name: folder if (Path(folder) / name).is_file() or not otherwise else otherwise
               for name in FILES}
    return {name: (Path(folders[name]) / name).read_text(errors="replace") for name in FILES}


def changed(texts, changes, where):
    """The texts with every (old, new) replaced; `where`: the file that holds the changes.

    Raises ValueError, which says what to do, if an `old` does not stand exactly once in them.
    """
    texts = dict(texts)
    for old, new in changes:
        found = [name for name in FILES for _ in range(texts[name].count(old))]
        if len(found) != 1:
            raise ValueError(f"{where}: '{old}' stands {len(found)} times in the solver, it must "
                             "stand there once; adapt the change to the solver as it is now")
        texts[found[0]] = texts[found[0]].replace(old, new)
    return texts


def write(texts, folder):
    """Writes the two files; the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (folder / name).write_text(text)
    return folder


# ----------------------------------------------------------------------------- runs of a copy

class Sphere:
    """What to start with, or what came out: x, v, w, q are tuples, R is a number (SI units)."""

    def __init__(self, x, R, v=(0.0, 0.0, 0.0), w=(0.0, 0.0, 0.0), q=(1.0, 0.0, 0.0, 0.0)):
        self.x, self.R, self.v, self.w, self.q = tuple(x), R, tuple(v), tuple(w), tuple(q)

    def numbers(self):
        return (*self.x, self.R, *self.v, *self.w, *self.q)


class Contact:
    """Sphere i and sphere j, or i and a mesh element (the other one is -1); forces on i."""

    def __init__(self, n):
        self.i, self.j, self.element = (int(k) for k in n[:3])
        self.delta, self.fn, self.fs, self.us = n[3], n[4:7], n[7:10], n[10:13]


class Frame:
    """The state at one moment. kinetic, rotational, potential, elastic: energies in J."""

    def __init__(self, numbers):
        """Takes a frame off the front of a list of numbers."""
        self.kinetic, self.rotational, self.potential, self.elastic = numbers[:4]
        n, m = int(numbers[4]), int(numbers[5])
        size = 6 + PARTICLE * n + CONTACT * m
        self.spheres = [Sphere(a[0:3], a[3], a[4:7], a[7:10], a[10:14])
                        for a in pieces(numbers[6:], PARTICLE, n)]
        self.contacts = [Contact(c) for c in pieces(numbers[6 + PARTICLE * n:], CONTACT, m)]
        self.bits = tuple(numbers[:size])
        del numbers[:size]

    def energy(self):
        return self.kinetic + self.rotational + self.potential + self.elastic


def pieces(numbers, size, n):
    return [tuple(numbers[size * k:size * k + size]) for k in range(n)]


class Refused(Lost):
    """The solver did not take the scene; the text is its message."""


def question(scene, spheres, mesh, frames):
    """The numbers that simulate.cpp reads."""
    text = "g = 0,0,0; Nspawn = 0; " + scene
    vertices, elements = mesh
    row = [len(text), *map(ord, text), len(spheres)]
    for s in spheres:
        row += s.numbers()[:10]
    row += [len(vertices), *(c for v in vertices for c in v), len(elements)]
    for corners, group in elements:
        row += [len(corners), *corners, *[0] * (4 - len(corners)), group]
    return tuple(map(float, [*row, len(frames), *frames]))


def simulate(ask, scene, spheres=(), mesh=((), ()), frames=(1,), right=False):
    """Runs a scene with the answer, or with the solver as it was (right); a list of Frame.

    scene: lines "name = value; ..." as in a scene file; nothing falls and nothing is spawned unless
    it says so. mesh: (vertices, [((vertex, ...), group), ...]). frames: steps before each frame.
    Raises Refused if the scene is refused, Lost if the run fails or a number is not finite.
    """
    row = question(scene, spheres, mesh, frames)
    call = ask.right if right else ask.call
    numbers = list(call("simulate", [row], any_value=True)[0])
    status = numbers.pop(0)
    if status:
        said = "".join(chr(int(c) % 128) for c in numbers).replace("\n", "; ")
        kind, verb = (Refused, "refuses") if status == 2 else (Lost, "ends")
        raise kind(f"the solver {verb} the scene '{scene}': {said}")
    if not all(map(math.isfinite, numbers)):
        raise Lost(f"something is not a finite number in the scene '{scene}'")
    return [Frame(numbers) for _ in frames]


def setting(**values):
    """Scene lines from values: numbers, or tuples of numbers; every bit is kept."""
    def text(v):
        return ",".join(map(repr, v)) if isinstance(v, tuple) else v if isinstance(v, str) \
            else repr(v)
    return "; ".join(f"{name} = {text(v)}" for name, v in values.items())
