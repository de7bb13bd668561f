"""Read what a run wrote: frames, log, scene and mesh. All other Python tools build on this file.

    run = read_run("output/hourglass")
    for number, frame in run.frames():           # one frame in memory at a time
        height = frame["z"].mean()               # a column by its name in the CSV file
        velocity = columns(frame, "vx,vy,vz")    # array (N, 3)
    run.log["kinetic"], run.scene["mus"], run.time(number), run.mesh_at(run.time(number))

Units are those of the scene. A file that cannot be used ends the program with exit code 2 and a
message that says where, what was found and what to try.
"""
import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

HEADER = "x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"
INTEGERS = {"Nmax", "Nframes", "Nsteps", "Nspawn", "seed"}
LISTS = {"Rmesh"}  # an array even if it has one number
PATHS = {"mesh", "particles", "output"}  # relative to the scene file
TEXTS = {"scheme", "orientation", "contacts", "motion"}


def fail(message):
    """End the program: the input is no good. The message says where, why and what to try."""
    print(f"{Path(sys.argv[0]).name}: error: {message}", file=sys.stderr)
    sys.exit(2)


# ---------------------------------------------------------------------------------- CSV files

def read_table(path, names=None):
    """A CSV file of finite numbers as a structured array (rows,): table["x"] is a column.

    names: the columns to read, as a list; default: all. The same file always gives the same array;
    a missing column, a value that is no finite number or a torn line is an error with its number.
    """
    path = Path(path)
    try:
        lines = path.read_text(errors="replace").splitlines() or [""]
    except OSError as error:
        fail(f"{path}: cannot be read ({error.strerror}); try: the OUTPUT of a run")
    header = lines[0].split(",")
    names = list(names or header)
    if missing := [name for name in names if name not in header]:
        fail(f"{path}:1: expected the columns {','.join(names)}, found '{lines[0][:60]}': "
             f"no {','.join(missing)}; try: run the simulation again")
    try:
        data = np.loadtxt(lines[1:], delimiter=",", comments=None, ndmin=2) if lines[1:] else \
            np.empty((0, len(header)))
    except ValueError:
        data = None
    if data is None or data.shape != (len(lines) - 1, len(header)) or not np.isfinite(data).all():
        _fail_at_bad_line(path, lines, header)
    table = np.empty(len(data), [(name, float) for name in names])
    for name in names:
        table[name] = data[:, header.index(name)]
    return table


def _fail_at_bad_line(path, lines, header):
    """Name the first line of a CSV file that does not hold a finite number for every column."""
    for number, line in enumerate(lines[1:], start=2):
        try:
            values = [float(word) for word in line.split(",")]
            good = len(values) == len(header) and all(map(math.isfinite, values))
        except ValueError:
            good = False
        if not good:
            fail(f"{path}:{number}: expected {len(header)} numbers for {','.join(header)[:60]}, "
                 f"found '{line[:60]}'; try: run the simulation again")
    fail(f"{path}: has empty lines; try: run the simulation again")


def read_frame(path):
    """One frame: structured array (N,) with the columns of HEADER, in order of creation."""
    return read_table(path, HEADER.split(","))


def columns(frame, names):
    """Array (N, k) of the columns that a text like "x,y,z" names."""
    return np.column_stack([frame[name] for name in names.split(",")])


def speed(frame):
    """Speed (N,) [L/T] of the particles of a frame."""
    return np.linalg.norm(columns(frame, "vx,vy,vz"), axis=1)


# -------------------------------------------------------------------------------- scene files

def read_scene(path):
    """A scene file as {name: value}: int, float, array, text or Path (of the file it means).

    The scene.ini that a run wrote has every parameter, dt and mut included; one written by hand
    has those that differ from the defaults. A line `# render: OPTIONS` is returned as "render".
    """
    path, scene = Path(path), {}
    try:
        lines = path.read_text(errors="replace").splitlines()
    except OSError as error:
        fail(f"{path}: cannot be read ({error.strerror}); try: the scene.ini of a run")
    for number, line in enumerate(lines, start=1):
        if line.startswith("# render:"):
            scene["render"] = line.partition(":")[2].strip()
        line = line.partition("#")[0].strip()
        if not line:
            continue
        name, equals, text = (word.strip() for word in line.partition("="))
        try:
            if not (name and equals and text):
                raise ValueError
            scene[name] = path.parent / text if name in PATHS else _value(name, text)
        except ValueError:
            fail(f"{path}:{number}: expected name = value with finite numbers, found '{line[:60]}'"
                 "; try: see tinydem --help")
    return scene


def _value(name, text):
    """The value of a parameter; ValueError if it is not finite."""
    if name in TEXTS:
        return text
    numbers = np.array(text.split(","), float)
    if not np.isfinite(numbers).all() or (name in INTEGERS and numbers[0] != int(numbers[0])):
        raise ValueError
    if len(numbers) > 1 or name in LISTS:
        return numbers
    return int(numbers[0]) if name in INTEGERS else float(numbers[0])


# --------------------------------------------------------------------------------------- mesh

class Element(NamedTuple):
    """A point, an edge, a triangle or a rectangle of a mesh."""
    corners: np.ndarray  # (1..4, 3) [L]
    radius: float  # [L], Rmesh[group]
    group: int


def read_mesh(path, radii=None):
    """An OFF file as a list of Elements; radii: Rmesh [L], default: 0 for every group."""
    path, number = Path(path), 0
    try:
        lines = enumerate(path.read_text(errors="replace").splitlines(), start=1)
        words = [(k, line.partition("#")[0].split()) for k, line in lines]
        words = [(k, w) for k, w in words if w]
        number, first = words[0]
        if first[0] != "OFF":
            raise ValueError("no OFF at the start")
        counts = first[1:] or words.pop(1)[1]
        nv, nf = int(counts[0]), int(counts[1])
        if len(words) != 1 + nv + nf:
            raise ValueError(f"{nv} vertices and {nf} faces announced, {len(words) - 1} lines")
        vertices, elements = np.empty((nv, 3)), []
        for k, (number, values) in enumerate(words[1:1 + nv]):
            vertices[k] = np.array(values, float)
        for number, values in words[1 + nv:]:
            n, *rest = map(int, values)
            group = (rest[n:] or [0])[0]
            if not (1 <= n <= 4 and len(rest) in (n, n + 1) and min(rest) >= 0):
                raise ValueError("a face has 1 to 4 vertices, then perhaps its group")
            corners = vertices[rest[:n]]
            elements.append(Element(corners, 0.0 if radii is None else float(radii[group]), group))
    except OSError as error:
        fail(f"{path}: cannot be read ({error.strerror}); try: the mesh.off of a run")
    except (ValueError, IndexError) as error:
        fail(f"{path}:{number}: this is no mesh for this scene ({error}); try: an OFF file that "
             "tinydem accepts, and its Rmesh")
    return elements


def read_motion(text):
    """The parameter `motion` as a list of (group, kind, numbers); empty text: no motion."""
    moves, lengths = [], {"vibrate": (4, 5), "translate": (3,), "rotate": (6,)}
    for entry in filter(None, (part.strip() for part in (text or "").split(";"))):
        try:
            group, kind, *rest = entry.split()
            numbers = np.array(",".join(rest).split(","), float)
            if len(numbers) not in lengths[kind] or not np.isfinite(numbers).all():
                raise ValueError
            moves.append((int(group), kind, numbers))
        except (ValueError, KeyError):
            fail(f"motion: '{entry}' is no motion; try: 0 vibrate AX,AY,AZ F [PHASE], "
                 "0 translate VX,VY,VZ or 0 rotate PX,PY,PZ WX,WY,WZ")
    return moves


def moved(points, kind, numbers, t):
    """Where points (n, 3) [L] of a mesh group are at time t [T]; at t = 0 where the file says.

    vibrate A f phase: displacement A (sin(2 pi f t + phase) - sin(phase)); translate v: v t;
    rotate P w: about the axis through P with the angular velocity w [1/T].
    """
    if kind == "vibrate":
        phase = numbers[4] if len(numbers) > 4 else 0.0
        return points + numbers[:3] * (np.sin(2 * np.pi * numbers[3] * t + phase) - np.sin(phase))
    if kind == "translate":
        return points + numbers * t
    centre, w = numbers[:3], numbers[3:]
    angle = np.linalg.norm(w) * t
    n = w / max(np.linalg.norm(w), 1e-300)
    r = points - centre
    return centre + np.cos(angle) * r + np.sin(angle) * np.cross(n, r) + \
        (1 - np.cos(angle)) * (r @ n)[:, None] * n


# ---------------------------------------------------------------------------------------- run

@dataclass
class Run:
    """A run in its folder. files {number: path} of the frames, scene as read_scene gives it."""
    folder: Path
    files: dict
    scene: dict
    mesh: list  # of Elements, where they are at t = 0

    @property
    def interval(self):
        """Time between two frames [T]."""
        return self.scene["dt"] * self.scene["Nsteps"]

    @property
    def log(self):
        """log.csv: structured array (frames,), see the README for its columns."""
        return read_table(self.folder / "log.csv")

    def time(self, number):
        """Time of a frame [T]."""
        return number * self.interval

    def frame(self, number=-1):
        """A frame by its number; -1: the last, -2: the one before."""
        numbers = list(self.files)
        if number not in self.files and not -len(numbers) <= number < 0:
            fail(f"{self.folder}: no frame {number}; try: {numbers[0]} to {numbers[-1]}")
        return read_frame(self.files[number if number >= 0 else numbers[number]])

    def frames(self, every=1):
        """Yields (number, frame) in the order of time."""
        for number in list(self.files)[::every]:
            yield number, read_frame(self.files[number])

    def mesh_at(self, t):
        """The mesh at time t [T], a list of Elements."""
        moves = read_motion(self.scene.get("motion"))
        elements = list(self.mesh)
        for group, kind, numbers in moves:
            elements = [e._replace(corners=moved(e.corners, kind, numbers, t))
                        if e.group == group else e for e in elements]
        return elements


def read_run(folder):
    """The run in a folder; its frames are read when they are asked for."""
    folder = Path(folder)
    files = {int(p.stem[9:]): p for p in sorted(folder.glob(f"particles{'[0-9]' * 6}.csv"))}
    if not files:
        fail(f"{folder}: no particles000000.csv, ... there; try: the OUTPUT of a run")
    scene = read_scene(folder / "scene.ini")
    if missing := [name for name in ("dt", "Nsteps", "Rmesh") if name not in scene]:
        fail(f"{folder}/scene.ini: has no {', '.join(missing)}; try: the one that tinydem wrote")
    mesh = read_mesh(scene["mesh"], scene["Rmesh"]) if "mesh" in scene else []
    return Run(folder, files, scene, mesh)
