#!/usr/bin/env python3
"""Meshes: STL (ASCII or binary) to OFF and back, and a Builder for the make_mesh.py of a scene.

    mesh_tools.py part.stl part.off --scale 0.001    millimetres to metres, tells what it found
    mesh_tools.py mesh.off mesh.stl                  rectangles become triangles, the rest is lost
    mesh_tools.py part.stl                           only tell

Corners of STL triangles that are the same number for number become one vertex, and triangles
without an area are left out. --merge LENGTH also merges corners that are that close.
"""
import argparse
import codecs
import math
import struct
from pathlib import Path

import numpy as np

from frames import fail, read_mesh

RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
HEAD = 84  # bytes before the first record of a binary STL: 80 of text, 4 of a count
FLAT = 1e-12  # a triangle whose area is less than this share of its longest side squared has none


# ----------------------------------------------------------------------------------- building

class Builder:
    """Vertices and faces of an OFF file; equal corners become one vertex."""

    def __init__(self, title):
        """title: the comment at the top of the file."""
        self.title, self.vertices, self.faces = title, {}, []

    def face(self, *corners, group=0):
        """A point, an edge, a triangle or a rectangle by its corners (x, y, z) [L], in order."""
        rows = [tuple(float(f"{value:.9g}") + 0.0 for value in corner) for corner in corners]
        index = [self.vertices.setdefault(row, len(self.vertices)) for row in rows]
        self.faces.append((index, group))

    def rectangle(self, corner, side, other, group=0):
        """A rectangle by a corner (3,) and two sides (3,) at right angles [L]."""
        a, u, v = (np.array(vector, float) for vector in (corner, side, other))
        self.face(a, a + u, a + u + v, a + v, group=group)

    def cup(self, low, high, group=0):
        """Floor and four walls of a box, open at the top, between two corners (3,) [L]."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        self.rectangle(low, (x1 - x0, 0, 0), (0, y1 - y0, 0), group)
        for corner, side in (((x0, y0, z0), (x1 - x0, 0, 0)), ((x0, y1, z0), (x1 - x0, 0, 0)),
                             ((x0, y0, z0), (0, y1 - y0, 0)), ((x1, y0, z0), (0, y1 - y0, 0))):
            self.rectangle(corner, side, (0, 0, z1 - z0), group)

    def ring(self, centre, axis, radius, count):
        """Corners (count, 3) of a regular polygon around an axis, whose edges touch the circle."""
        axis = np.array(axis, float) / np.linalg.norm(axis)
        u = np.cross(axis, [0, 0, 1] if abs(axis[2]) < 0.9 else [0, 1, 0])
        u /= np.linalg.norm(u)
        angle = 2 * np.pi * (np.arange(count) + 0.5) / count
        r = radius / math.cos(math.pi / count)
        return centre + r * (np.outer(np.cos(angle), u) + np.outer(np.sin(angle),
                                                                  np.cross(axis, u)))

    def tube(self, centre, axis, radius, count, group=0):
        """A prism around `axis` (3,), which is also its length, that holds a circle of `radius`."""
        ring = self.ring(np.array(centre, float), axis, radius, count)
        for a, b in zip(ring, np.roll(ring, -1, axis=0)):
            self.rectangle(a, b - a, axis, group)

    def cone(self, low, radius_low, high, radius_high, count, group=0):
        """The wall between two circles around the z axis through `low` and `high` (3,) [L]."""
        a = self.ring(np.array(low, float), (0, 0, 1), radius_low, count)
        b = self.ring(np.array(high, float), (0, 0, 1), radius_high, count)
        for k in range(count):
            n = (k + 1) % count
            self.face(a[k], a[n], b[n], group=group)
            self.face(a[k], b[n], b[k], group=group)

    def write(self, path):
        """Write the OFF file."""
        lines = ["OFF", f"# {self.title}", f"{len(self.vertices)} {len(self.faces)} 0"]
        lines += [" ".join(f"{value:.9g}" for value in row) for row in self.vertices]
        lines += [" ".join(map(str, [len(index), *index, group])) for index, group in self.faces]
        Path(path).write_text("\n".join(lines) + "\n")


# ---------------------------------------------------------------------------------------- STL

def read_stl(path):
    """Triangles (n, 3, 3) of an STL file; a malformed one ends the program with its line or byte.

    A file is binary if its length is what the count in its bytes 80 to 83 asks for, or if it does
    not start with `solid`.
    """
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        fail(f"{path}: cannot be read ({error.strerror}); try: the name of an STL file")
    data = data.removeprefix(codecs.BOM_UTF8)
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= HEAD else 0
    if len(data) >= HEAD and len(data) == HEAD + RECORD.itemsize * count:
        return _binary(path, data, count)
    if data.lstrip()[:5].lower() == b"solid" and b"\0" not in data:
        return _ascii(path, data.decode(errors="replace"))
    if len(data) < HEAD:
        fail(f"{path}: byte {len(data)}: the file ends within the {HEAD} bytes that a binary STL "
             "starts with; try: export it again")
    whole = (len(data) - HEAD) // RECORD.itemsize
    fail(f"{path}: byte {HEAD + RECORD.itemsize * min(whole, count)}: {count} triangles announced "
         f"at byte 80 need {HEAD + RECORD.itemsize * count} bytes, the file has {len(data)}; "
         "try: export it again")


def _binary(path, data, count):
    """Triangles of a binary STL file of the right length."""
    corners = np.frombuffer(data, RECORD, count, HEAD)["corners"].astype(float)
    bad = np.flatnonzero(~np.isfinite(corners).all(axis=(1, 2)))
    if len(bad):
        fail(f"{path}: byte {HEAD + RECORD.itemsize * bad[0]}: triangle {bad[0] + 1} has a corner "
             "that is no finite number; try: repair it in the program that made it")
    if not count:
        fail(f"{path}: byte 80: has no triangles; try: export it again")
    return corners


def _ascii(path, text):
    """Triangles of an ASCII STL file: facet normal, outer loop, 3 vertex, endloop, endfacet."""
    grammar = ["facet", "outer", "vertex", "vertex", "vertex", "endloop", "endfacet"]
    corners, state, inside = [], 0, False

    def complain(number, expected, line):
        fail(f"{path}:{number}: expected {expected}, found '{line.strip()[:60]}'; try: export it "
             "again, or as a binary STL")
    lines = text.splitlines()
    for number, line in enumerate(lines, start=1):
        words = line.split()
        if not words:
            continue
        key = words[0].lower()
        if key in ("solid", "endsolid") and state == 0 and inside == (key == "endsolid"):
            inside = key == "solid"
            continue
        if not inside or key != grammar[state]:
            complain(number, f"'{grammar[state] if inside else 'solid'}'"
                     f"{' or endsolid' * (inside and state == 0)}", line)
        if key == "vertex":
            corners.append(_vertex(words) or complain(number, "'vertex' and three finite numbers",
                                                      line))
        state = (state + 1) % len(grammar)
    if inside:
        complain(len(lines), "'endsolid' at the end", lines[-1])
    if not corners:
        fail(f"{path}:1: has no triangles; try: export it again")
    return np.reshape(corners, (-1, 3, 3))


def _vertex(words):
    """The numbers of a line `vertex x y z`, or None."""
    try:
        values = [float(word) for word in words[1:]]
    except ValueError:
        return None
    return values if len(values) == 3 and all(map(math.isfinite, values)) else None


def merge(triangles, tolerance=0.0):
    """Vertices (v, 3), faces (n, 3) of triangles (n, 3, 3), and how many were left out.

    Corners that are equal become one; with a tolerance [L] those in one cell of a grid of that
    width, or in cells whose rounded places agree. Left out: triangles without an area.
    """
    points = triangles.reshape(-1, 3) + 0.0  # -0 becomes 0
    keys = np.round(points / tolerance) if tolerance > 0 else points
    _, first, index = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)  # vertices in the order of the file
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    vertices, faces = points[first[order]], rank[index.reshape(-1)].reshape(-1, 3)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    longest = np.max([((u - v)**2).sum(axis=1) for u, v in ((a, b), (b, c), (c, a))], axis=0)
    good = np.linalg.norm(np.cross(b - a, c - a), axis=1) > FLAT * longest
    used, faces = np.unique(faces[good], return_inverse=True)
    return vertices[used], faces.reshape(-1, 3), int((~good).sum())


def write_off(path, vertices, faces, title):
    """Write triangles as an OFF file."""
    lines = ["OFF", f"# {title}", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(f"{value:.9g}" for value in row) for row in vertices.tolist()]
    lines += [f"3 {a} {b} {c}" for a, b, c in faces.tolist()]
    Path(path).write_text("\n".join(lines) + "\n")


def write_stl(path, triangles):
    """Write triangles (n, 3, 3) as a binary STL file."""
    records = np.zeros(len(triangles), RECORD)
    records["corners"] = triangles
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    records["normal"] = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    head = b"triangles of a TinyDEM mesh".ljust(80) + struct.pack("<I", len(triangles))
    Path(path).write_bytes(head + records.tobytes())


def triangles_of(elements):
    """Triangles (n, 3, 3) of mesh elements; rectangles are cut in two, the rest left out."""
    parts = [e.corners[[0, 1, 2]] for e in elements if len(e.corners) > 2]
    parts += [e.corners[[0, 2, 3]] for e in elements if len(e.corners) == 4]
    return np.reshape(parts, (-1, 3, 3))


def describe(name, points, counts):
    """Print the size of a mesh: points (n, 3) [L] and a text with its counts."""
    low, high = points.min(axis=0), points.max(axis=0)
    box = " x ".join(f"{value:.6g}" for value in high - low)
    corner = ", ".join(f"{value:.6g}" for value in low)
    print(f"{name}: {counts}; box {box} from ({corner})")


def main(args):
    """Convert as the command line says."""
    source, target = args.source.suffix.lower(), args.target and args.target.suffix.lower()
    if source not in (".stl", ".off") or target not in (None, {".stl": ".off"}.get(source, ".stl")):
        fail(f"{args.source} {args.target or ''}: must be an .stl and an .off file, or the other "
             "way round; try: mesh_tools.py part.stl part.off")
    if not (args.scale > 0 and math.isfinite(args.scale) and args.merge >= 0):
        fail(f"--scale {args.scale:g} --merge {args.merge:g}: must be > 0 and >= 0; try: 0.001")
    try:
        if source == ".stl":
            vertices, faces, left_out = merge(args.scale * read_stl(args.source), args.merge)
            if not len(faces):
                fail(f"{args.source}: no triangle has an area; try: a smaller --merge")
            describe(args.source, vertices, f"{len(faces)} triangles, {len(vertices)} vertices, "
                     f"{left_out} triangles without an area left out")
            if args.target:
                write_off(args.target, vertices, faces, f"From {args.source.name}")
        else:
            elements = read_mesh(args.source)
            triangles = args.scale * triangles_of(elements)
            if not len(triangles):
                fail(f"{args.source}: has no triangles or rectangles; try: another mesh")
            lost = sum(len(e.corners) < 3 for e in elements)
            describe(args.source, triangles.reshape(-1, 3), f"{len(triangles)} triangles, "
                     f"{lost} points and edges left out")
            if args.target:
                write_stl(args.target, triangles)
    except OSError as error:
        fail(f"{args.target}: cannot be written ({error.strerror}); try: another folder")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=Path, help="an .stl or .off file")
    parser.add_argument("target", type=Path, nargs="?", help="the other kind, or only look")
    parser.add_argument("--scale", type=float, default=1.0, help="factor for all lengths")
    parser.add_argument("--merge", type=float, default=0.0, help="corners so close become one [L]")
    main(parser.parse_args())
