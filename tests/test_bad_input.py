"""Malformed input: a row per mistake, each a test of its own. By hand:

    TINYDEM=../build/default/tinydem python3 -m unittest test_bad_input

A row says what the program must report: one line per mistake, with the parts between | in this
order: the place (file and line), the value that was found, what is allowed, and, where that does
not say it yet, what to try. A refusal ends with exit code 2 and writes nothing at all.
KNOWN names the rows that do not pass yet, and why; once one passes, it must leave that list.
"""
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np
from tool_support import message_of

import mesh_tools

PROGRAM = os.environ.get("TINYDEM", "tinydem")
HEADER = "x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz"
GRAIN = "0,0,0,1,0,0,0,1,0,0,0,0,0,0\n"  # at the origin, R = 1, at rest
SQUARE = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"  # and one face, in line 7
POINT = "OFF\n1 1 0\n0 0 0\n1 0\n"
BOM = "\ufeff"
SHORT = ["--Nframes", "0", "--Nspawn", "0"]


def square(*faces):
    """A mesh with the vertices of a square and these faces."""
    return SQUARE.replace("4 1 0", f"4 {len(faces)} 0") + "".join(face + "\n" for face in faces)


def grains(*lines):
    """A particle file with these lines."""
    return "\n".join([HEADER, *(line.strip() for line in lines)]) + "\n"


def grain(**values):
    """A line of a particle file: GRAIN with other values."""
    names, columns = HEADER.split(","), GRAIN.strip().split(",")
    return ",".join(str(values.get(name, column)) for name, column in zip(names, columns))


NO_OFF = "m.off:{} | must start with OFF"
INTEGER, FINITE, COUNT = "must be an integer in", "must be a finite number", "[0, 2e+09]"
# name: (content, a line per mistake); no mistakes: the file is good
MESH = {
    "comments": ("# one\nOFF # two\n\n# three\n1 1 0 # four\n0 0 0\n\n1 0 1 # five\n", []),
    "carriage_returns": (POINT.replace("\n", "\r\n"), []),
    "byte_order_mark": (BOM + POINT, []),
    "tabs_and_no_last_newline": (POINT.replace(" ", "\t")[:-1], []),
    "counts_in_first_line": ("OFF 1 1 0\n0 0 0\n1 0\n", []),
    "no_vertices_no_faces": ("OFF\n0 0 0\n", []),
    "other_format": ("ply\n4 1 0\n", ["m.off:1 | must start with OFF | 'ply' | convert"]),
    "coloured_off": ("COFF\n1 1 0\n0 0 0\n1 0\n", ["m.off:1 | must start with OFF | 'COFF'"]),
    "empty": ("", ["m.off:0 | must start with OFF", *(f"m.off:0 | number of {what} = '' | {COUNT}"
                   for what in ("vertices", "faces", "edges"))]),
    "only_a_comment": ("# OFF\n", ["m.off:1 | must start with OFF", *(
        f"m.off:1 | number of {what} = '' | {COUNT}" for what in ("vertices", "faces", "edges"))]),
    "binary_off": ("OFF BINARY\n", ["m.off:1 | number of vertices = 'BINARY' | " + INTEGER,
                                    "m.off:1 | number of faces = ''",
                                    "m.off:1 | number of edges = ''"]),
    "no_counts": ("OFF\n", [f"m.off:1 | number of {what} = '' | {INTEGER} | {COUNT}"
                            for what in ("vertices", "faces", "edges")]),
    "two_counts": ("OFF\n1 1\n0 0 0\n1 0\n", ["m.off:2 | number of edges = '' | " + COUNT]),
    "four_counts": ("OFF\n1 1 0 7\n0 0 0\n1 0\n", ["m.off:2 | '7' | one value too many"]),
    "negative_counts": ("OFF\n-4 -1 0\n", ["m.off:2 | number of vertices = '-4' | " + COUNT,
                                           "m.off:2 | number of faces = '-1' | " + COUNT]),
    "fraction_as_count": ("OFF\n0 0.5 0\n", ["m.off:2 | number of faces = '0.5' | " + INTEGER]),
    "count_above_range": ("OFF\n0 1e10 0\n", ["m.off:2 | number of faces = '1e10' | " + COUNT]),
    "more_vertices_declared": ("OFF\n3 1 0\n0 0 0\n1 0\n", [
        "m.off:4 | z = '' | " + FINITE + " | 3 vertices"]),
    "file_ends_in_the_vertices": ("OFF\n3 1 0\n0 0 0\n", [
        "m.off:3 | must end after 3 vertices, 1 faces | has 1, 0"]),
    "more_faces_declared": (SQUARE.replace("4 1 0", "4 2 0") + "4 0 1 2 3\n", [
        "m.off:7 | must end after 4 vertices, 2 faces | has 4, 1"]),
    "fewer_faces_declared": (square("4 0 1 2 3") + "1 0\n", [
        "m.off:8 | must end after 4 vertices, 1 faces"]),
    "a_billion_vertices_declared": ("OFF\n1000000000 1 0\n0 0 0\n", [
        "m.off:3 | must end after 1000000000 vertices | has 1, 0"]),
    "a_billion_faces_declared": ("OFF\n1 1000000000 0\n0 0 0\n1 0\n", [
        "m.off:4 | must end after 1 vertices, 1000000000 faces | has 1, 1"]),
    "vertex_without_z": ("OFF\n1 1 0\n0 0\n1 0\n", ["m.off:3 | z = '' | " + FINITE]),
    "vertex_with_four": ("OFF\n1 1 0\n0 0 0 1\n1 0\n", ["m.off:3 | '1' | one value too many"]),
    "text_for_a_number": ("OFF\n1 1 0\n0 zero 0\n1 0\n", ["m.off:3 | y = 'zero' | " + FINITE]),
    "nan": ("OFF\n1 1 0\n0 nan 0\n1 0\n", ["m.off:3 | y = 'nan' | " + FINITE]),
    "infinity": ("OFF\n1 1 0\n0 0 -inf\n1 0\n", ["m.off:3 | z = '-inf' | " + FINITE]),
    "too_large_a_number": ("OFF\n1 1 0\n1e400 0 0\n1 0\n", ["m.off:3 | x = '1e400' | " + FINITE]),
    "decimal_comma": ("OFF\n1 1 0\n0,5 0 0\n1 0\n", ["m.off:3 | x = '0,5' | " + FINITE]),
    "zero_byte": ("OFF\n1 1 0\n0 \0 0\n1 7\n", ["m.off:3 | y = | " + FINITE,
                                                "m.off:4 | vertex index = '7' | [0, 0]"]),
    "endless_line": ("OFF\n1 1 0\n0 0 " + 5000 * "x" + "\n1 0\n", [
        "m.off:3 | z = 'xx | " + FINITE]),
    "index_out_of_range": (square("4 0 1 2 4"), ["m.off:7 | vertex index = '4' | in [0, 3]"]),
    "negative_index": (square("3 0 1 -1"), ["m.off:7 | vertex index = '-1' | in [0, 3]"]),
    "fraction_as_index": (square("3 0 1 1.5"), ["m.off:7 | index = '1.5' | " + INTEGER]),
    "face_without_vertices": (square("0"), ["m.off:7 | vertices of a face = '0' | in [1, 4]"]),
    "face_of_five": (square("5 0 1 2 3 0"), ["m.off:7 | vertices of a face = '5' | in [1, 4]"]),
    "face_too_short": (square("4 0 1 2"), ["m.off:7 | vertex index = '' | in [0, 3]"]),
    "corners_crossed": (square("4 0 1 3 2"), ["m.off:7 | must be the corners of a rectangle "
                                              "in order | or split the face"]),
    "parallelogram": (square("4 0 1 2 3").replace("1 1 0\n0 1 0", "2 1 0\n1 1 0"), [
        "m.off:7 | must be the corners of a rectangle | or split the face"]),
    "trapezoid": (square("4 0 1 2 3").replace("1 1 0\n", ".5 1 0\n"), [
        "m.off:7 | must be the corners of a rectangle | or split the face"]),
    "not_flat": (square("4 0 1 2 3").replace("1 1 0\n", "1 1 .1\n"), [
        "m.off:7 | must be the corners of a rectangle | or split the face"]),
    "radius_out_of_Rmesh": (square("4 0 1 2 3 3"), [
        "m.off:7 | index into Rmesh | --Rmesh adds radii | '3' | in [0, 2]"]),
    "negative_radius_index": (square("3 0 1 2 -1"), ["m.off:7 | index into Rmesh | '-1' | [0, 2]"]),
    "radius_for_an_index": (square("3 0 1 2 .02"), ["m.off:7 | into Rmesh | '.02' | " + INTEGER]),
    "colours": (square("4 0 1 2 3 255 0 0"), ["m.off:7 | index into Rmesh | '255' | in [0, 2]",
                                              "m.off:7 | '0' | one value too many"]),
    "cut_off": (SQUARE[:-5], ["m.off:6 | y = '' | " + FINITE, "m.off:6 | z = '' | " + FINITE]),
    "many_mistakes": ("OFF\n2 2 0\n0 0 x\n0 nan 0\n1 7\n1 0 9\n", [
        "m.off:3 | z = 'x'", "m.off:4 | y = 'nan'", "m.off:5 | '7' | [0, 1]", "m.off:6 | '9'"]),
    "more_mistakes_than_fit": (square(*30 * ["5 0"]), [
        *(f"m.off:{7 + k} | '5' | in [1, 4]" for k in range(20)), "10 more"]),
}
COLUMN = "p.csv:{} | {} | " + HEADER
PARTICLES = {
    "no_particles": (HEADER + "\n", []),
    "comments": ("# one\n" + HEADER + " # two\n\n# three\n" + GRAIN, []),
    "carriage_returns": (grains(GRAIN).replace("\n", "\r\n"), []),
    "byte_order_mark": (BOM + grains(GRAIN), []),
    "blanks_and_no_last_newline": (grains(GRAIN).replace(",", " , ")[:-1], []),
    "empty": ("", [COLUMN.format(0, "must stand here once") + " | ''"]),
    "no_header": (GRAIN, [COLUMN.format(1, "column") + " | '0,0,0,1,"]),
    "semicolons": (grains(GRAIN).replace(",", ";"), [COLUMN.format(1, "column") + " | 'x;y;z;R;"]),
    "capital_letters": (grains(GRAIN).upper(), [COLUMN.format(1, "column") + " | 'X,Y,Z,R,"]),
    "missing_column": (HEADER[:-3] + "\n", [COLUMN.format(1, "'wz' must stand here once")]),
    "unknown_column": (HEADER + ",mass\n", [COLUMN.format(1, "mass")]),
    "misspelt_column": (HEADER[:-1] + "Z\n", [COLUMN.format(1, "'wz' must stand here once")]),
    "column_twice": (HEADER + ",x\n", [COLUMN.format(1, "'x' must stand here once")]),
    "one_value_missing": (grains(GRAIN[:-3]), ["p.csv:2 | wz = '' | " + FINITE]),
    "empty_field": (grains(grain(y="")), ["p.csv:2 | y = '' | " + FINITE]),
    "one_value_too_many": (grains(GRAIN.strip() + ",5"), ["p.csv:2 | '5' | one value too many"]),
    "text_for_a_number": (grains(grain(vx="fast")), ["p.csv:2 | vx = 'fast' | " + FINITE]),
    "text_for_a_radius": (grains(grain(R="big")), ["p.csv:2 | R = 'big' | " + FINITE]),
    "nan": (grains(GRAIN, grain(wz="nan")), ["p.csv:3 | wz = 'nan' | " + FINITE]),
    "infinity": (grains(grain(x="inf")), ["p.csv:2 | x = 'inf' | " + FINITE]),
    "quotes": (grains(grain(x='"0"')), ["p.csv:2 | x = '\"0\"' | " + FINITE]),
    "radius_zero": (grains(grain(R=0)), ["p.csv:2 | R = 0 | must be > 0"]),
    "negative_radius": (grains(grain(R=-1)), ["p.csv:2 | R = -1 | must be > 0"]),
    "infinite_radius": (grains(grain(R="inf")), ["p.csv:2 | R = 'inf' | " + FINITE]),
    "quaternion_of_norm_0": (grains(grain(q0=0)), ["p.csv:2 | q0 ... q3 must have norm 1 | 0"]),
    "quaternion_of_norm_2": (grains(grain(q0=2)), ["p.csv:2 | q0 ... q3 must have norm 1 | 2"]),
    "cut_off": (grains(GRAIN, GRAIN[:9]), ["p.csv:3 | vy = '' | " + FINITE]),
    "coincident": (grains(GRAIN, GRAIN), ["p.csv:2 | overlaps | p.csv:3 | by 2 | radius 1 | move"]),
    "coincident_by_number": (grains(GRAIN, GRAIN), [
        "particle 1 | overlaps particle 2 by 2 | more than a radius 1 | move"]),
    "overlap": (grains(GRAIN, grain(x=0.5)), [
        "particle 1 | overlaps particle 2 by 1.5 | more than a radius 1 | move it"]),
    "no_finite_energy": (grains(grain(vx="1e200")), ["particles | no finite energy | slow them"]),
    "many_mistakes": (grains(grain(x="a"), GRAIN, grain(R=-1, q0=2), grain(z="b")), [
        "p.csv:2 | x = 'a'", "p.csv:4 | R = -1", "p.csv:4 | norm 1 | 2", "p.csv:5 | z = 'b'"]),
}
NUMBER, WHOLE = "must be a number in", "must be an integer in"
VECTOR = "must be three numbers (0,0,1) in"
MOTION = "must be one of GROUP vibrate A F [PHASE]; GROUP translate V; GROUP rotate P W"
# name: (line of a scene file or of the command line, its mistake)
SETTINGS = {
    "nu_above": ("nu = 0.6", f"nu = '0.6' | {NUMBER} (-1, 0.5]"),
    "nu_open_end": ("nu = -1", f"nu = '-1' | {NUMBER} (-1, 0.5]"),
    "en_below": ("en = -0.1", f"en = '-0.1' | {NUMBER} [0, 1]"),
    "en_above": ("en = 1.1", f"en = '1.1' | {NUMBER} [0, 1]"),
    "E_zero": ("E = 0", f"E = '0' | {NUMBER} (0, inf)"),
    "rho_negative": ("rho = -1", f"rho = '-1' | {NUMBER} (0, inf)"),
    "dt_zero": ("dt = 0", f"dt = '0' | {NUMBER} (0, inf)"),
    "mus_negative": ("mus = -1", f"mus = '-1' | {NUMBER} [0, inf)"),
    "eta_negative": ("eta = -1e-9", f"eta = '-1e-9' | {NUMBER} [0, inf)"),
    "Rmin_zero": ("Rmin = 0", f"Rmin = '0' | {NUMBER} (0, inf)"),
    "Rmax_below_Rmin": ("Rmax = 0.001", f"Rmax = '0.001' | {NUMBER} [Rmin, inf)"),
    "Rmesh_negative": ("Rmesh = 0,-1", "Rmesh = '0,-1' | must be numbers in [0, inf)"),
    "Rmesh_with_a_gap": ("Rmesh = 1,,2", "Rmesh = '1,,2' | must be numbers in [0, inf)"),
    "smax_below_smin": ("smax = 0,0,0", f"smax = '0,0,0' | {VECTOR} [smin, inf)"),
    "two_components": ("g = 0,-9.81", f"g = '0,-9.81' | {VECTOR} (-inf, inf)"),
    "four_components": ("v0 = 1,2,3,4", f"v0 = '1,2,3,4' | {VECTOR} (-inf, inf)"),
    "blanks_for_commas": ("w0 = 1 2 3", f"w0 = '1 2 3' | {VECTOR} (-inf, inf)"),
    "letters": ("smin = a,b,c", f"smin = 'a,b,c' | {VECTOR} (-inf, inf)"),
    "nan": ("E = nan", f"E = 'nan' | {NUMBER} (0, inf)"),
    "infinity": ("E = inf", f"E = 'inf' | {NUMBER} (0, inf)"),
    "too_large": ("E = 1e400", f"E = '1e400' | {NUMBER} (0, inf)"),
    "hexadecimal": ("E = 0x10", f"E = '0x10' | {NUMBER} (0, inf)"),
    "with_a_unit": ("E = 1e6 Pa", f"E = '1e6 Pa' | {NUMBER} (0, inf)"),
    "decimal_comma": ("E = 1,5", f"E = '1,5' | {NUMBER} (0, inf)"),
    "Nmax_negative": ("Nmax = -1", f"Nmax = '-1' | {WHOLE} [0, 2e9]"),
    "Nmax_large": ("Nmax = 1e10", f"Nmax = '1e10' | {WHOLE} [0, 2e9]"),
    "Nsteps_fraction": ("Nsteps = 1.5", f"Nsteps = '1.5' | {WHOLE} [0, 1e15]"),
    "Nsteps_large": ("Nsteps = 1e99", f"Nsteps = '1e99' | {WHOLE} [0, 1e15]"),
    "seed_text": ("seed = dice", f"seed = 'dice' | {WHOLE} [0, 1e15]"),
    "scheme": ("scheme = Paper", "scheme = 'Paper' | must be one of consistent|paper"),
    "orientation": ("orientation = yes", "orientation = 'yes' | must be one of on|off"),
    "motion_group": ("motion = 7 translate 0,0,1", f"motion = '7 trans | {MOTION} | Rmesh"),
    "motion_negative": ("motion = -1 translate 0,0,1", f"motion = '-1 translate | {MOTION}"),
    "motion_fraction": ("motion = .5 translate 0,0,1", f"motion = '.5 translate | {MOTION}"),
    "motion_kind": ("motion = 0 jump 0,0,1", f"motion = '0 jump 0,0,1' | {MOTION}"),
    "motion_nothing": ("motion = 0", f"motion = '0' | {MOTION}"),
    "motion_components": ("motion = 0 translate 1,2", f"motion = '0 translate 1,2' | {MOTION}"),
    "motion_infinite": ("motion = 0 translate 0,0,inf", f"motion = '0 | inf' | {MOTION}"),
    "motion_short": ("motion = 0 vibrate 0,0,1", f"motion = '0 vibrate 0,0,1' | {MOTION}"),
    "motion_long": ("motion = 0 vibrate 0,0,1 2 3 4", f"motion = '0 vib | 3 4' | {MOTION}"),
    "motion_axis": ("motion = 0 rotate 0,0,0", f"motion = '0 rotate 0,0,0' | {MOTION}"),
    "motion_twice": ("motion = 0 translate 0,0,1; 0 translate 0,0,1", f"motion = '0 | {MOTION}"),
}
SCENE = {
    "comments": ("# one\n\nE = 1e6 # two\n", []),
    "carriage_returns": ("E = 1e6\r\n\r\ng = 0,0,-1\r\n", []),
    "byte_order_mark": (BOM + "E = 1e6\n", []),
    "repeated": ("E = 1\n\nE = 1\n", ["s.ini:3 | 'E' is repeated | it stands in s.ini:1"]),
    "no_equals": ("E 3\n", ["s.ini:1 | 'E 3' | must be name = value"]),
    "two_equals": ("E = 1 = 2\n", ["s.ini:1 | 'E = 1 = 2' | must be name = value"]),
    "colon": ("E: 3\n", ["s.ini:1 | 'E: 3' | must be name = value"]),
    "unknown": ("Rmim = 1\n", ["s.ini:1 | 'Rmim' is unknown | did you mean 'Rmin'?"]),
    "unknown_underscore": ("mu_s = 1\n", ["s.ini:1 | 'mu_s' is unknown | did you mean 'mus'?"]),
    "unknown_capitals": ("MUS = 1\n", ["s.ini:1 | 'MUS' is unknown | did you mean 'mus'?"]),
    "no_value": ("E =\n", [f"s.ini:1 | E = '' | {NUMBER} (0, inf)"]),
    "zero_byte": ("\0\n", ["s.ini:1 | must be name = value"]),
    "two_kinds_of_mistakes": ("E 1\nnu = 9\n", ["s.ini:1 | 'E 1' | must be name = value",
                                               "s.ini:2 | nu = '9'"]),
    "section": ("[solver]\nE = 1\n", ["s.ini:1 | '[solver]' | must be name = value"]),
    "no_name": ("= 3\n", ["s.ini:1 | '' is unknown"]),
    "far_from_every_name": ("viscosity = 3\n", ["s.ini:1 | 'viscosity' is unknown | --help"]),
    "contacts": ("contacts = 1\n", ["s.ini:1 | contacts = '1' | must be one of on|off"]),
    "Rmin_above_the_default_Rmax": ("Rmin = 0.02\n", [
        f"s.ini:1 | Rmax = '0.01' | {NUMBER} [Rmin, inf)"]),
    "mesh_is_not_there": ("mesh = none.off\n", ["none.off: cannot be read | check the path"]),
    "mesh_is_a_folder": ("mesh = .\n", [".: cannot be read | check the path"]),
    "particles_are_not_there": ("particles = none.csv\n", ["none.csv: cannot be read | check"]),
    "many_mistakes": ("nu = 7\nRmim = 2\n\nNmax = x\ng = 1\n", [
        "s.ini:1 | nu = '7'", "s.ini:2 | Rmim", "s.ini:4 | Nmax = 'x'", "s.ini:5 | g = '1'"]),
}
HERE = "command line"
COMMAND = {
    "no_value": (["--E"], [f"{HERE} | --E | 1 required | see --help"]),
    "no_path": (["--mesh"], [f"{HERE} | --mesh | 1 required | see --help"]),
    "a_path_twice": (["--output", "two"], [f"{HERE} | --output | At Most 1 | see --help"]),
    "unknown": (["--mu_s=0.1"], [f"{HERE} | 'mu_s | is unknown | did you mean 'mus'?"]),
    "unknown_and_its_value": (["--mu_s", "0.1"], [f"{HERE} | 'mu_s' is unknown | mean 'mus'?"]),
    "repeated": (["--E", "1", "--E", "1"], [f"{HERE} | --E | At Most 1 | see --help"]),
    "vector_as_three": (["--g", "1", "2", "3"], [f"{HERE} | g = '1' | {VECTOR}",
                                                 f"{HERE} | '2' is unknown",
                                                 f"{HERE} | '3' is unknown"]),
    "too_many_files": (["too", "many"], [f"{HERE} | 'too' is unknown", f"{HERE} | 'many' is unk"]),
    "one_dash": (["-E=1"], [f"{HERE} | 'E=1' is unknown | did you mean 'E'?"]),
    "equals_sign": (["--nu=0.6"], [f"{HERE} | nu = '0.6' | {NUMBER} (-1, 0.5]"]),
    "value_for_a_flag": (["--overwrite=3"], [f"{HERE} | overwrite"]),
    "two_flags_that_exclude_each_other": (["--overwrite", "--resume"], [f"{HERE} | resume"]),
    "scene_is_not_there": (["--scene", "none.ini"], ["none.ini: cannot be read | check the path"]),
    "many_mistakes": (["--E", "-1", "--nu", "7", "--Nmax", "x"], [
        f"{HERE} | E = '-1'", f"{HERE} | nu = '7'", f"{HERE} | Nmax = 'x'"]),
}
STL = "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n" \
      "endloop\nendfacet\nendsolid part\n"
RECORD = struct.pack("<12fH", *3 * [0], *(0, 0, 0, 1, 0, 0, 0, 1, 0), 0)  # a triangle


def binary_stl(count, *records):
    """A binary STL file that announces `count` triangles."""
    return 80 * b" " + struct.pack("<I", count) + b"".join(records)


STL_FILES = {
    "carriage_returns": (STL.replace("\n", "\r\n"), None),
    "capital_letters": (STL.upper(), None),
    "byte_order_mark": (BOM + STL, None),
    "binary": (binary_stl(1, RECORD), None),
    "empty": ("", "part.stl: byte 0 | try: export it again"),
    "text": ("hello " * 40, "part.stl: byte | try: export it again"),
    "off": (SQUARE + "4 0 1 2 3\n", "part.stl: byte | try: export it again"),
    "a_billion_triangles": (binary_stl(10**9, RECORD), "part.stl: byte 134 | 1000000000 triangles "
                            "| 50000000084 bytes, the file has 134 | try: export it again"),
    "triangles_too_few": (binary_stl(0, RECORD), "part.stl: byte 84 | 0 triangles | 134 | try: "),
    "cut_off": (binary_stl(2, RECORD, RECORD)[:-7], "part.stl: byte 134 | 2 triangles | try: "),
    "binary_infinity": (binary_stl(1, RECORD[:12] + struct.pack("<f", np.inf) + RECORD[16:]),
                        "part.stl: byte 84 | triangle 1 | no finite number | try: repair it"),
    "no_triangles": ("solid\nendsolid\n", "part.stl:1 | has no triangles | try: export it again"),
    "nan": (STL.replace("1 0 0", "nan 0 0"), "part.stl:5 | three finite numbers | nan | try: "),
    "infinity": (STL.replace("1 0 0", "1 -inf 0"), "part.stl:5 | three finite numbers | try: "),
    "two_numbers": (STL.replace("1 0 0", "1 0"), "part.stl:5 | three finite | 'vertex 1 0' | try"),
    "decimal_comma": (STL.replace("1 0 0", "0,5 0 0"), "part.stl:5 | three finite | 0,5 | try: "),
    "four_corners": (STL.replace("endloop", "vertex 1 1 0\nendloop"),
                     "part.stl:7 | expected 'endloop' | 'vertex 1 1 0' | try: "),
    "no_endfacet": (STL.replace("endfacet\n", ""), "part.stl:8 | expected 'endfacet' | try: "),
    "no_endsolid": (STL.replace("endsolid part\n", ""), "part.stl:8 | expected 'endsolid' | try: "),
}

KNOWN = {
    "particles_coincident": "does not name file and line",
    "scene_two_kinds_of_mistakes": "looks at values only when every line is a setting",
}


# -------------------------------------------------------------------------------- one per row

def matches(line, row):
    """Do the parts of a row stand in a line, in this order?"""
    return re.search(".*".join(re.escape(part) for part in row.split(" | ")), line) is not None


class Folder(unittest.TestCase):
    """A test in a folder of its own that runs the program there."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="tinydem_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, name, content):
        """Write text as UTF-8, or bytes, without any translation."""
        data = content if isinstance(content, bytes) else content.encode()
        (self.folder / name).write_bytes(data)

    def run_it(self, *arguments, code=0, **options):
        """Run the program with one thread, check its exit code: (standard output, errors)."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, timeout=100,
                              env=dict(os.environ, OMP_NUM_THREADS="1"), capture_output=True,
                              **options)
        out, errors = done.stdout.decode(), done.stderr.decode(errors="replace")
        self.assertEqual(done.returncode, code, errors)
        return out, errors

    def everything(self):
        """Name -> bytes of all files of the folder."""
        return {str(path): path.is_file() and path.read_bytes()
                for path in sorted(self.folder.rglob("*"))}

    def check(self, arguments, rows):
        """The run is refused with these rows and leaves no trace; without rows, it succeeds."""
        before = self.everything()
        out, errors = self.run_it(*arguments, code=2 if rows else 0)
        if not rows:
            self.assertEqual(errors, "")
            return
        self.assertEqual(out, "")
        self.assertEqual(self.everything(), before)
        self.assertTrue(errors.startswith("error: "))
        lines = errors[len("error: "):].splitlines()
        for row in rows:
            self.assertEqual(sum(matches(line, row) for line in lines), 1, f"'{row}' in\n{errors}")
        self.assertEqual(len(lines), len(rows), errors)
        for line in lines:
            self.assertLess(len(line), 300)


class BadMesh(Folder):
    def check_row(self, content, rows):
        self.write("m.off", content)
        self.check(["m.off", "", "out", *SHORT], rows)


class BadParticles(Folder):
    def check_row(self, content, rows):
        self.write("p.csv", content)
        self.check(["", "p.csv", "out", *SHORT], rows)


class BadScene(Folder):
    def check_row(self, content, rows):
        self.write("s.ini", content)
        self.check(["", "", "out", "--scene", "s.ini", *SHORT], rows)


class BadCommand(Folder):
    def check_row(self, words, rows):
        self.check(["", "", "out", *SHORT, *words], rows)


class BadSetting(Folder):
    """A wrong value is refused alike in a scene file, with its line, and as an option."""

    def check_row(self, line, row):
        name, _, value = (word.strip() for word in line.partition("="))
        self.write("s.ini", f"# a scene\n{line}\n")
        self.check(["", "", "out", "--scene", "s.ini"], ["s.ini:2: | " + row])
        self.check(["", "", "out", f"--{name}={value}"], ["command line: | " + row])


class BadStl(Folder):
    def check_row(self, content, row):
        self.write("part.stl", content)
        path = self.folder / "part.stl"
        if row is None:
            triangle = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
            self.assertEqual(mesh_tools.read_stl(path).tolist(), [triangle])
            return
        message = message_of(self, mesh_tools.read_stl, path)
        self.assertTrue(matches(message, row), f"'{row}' in\n{message}")
        self.assertEqual(message.count("\n"), 1)


def make_test(arguments, why):
    """A test of one row; one that is known to fail says so."""
    def test(self):
        self.check_row(*arguments)
    test.__doc__ = why
    return unittest.expectedFailure(test) if why else test


ROWS = [(BadMesh, "mesh", MESH), (BadParticles, "particles", PARTICLES), (BadScene, "scene", SCENE),
        (BadSetting, "setting", SETTINGS), (BadCommand, "command", COMMAND),
        (BadStl, "stl", STL_FILES)]
for case, kind, table in ROWS:
    for name, arguments in table.items():
        setattr(case, f"test_{kind}_{name}",
                make_test(arguments, KNOWN.get(f"{kind}_{name}")))


# ------------------------------------------------------------------------------ output, restart

SCENE_OF_RUN = """mesh = floor.off
Nmax = 60
Nframes = 12
Nsteps = 100
Nspawn = 1
Rmin = 0.004
Rmax = 0.005
smin = -0.02,-0.02,0.02
smax = 0.02,0.02,0.05
motion = 0 vibrate 0.001,0,0.001 30 1
contacts = on
"""
FLOOR = "OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n"


def results(folder):
    """Name -> bytes of the frames of a run, and its log without the speed, which always differs."""
    frames = {path.name: path.read_bytes() for path in Path(folder).glob("*0*.csv")}
    log = (Path(folder) / "log.csv").read_bytes().splitlines()
    return frames, [line.rpartition(b",")[0] for line in log]


class Output(Folder):
    """Output that cannot be written, and runs that were stopped."""

    def setUp(self):
        super().setUp()
        self.write("floor.off", FLOOR)
        self.write("scene.ini", SCENE_OF_RUN)
        self.run = ["--scene", "scene.ini"]

    def mount(self, size):
        """An empty disk of `size` bytes; its path. Skips the test where that is not allowed."""
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = os.geteuid() == 0 and subprocess.run(
            ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", disk], capture_output=True)
        if not mounted or mounted.returncode != 0:
            self.skipTest("a disk of its own can be mounted by root only")
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        return disk

    def remount(self, disk, options):
        subprocess.run(["mount", "-o", f"remount,{options}", disk], check=True)

    def refused(self, out, code, *says):
        """The run into `out` ends with a code, one line that says this and no new file there."""
        before = self.everything()
        printed, errors = self.run_it("", "", out, *self.run, code=code)
        self.assertEqual(printed, "")
        self.assertTrue(matches(errors, " | ".join(says)), f"{says} in\n{errors}")
        self.assertEqual(errors.count("\n"), 1)
        self.assertEqual(self.everything(), before)

    def test_a_name_that_is_no_folder(self):
        for out in ("floor.off", "floor.off/out", "/proc/none"):
            self.refused(out, 2, out, "cannot be a directory", "name another")

    def test_a_new_folder_on_a_read_only_disk(self):
        disk = self.mount(65536)
        self.remount(disk, "ro")
        self.refused(disk / "out", 2, f"{disk}/out", "cannot be a directory", "name another")

    def test_a_folder_on_a_read_only_disk(self):
        disk = self.mount(65536)
        (disk / "out").mkdir()
        self.remount(disk, "ro")
        self.refused(disk / "out", 2, f"{disk}/out", "cannot be", "name another")

    def test_a_disk_that_is_full_from_the_start(self):
        disk = self.mount(65536)
        (disk / "out").mkdir()
        (disk / "fill").write_bytes(bytes(65536))
        self.refused(disk / "out", 1, f"{disk}/out", "cannot be written", "free some space")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission(self):
        (self.folder / "locked").mkdir(mode=0o555)
        self.refused("locked/out", 2, "locked/out", "cannot be a directory", "name another")

    def test_a_disk_that_fills_up_in_the_middle_of_a_frame(self):
        disk = self.mount("150k")
        whole, out = self.folder / "whole", disk / "out"
        self.run_it("", "", whole, *self.run, "--quiet")
        printed, errors = self.run_it("", "", out, *self.run, code=1)
        self.assertTrue(matches(errors, f"{out} | cannot be written | free some space | --resume"))
        frames, expected = results(out)[0], results(whole)[0]
        complete = len(printed.splitlines())  # frames, or what goes with the next one was cut off
        self.assertIn(len(frames), range(2 * complete, 2 * complete + 3))
        self.assertGreater(len(frames), 2)
        self.assertLess(len(frames), len(expected))
        self.assertEqual(frames, {name: expected[name] for name in frames})
        self.assertEqual(list(out.glob("*.part")), [])
        self.remount(disk, "size=2m")
        self.run_it("", "", out, "--resume")
        self.assertEqual(results(out), results(whole))

    def test_a_folder_that_vanishes(self):
        process = subprocess.Popen([PROGRAM, "", "", "out", *self.run, "--Nframes", "9999"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertIn(b"frame 0", process.stdout.readline())
        (self.folder / "out").rename(self.folder / "gone")
        errors = process.communicate(timeout=100)[1].decode()
        self.assertEqual(process.returncode, 1)
        self.assertTrue(matches(errors, "error: out/ | cannot be written"), errors)
        self.assertFalse((self.folder / "out").exists())
        # The file that was being written moves along under its temporary name, out of reach.
        self.assertLessEqual(len(list((self.folder / "gone").glob("*.part"))), 1)

    def damaged(self, change):
        """The run is over and restart.bin changed; then --resume must refuse and change nothing."""
        self.run_it("", "", "out", *self.run, "--quiet")
        path = self.folder / "out/restart.bin"
        path.write_bytes(change(path.read_bytes()))
        before = self.everything()
        _, errors = self.run_it("", "", "out", "--resume", "--Nframes", "13", code=2)
        self.assertTrue(matches(errors, "restart.bin | use --overwrite"), errors)
        self.assertEqual(self.everything(), before)

    def test_a_restart_file_that_was_cut_off(self):
        self.damaged(lambda data: data[:-1])

    def test_a_restart_file_of_another_program(self):
        self.damaged(lambda data: b"TinyDEM 9" + data[9:])

    def test_a_restart_file_of_an_older_version(self):
        self.damaged(lambda data: b"TinyDEM 0.0" + data[11:])

    def test_a_restart_file_without_its_frame(self):
        self.damaged(lambda data: data.replace(b" 12\n", b" xx\n", 1))

    def test_a_restart_file_with_an_absurd_size(self):
        self.damaged(lambda data: data.replace(b"\n", b"\n" + 7 * b"\xff" + b"\x7f", 1))

    def test_a_restart_file_with_a_wrong_bit(self):
        def flip(data):
            return data[:1000] + bytes([data[1000] ^ 1]) + data[1001:]
        self.damaged(flip)

    def test_twenty_runs_killed_at_random_moments_resume_bit_for_bit(self):
        begin = time.monotonic()
        self.run_it("", "", "whole", *self.run, "--quiet")
        duration, random, kills = time.monotonic() - begin, np.random.default_rng(), 0
        for _ in range(100):
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            moment, begin = (kills + random.random()) / 20 * duration, time.monotonic()
            process = subprocess.Popen([PROGRAM, "", "", "out", *self.run, "--quiet"],
                                       cwd=self.folder,
                                       env=dict(os.environ, OMP_NUM_THREADS="1"))
            try:
                process.wait(moment)
                duration = min(duration, time.monotonic() - begin)  # over too soon: try again
                continue
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
            kills += process.wait() == -signal.SIGKILL
            self.run_it("", "", "out", *self.run, "--resume", "--quiet")
            self.assertEqual(results(self.folder / "out"), results(self.folder / "whole"),
                             f"killed after {moment:.3f} of {duration:.3f} s")
            self.assertEqual(list((self.folder / "out").glob("*.part")), [])
            if kills == 20:
                return
        self.fail(f"only {kills} of 100 runs could be killed in time")

    def test_a_run_killed_while_it_replaces_another_starts_anew(self):
        self.run_it("", "", "whole", *self.run, "--quiet")
        self.run_it("", "", "out", *self.run, "--quiet", "--seed", "2")
        (self.folder / "out/scene.ini").unlink()  # as --overwrite does, before the frames
        self.run_it("", "", "out", *self.run, "--resume", "--quiet")
        self.assertEqual(results(self.folder / "out"), results(self.folder / "whole"))


class Memory(Folder):
    def test_a_billion_declared_vertices_take_no_memory(self):
        self.write("m.off", "OFF\n1000000000 1000000000 0\n0 0 0\n")
        self.run_it("m.off", "", "out", *SHORT, code=2)
        kilobytes = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # of all runs so far
        self.assertLess(kilobytes, 400_000)


if __name__ == "__main__":
    unittest.main()
