#!/usr/bin/env python3
"""Turn a run into files for ParaView and VTK.

    to_vtk.py OUTPUT                writes OUTPUT/vtk: particles.pvd, mesh.pvd and what they name
    to_vtk.py OUTPUT --every 10     every tenth frame

In ParaView open both .pvd files. Filter `Glyph`: sphere of radius 1, scale array R, scale factor 1,
all points; colour it by speed. The mesh has cell data group and R; a tube filter shows thick edges.
Points carry R, v, w (vectors), q (four components), speed and id, the order of creation.
"""
import argparse
import base64
from pathlib import Path

import numpy as np

from frames import columns, fail, read_run, speed

TYPES = {"f": "Float64", "i": "Int64"}


def data_array(name, values):
    """A <DataArray> element: base64 of the number of bytes and of the numbers, little endian."""
    values = np.asarray(values)
    values = np.ascontiguousarray(values, "<f8" if values.dtype.kind == "f" else "<i8")
    size = values.shape[1] if values.ndim == 2 else 1
    raw = np.array([values.nbytes], "<u8").tobytes() + values.tobytes()
    return (f'<DataArray type="{TYPES[values.dtype.kind]}" Name="{name}" '
            f'NumberOfComponents="{size}" format="binary">\n'
            f'{base64.b64encode(raw).decode()}\n</DataArray>\n')


def cells(kind, connectivity):
    """A <Verts>, <Lines> or <Polys> element of cells, each a list of point indices."""
    ends = np.cumsum([len(cell) for cell in connectivity])
    flat = np.concatenate(connectivity) if connectivity else np.zeros(0)
    return (f"<{kind}>\n{data_array('connectivity', flat.astype(int))}"
            f"{data_array('offsets', ends.astype(int))}</{kind}>\n")


def poly_data(points, groups, point_data=None, cell_data=None):
    """Text of a .vtp file: points (n, 3), groups {kind: cells}, data {name: array}."""
    counts = " ".join(f'NumberOf{kind}="{len(groups.get(kind, []))}"'
                      for kind in ("Verts", "Lines", "Polys"))
    parts = ['<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" '
             'byte_order="LittleEndian" header_type="UInt64">\n<PolyData>\n'
             f'<Piece NumberOfPoints="{len(points)}" {counts} NumberOfStrips="0">\n']
    for place, data in (("PointData", point_data), ("CellData", cell_data)):
        arrays = "".join(data_array(name, values) for name, values in (data or {}).items())
        parts.append(f"<{place}>\n{arrays}</{place}>\n")
    parts.append(f"<Points>\n{data_array('Points', np.reshape(points, (-1, 3)).astype(float))}"
                 "</Points>\n")
    parts += [cells(kind, groups.get(kind, [])) for kind in ("Verts", "Lines", "Polys")]
    return "".join(parts) + "</Piece>\n</PolyData>\n</VTKFile>\n"


def particles_vtp(frame):
    """Text of the .vtp file of a frame (structured array as frames.read_frame gives it)."""
    data = {"R": frame["R"], "v": columns(frame, "vx,vy,vz"), "w": columns(frame, "wx,wy,wz"),
            "q": columns(frame, "q0,q1,q2,q3"), "speed": speed(frame),
            "id": np.arange(len(frame))}
    verts = [[k] for k in range(len(frame))]
    return poly_data(columns(frame, "x,y,z"), {"Verts": verts}, data)


def mesh_vtp(elements):
    """Text of the .vtp file of a mesh, a list of Elements."""
    groups, order, points = {"Verts": [], "Lines": [], "Polys": []}, {}, []
    kinds = ["Verts", "Lines", "Polys", "Polys"]
    for element in elements:
        n = len(element.corners)
        groups[kinds[n - 1]].append(np.arange(len(points), len(points) + n))
        order.setdefault(kinds[n - 1], []).append(element)
        points += list(element.corners)
    # Cell data are in the order of VTK: points, lines, faces.
    sort = [e for kind in ("Verts", "Lines", "Polys") for e in order.get(kind, [])]
    data = {"group": np.array([e.group for e in sort], int),
            "R": np.array([e.radius for e in sort], float)}
    return poly_data(points, groups, None, data)


def collection(rows):
    """Text of a .pvd file: rows of (time, file name)."""
    lines = [f'<DataSet timestep="{time:.12g}" part="0" file="{name}"/>\n' for time, name in rows]
    return ('<?xml version="1.0"?>\n<VTKFile type="Collection" version="1.0" '
            f'byte_order="LittleEndian">\n<Collection>\n{"".join(lines)}'
            '</Collection>\n</VTKFile>\n')


def convert(run, folder, every=1):
    """Write the files of a run; returns the number of frames."""
    folder.mkdir(parents=True, exist_ok=True)
    rows, mesh_rows, moves = [], [], bool(run.scene.get("motion"))
    for number, frame in run.frames(every):
        time, name = run.time(number), f"particles{number:06d}.vtp"
        (folder / name).write_text(particles_vtp(frame))
        rows.append((time, name))
        if run.mesh and (moves or not mesh_rows):
            name = f"mesh{number:06d}.vtp" if moves else "mesh.vtp"
            (folder / name).write_text(mesh_vtp(run.mesh_at(time)))
            mesh_rows.append((time, name))
    (folder / "particles.pvd").write_text(collection(rows))
    if mesh_rows:
        (folder / "mesh.pvd").write_text(collection(mesh_rows))
    return len(rows)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, metavar="OUTPUT", help="folder of a run")
    parser.add_argument("--every", type=int, default=1, metavar="K", help="every K-th frame")
    parser.add_argument("--out", type=Path, metavar="DIR", help="default: OUTPUT/vtk")
    args = parser.parse_args()
    if args.every < 1:
        fail(f"--every {args.every}: must be 1 or more; try: 1")
    target = args.out or args.directory / "vtk"
    try:
        count = convert(read_run(args.directory), target, args.every)
    except OSError as error:
        fail(f"{target}: cannot be written ({error.strerror}); try: --out DIR")
    print(f"{target}: {count} frames; open particles.pvd and mesh.pvd in ParaView")
