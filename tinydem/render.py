#!/usr/bin/env python3
"""Turn the frames that a run wrote into pictures and an animation.

    render.py OUTPUT                      start.png, middle.png and end.png
    render.py OUTPUT --animate            and animation.gif (--animate mp4 needs ffmpeg)
    render.py OUTPUT --frames 0,50,100    frame000000.png, frame000050.png, frame000100.png

View coordinates are x to the right, y up and z to the eye, in samples, FINE of them per pixel.
Rays are parallel, so that a radius in the picture is to scale wherever the particle is.
"""
import argparse
import math
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
from matplotlib import cm, colormaps, colors
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

COLUMNS = ["x", "y", "z", "R", "vx", "vy", "vz"]
VIEW = (284, 14)  # azimuth and elevation of the eye [degrees]
LEFT, RIGHT, BOTTOM, TOP, SIDE = 25, 115, 25, 55, 540  # margins around a square scene [pixels]
CREASE = math.cos(math.radians(20))  # edges of the mesh that bend less are not drawn
FINE, DPI, FPS = 2, 100, 12  # samples across a pixel, pixels per inch, frames per second
GIF_SCALE, MAX_FRAMES, CLEAR = 2 / 3, 60, 255  # of --size, of an animation, transparent colour
# Grains at rest are gold, fast ones purple: the middle part of a perceptually uniform scale.
COLORMAP = colors.ListedColormap(colormaps["plasma"](np.linspace(0.88, 0.1, 256)))
STEEL, GLASS = np.float32([0.55, 0.59, 0.65]), (107, 128, 153)
LIGHT, HALFWAY = np.float32([[-0.42, 0.58, 0.70], [-0.23, 0.32, 0.92]])  # HALFWAY: to the eye


def fail(message):
    """End the program: the input is no good. The message says where, why and what to try."""
    print(f"render.py: error: {message}", file=sys.stderr)
    sys.exit(2)


def read_particles(path):
    """One frame: array (N, 5) of x, y, z, R [m] and speed [m/s], in order of creation."""
    rows = [line.split(",") for line in path.read_text(errors="replace").splitlines()] or [[]]
    number, data = 1, []
    try:
        index = [rows[0].index(name) for name in COLUMNS]
        for number, row in enumerate(rows[1:], start=2):
            data.append([float(row[i]) for i in index])
            if len(row) != len(rows[0]) or not math.isfinite(sum(data[-1])):
                raise ValueError
    except (ValueError, IndexError):
        fail(f"{path}:{number}: expected {'numbers for ' * (number > 1)}{','.join(COLUMNS)},... "
             f"found '{','.join(rows[number - 1])[:60]}'; try: run the simulation again")
    data = np.reshape(data, (-1, len(COLUMNS)))
    return np.column_stack([data[:, :4], np.linalg.norm(data[:, 4:], axis=1)]).astype(np.float32)


def read_scene(path):
    """Of a scene.ini: mesh, a list of (corners (1..4, 3), radius) [m]; time between frames [s]."""
    lines = path.read_text().splitlines() if path.is_file() else []
    pairs = (line.partition("=") for line in lines if not line.lstrip().startswith("#"))
    scene = {name.strip(): value.strip() for name, _, value in pairs}
    if scene.get("motion"):
        print(f"{path}: note: the mesh moves, but is drawn where it starts", file=sys.stderr)
    try:
        seconds = float(scene["dt"]) * int(scene["Nsteps"]) if "dt" in scene else None
        radii = [float(word) for word in scene.get("Rmesh", "0").split(",")]
        if not scene.get("mesh"):
            return [], seconds
        lines = (path.parent / scene["mesh"]).read_text().splitlines()
        lines = [line.partition("#")[0].split() for line in lines]
        _, (nv, nf, *_), *lines = [words for words in lines if words]
        vertices = np.array([words[:3] for words in lines[:int(nv)]], float)
        faces = [list(map(int, words)) for words in lines[int(nv):int(nv) + int(nf)]]
        return [(vertices[face[1:n + 1]], radii[(face[n + 1:] or [0])[0]])
                for face in faces for n in face[:1]], seconds
    except (OSError, ValueError, KeyError, IndexError) as error:
        fail(f"{path}: dt, Nsteps, Rmesh or the mesh cannot be used ({error}); try: scene.ini and "
             "mesh.off as tinydem wrote them")


def camera(view, particles):
    """Unit vectors (3, 3) right, up and to the eye; no view: straight at a plane of particles."""
    flat = np.ptp(particles[:, :3], axis=0) == 0 if len(particles) else [False] * 3
    straight = [at for at, is_flat in zip([(0, 0), (-90, 0), (-90, 90)], flat) if is_flat]
    a, e = np.radians(view or (straight + [VIEW])[0])
    right = np.array([-np.sin(a), np.cos(a), 0])
    eye = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    return np.array([right, np.cross(eye, right), eye])


def bounding_box(axes, elements, frames):
    """Corners (2, 2) [m] around the mesh, where particles first appear and 98 % of all places."""
    mesh = np.array([[*point, radius] for corners, radius in elements for point in corners])
    fresh = np.concatenate([frame[len(before):] for before, frame in zip([[]] + frames, frames)])
    parts = [(rows[:, :3] @ axes[:2].T, rows[:, 3:4], tail) for rows, tail in
             ((mesh, 0), (fresh, 0), (np.concatenate(frames), 0.01)) if len(rows)]
    low = [np.quantile(centre - radius, tail, axis=0) for centre, radius, tail in parts]
    high = [np.quantile(centre + radius, 1 - tail, axis=0) for centre, radius, tail in parts]
    return np.array([np.min(low, axis=0), np.max(high, axis=0)] if parts else [[-1, -1], [1, 1]])


def unit_normal(face):
    """Unit normal (3,) of a triangle or rectangle (3 or 4, 3); zero if it has no area."""
    normal = np.cross(face[1] - face[0], face[-1] - face[0])
    return normal / max(np.linalg.norm(normal), 1e-30)


def outline(faces):
    """Edges of faces, but not the seams within a smooth surface: list of (ends (2, 3), radius)."""
    edges = {}
    for corners, radius in faces:
        for ends in zip(corners, np.roll(corners, -1, axis=0)):
            same = edges.setdefault(frozenset(map(tuple, ends)), [])
            same.append((np.array(ends), radius, unit_normal(corners)))
    return [same[0][:2] for same in edges.values()
            if len(same) != 2 or abs(same[0][2] @ same[1][2]) < CREASE]


def window(shape, low, high):
    """The slices of a buffer that cover the box low..high, and x and y of the samples there."""
    x0, x1 = max(int(low[0]), 0), max(min(int(high[0]) + 1, shape[1]), 0)
    y0, y1 = max(int(low[1]), 0), max(min(int(high[1]) + 1, shape[0]), 0)
    x, y = np.arange(x0, x1, dtype=np.float32), np.arange(y0, y1, dtype=np.float32)
    return (slice(y0, y1), slice(x0, x1)), x + 0.5, y[:, None] + 0.5


@np.errstate(invalid="ignore")
def draw_spheres(depth, owner, centres, radii, names):
    """Cast spheres (n,), at least a pixel thick, into the depth buffer; owner gets their names."""
    for (cx, cy, cz), r, name in zip(centres.tolist(), np.maximum(radii, FINE / 2).tolist(), names):
        place, x, y = window(depth.shape, (cx - r, cy - r), (cx + r, cy + r))
        z = cz + np.sqrt((r * r - (y - cy)**2) - (x - cx)**2)  # outside: NaN, which never wins
        nearer = z > depth[place]
        np.copyto(depth[place], z, where=nearer)
        np.copyto(owner[place], name, where=nearer)


def glass_pane(shape, face):
    """A face (3 or 4, 3) as seen: window, depth of its samples (-inf outside) and opacity."""
    (ax, ay, az), (nx, ny, nz) = face[0], unit_normal(face) + [0, 0, 1e-30]  # not 0 if edge-on
    place, x, y = window(shape, face.min(axis=0), face.max(axis=0))
    inside = np.all([((c[0] - b[0]) * (y - b[1]) - (c[1] - b[1]) * (x - b[0])) * nz > 0
                     for b, c in zip(face, np.roll(face, -1, axis=0))], axis=0)
    z = az - (nx * (x - ax) + ny * (y - ay)) / nz
    return place, np.where(inside, z, -np.inf), 0.05 + 0.22 * (1 - abs(nz))**2


def occlusion(depth, place, cell=12):
    """Brightness (n,) of samples: less for one a little below its surroundings, not far behind."""
    near = Image.fromarray(np.maximum(depth, depth[np.isfinite(depth)].min(initial=0)))
    few = near.resize([n // cell + 1 for n in near.size], Image.Resampling.BILINEAR)
    mean = np.asarray(few.resize(near.size, Image.Resampling.BILINEAR))
    below = np.maximum(mean[place] - depth[place], 0) / cell
    return 1 - 1.4 * below / (2 + below**2)


class Stage:
    """The mesh before a camera, drawn once; render() adds the particles of one frame."""

    def __init__(self, axes, box, elements, size):
        """axes (3, 3), box (2, 2) [m], mesh elements, size (width, height) [pixels]."""
        low, high = FINE * np.array([[LEFT, BOTTOM], size - [RIGHT, TOP]])
        self.scale = ((high - low) / np.maximum(box[1] - box[0], 1e-30)).min()
        self.turn = self.scale * axes.T  # view coordinates are points @ turn + shift
        self.shift = np.append((low + high) / 2 - self.scale * box.mean(axis=0), 0)
        shape = [2 * FINE * round(n / 2) for n in size[::-1]]  # even, which video needs
        self.depth, self.owner = np.full(shape, -np.inf, np.float32), np.full(shape, -1, np.int32)
        faces = [element for element in elements if len(element[0]) > 2]
        solids = [element for element in elements if len(element[0]) <= 2] + outline(faces)
        self.ends = np.reshape([e[[0, -1]] for e, _ in solids], (-1, 2, 3)) @ self.turn + self.shift
        for k, ((a, b), radius) in enumerate(zip(self.ends, [r * self.scale for _, r in solids])):
            n = 2 + int(np.linalg.norm(b - a) / max(radius / 8, 1))  # too dense to see the spheres
            draw_spheres(self.depth, self.owner, np.linspace(a, b, n), np.full(n, radius), [k] * n)
        self.panes = [glass_pane(shape, face @ self.turn + self.shift) for face, _ in faces]

    def render(self, particles, colors):
        """Image, bottom row first, of particles (N, 5) in colors (N, 3) from 0 to 1."""
        depth, owner, solid = self.depth.copy(), self.owner.copy(), len(self.ends)
        centres, radii = particles[:, :3] @ self.turn + self.shift, particles[:, 3] * self.scale
        draw_spheres(depth, owner, centres, radii, range(solid, solid + len(radii)))
        place = rows, columns = np.nonzero(owner >= 0)
        who = owner[place]
        normal = np.column_stack([columns + 0.5, rows + 0.5, depth[place]])
        normal -= np.concatenate([self.ends[:, 0], centres])[who]
        long = np.flatnonzero(who < solid)  # samples of capsules, whose normal starts on an axis
        axis = (self.ends[:, 1] - self.ends[:, 0])[who[long]]
        part = (normal[long] * axis).sum(axis=1) / np.maximum((axis**2).sum(axis=1), 1e-12)
        normal[long] -= np.clip(part, 0, 1)[:, None] * axis
        normal = (normal / np.linalg.norm(normal, axis=1)[:, None]).astype(np.float32)
        light = (0.35 + 0.18 * (1 + normal @ LIGHT)**2) * occlusion(depth, place)
        glint = 0.22 * np.maximum(normal @ HALFWAY, 0)**40
        colors = np.concatenate([np.tile(STEEL, (solid, 1)), colors]).astype(np.float32)[who]
        image = np.full(depth.shape + (3,), 255, np.uint8)
        image[place] = 255 * np.minimum(colors * light[:, None] + glint[:, None], 1)
        clear = np.full(depth.shape, 255, np.float32)  # what the panes in front let through
        for pane, z, opacity in self.panes:
            clear[pane] *= np.where(z > depth[pane], np.float32(1 - opacity), np.float32(1))
        image, clear = Image.fromarray(image), Image.fromarray(clear.astype(np.uint8))
        return Image.composite(image, Image.new("RGB", image.size, GLASS), clear).reduce(FINE)


def draw_frames(stage, numbers, frames, top_speed, seconds):
    """RGB images of frames {number: particles}; colours end at top_speed [m/s]."""
    h, w = (np.array(stage.depth.shape) / FINE + 0.01) / DPI  # inches, rounded down to pixels
    figure, speeds = Figure((w, h), dpi=DPI), colors.Normalize(0, top_speed)
    canvas, scale = FigureCanvasAgg(figure), cm.ScalarMappable(speeds, COLORMAP)
    label = figure.text(LEFT / DPI / w, 1 - 0.35 / h, "", size=13)
    bar = figure.add_axes([1 - 0.82 / w, 0.25, 0.16 / w, 0.5])
    figure.colorbar(scale, cax=bar, format="%.3g").ax.tick_params(labelsize=11)
    bar.set_title("speed\n(m/s)", fontsize=11, pad=8)
    picture = figure.figimage(np.zeros((1, 1, 3)), origin="lower", zorder=-1)
    for number in numbers:
        time = f"frame {number}" if seconds is None else f"t = {number * seconds:.4g} s"
        label.set_text(f"{time},  N = {len(frames[number])}")
        rgb = scale.to_rgba(frames[number][:, 4])[:, :3]
        picture.set_data(np.asarray(stage.render(frames[number], rgb)))
        canvas.draw()
        yield Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB")


def save_gif(path, images):
    """Write RGB images as a GIF. Pixels that do not change are transparent, to keep it small."""
    table = Image.fromarray(np.hstack(images[::4])).quantize(CLEAR)  # colours 0..CLEAR - 1
    table.putpalette([255 if c > 250 else c for c in table.getpalette()[:3 * CLEAR]] + [0, 255, 0])
    codes = [np.array(image.quantize(palette=table, dither=0)) for image in images]
    codes[1:] = [np.where(now == old, CLEAR, now) for old, now in zip(codes, codes[1:])]
    pages = [Image.fromarray(code.astype(np.uint8), "P") for code in codes]
    for page in pages:
        page.putpalette(table.getpalette())
    pages[0].save(path, save_all=True, append_images=pages[1:], loop=0, disposal=1, optimize=False,
                  transparency=CLEAR, duration=[1000 // FPS] * (len(pages) - 1) + [1500])  # ms


def save_mp4(path, images):
    """Write RGB images as a video, with ffmpeg."""
    command = (f"ffmpeg -y -loglevel error -f rawvideo -pix_fmt rgb24 -r {FPS} -s {{}}x{{}} -i - "
               "-pix_fmt yuv420p").format(*images[0].size).split()
    subprocess.run([*command, path], input=b"".join(i.tobytes() for i in images), check=True)


def parse_arguments():
    """The command line; a mistake in it ends the program with exit code 2."""
    def pair(text):
        return tuple(np.array(text.replace("x", ",").split(","), float).reshape(2))
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("directory", type=Path, metavar="OUTPUT", help="directory that a run wrote")
    add("--frames", default="start,middle,end", metavar="LIST", help="or numbers, like 0,50,100")
    add("--out", type=Path, metavar="DIR", help="where to write, default: OUTPUT")
    add("--animate", nargs="?", const="gif", choices=["gif", "mp4"], help="animate, too")
    add("--every", type=int, metavar="K", help=f"frame to animate, default: {MAX_FRAMES} at most")
    add("--size", type=pair, metavar="WxH", help="of a picture [pixels], 300x300 or more")
    add("--view", type=pair, metavar="A,E", help="azimuth and elevation, negative: --view=-76,14")
    return parser.parse_args()


def find_frames(args):
    """Files {number: path} of the run's frames, numbers {name: number} of those to draw."""
    files = {int(p.stem[9:]): p for p in sorted(args.directory.glob(f"particles{'[0-9]' * 6}.csv"))}
    if not files:
        fail(f"{args.directory}: no particles000000.csv, ... there; try: the OUTPUT of a run")
    first = next((k for k, p in enumerate(files.values()) if p.read_bytes().count(b"\n") > 1), 0)
    numbers, words = list(files), args.frames.split(",")
    known = {"start": numbers[first], "middle": numbers[(first + len(numbers)) // 2],
             "end": numbers[-1], **{str(n): n for n in numbers}}
    if unknown := set(words) - set(known):
        fail(f"--frames: no {', '.join(unknown)}; try: start, middle, end or 0 to {numbers[-1]}")
    return files, {w if w.isalpha() else f"frame{known[w]:06d}": known[w] for w in words}


def main(args):
    """Write the pictures and the animation that the command line asks for."""
    if args.animate == "mp4" and not shutil.which("ffmpeg"):
        fail("--animate mp4: there is no ffmpeg; try: install it, or --animate gif")
    files, stills = find_frames(args)
    movie = list(files)[::args.every or -(-len(files) // MAX_FRAMES)] if args.animate else []
    frames = {n: read_particles(files[n]) for n in sorted({*stills.values(), *movie})}
    elements, seconds = read_scene(args.directory / "scene.ini")
    rows = np.concatenate(list(frames.values()))
    axes = camera(args.view, rows)
    box = bounding_box(axes, elements, list(frames.values()))
    aspect = math.sqrt(np.clip(np.divide(*np.maximum(box[1] - box[0], 1e-30)), 0.4, 2.5))
    best = SIDE * aspect + LEFT + RIGHT, SIDE / aspect + BOTTOM + TOP
    labels = max(np.quantile(rows[:, 4], 0.995), 1e-6) if len(rows) else 1, seconds
    (out := args.out or args.directory).mkdir(parents=True, exist_ok=True)
    size = np.maximum(args.size or best, 300)
    stage = Stage(axes, box, elements, size)
    for name, image in zip(stills, draw_frames(stage, stills.values(), frames, *labels)):
        image.save(out / f"{name}.png")
    if args.animate:
        save, zoom = (save_gif, GIF_SCALE) if args.animate == "gif" else (save_mp4, 1)
        images = draw_frames(Stage(axes, box, elements, zoom * size), movie, frames, *labels)
        save(out / f"animation.{args.animate}", list(images))
    print(f"{out}: {', '.join(stills)}.png{' and animation.' + args.animate if movie else ''}")


if __name__ == "__main__":
    main(parse_arguments())
