#!/usr/bin/env python3
"""Turn the frames that a run wrote into pictures and an animation.

    render.py OUTPUT                      start.png, middle.png and end.png
    render.py OUTPUT --animate            and animation.gif (--animate mp4 needs ffmpeg)
    render.py OUTPUT --frames 0,50,100    frame000000.png, frame000050.png, frame000100.png
    render.py OUTPUT --color R            colours by a column instead of the speed
    render.py OUTPUT --dye x,0,z,0.5      by the side of x = 0 where a grain falls through z = 0.5
    render.py OUTPUT --pattern            balls with sectors, which show how they turn

Options may also stand in the scene file, in a line `# render: OPTIONS`.
View coordinates are x to the right, y up and z to the eye, in samples, FINE of them per pixel.
Rays are parallel, so that a radius in the picture is to scale wherever the particle is.
"""
import argparse
import math
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib import cm, colormaps, colors
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from frames import columns, fail, read_run, read_scene, speed

VIEW = (284, 14)  # azimuth and elevation of the eye [degrees]
LEFT, RIGHT, BOTTOM, TOP, SIDE = 25, 115, 25, 55, 540  # margins around a square scene [pixels]
CREASE = math.cos(math.radians(20))  # edges of the mesh that bend less are not drawn
FINE, DPI, FPS = 2, 100, 12  # samples across a pixel, pixels per inch, frames per second
GIF_SCALE, MAX_FRAMES, CLEAR = 2 / 3, 60, 255  # of --size, of an animation, transparent colour
# Grains at rest are gold, fast ones purple: the middle part of a perceptually uniform scale.
COLORMAP = colors.ListedColormap(colormaps["plasma"](np.linspace(0.88, 0.1, 256)))
TWO = np.float32([[0.96, 0.70, 0.16], [0.13, 0.38, 0.66], [0.72, 0.72, 0.70]])  # dyes, then undyed
MARBLES = np.float32([[0.86, 0.22, 0.20], [0.13, 0.42, 0.76], [0.98, 0.72, 0.12],
                      [0.16, 0.60, 0.36], [0.50, 0.27, 0.65], [0.95, 0.48, 0.13]])
SECTORS, CAP = 6, 0.92  # of a ball with a pattern: around its axis; cosine where the caps begin
STEEL, GLASS = np.float32([0.55, 0.59, 0.65]), (107, 128, 153)
LIGHT, HALFWAY = np.float32([[-0.42, 0.58, 0.70], [-0.23, 0.32, 0.92]])  # HALFWAY: to the eye


@dataclass
class Balls:
    """What is drawn of a frame: centres (N, 3) and radii (N,) [L], quaternions (N, 4), values."""
    x: np.ndarray
    R: np.ndarray
    q: np.ndarray
    value: np.ndarray  # (N,), decides on the colour

    @staticmethod
    def of(frame, value):
        """The balls of a frame, with the value (N,) that colours them."""
        x, q = columns(frame, "x,y,z"), columns(frame, "q0,q1,q2,q3")
        return Balls(*(a.astype(np.float32) for a in (x, frame["R"], q)), np.asarray(value))


def value_of(frame, color):
    """The values (N,) of a column, of the speed [L/T] or of the spin [1/T]."""
    if color == "spin":
        return np.linalg.norm(columns(frame, "wx,wy,wz"), axis=1)
    return speed(frame) if color == "speed" else frame[color]


class Dye:
    """Side of a plane on which grains start or, if a gate is given, fall through that level."""

    def __init__(self, plane, gate=None):
        """plane, gate: (column, level [L])."""
        self.plane, self.gate, self.side = plane, gate, np.zeros(0)

    def value(self, frame):
        """0 below and 1 above the plane, 2 not yet there; (N,) for the next frame in time."""
        self.side = np.append(self.side, np.full(len(frame) - len(self.side), 2.0))
        there = self.side == 2
        if self.gate:
            there &= frame[self.gate[0]] < self.gate[1]
        self.side[there] = frame[self.plane[0]][there] > self.plane[1]
        return self.side.copy()


def camera(view, particles):
    """Of particles (N, 3): unit vectors (3, 3) right, up and to the eye; no view: straight at a plane of particles."""
    flat = np.ptp(particles, axis=0) == 0 if len(particles) else [False] * 3
    straight = [at for at, is_flat in zip([(0, 0), (-90, 0), (-90, 90)], flat) if is_flat]
    a, e = np.radians(view or (straight + [VIEW])[0])
    right = np.array([-np.sin(a), np.cos(a), 0])
    eye = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    return np.array([right, np.cross(eye, right), eye])


def bounding_box(axes, elements, frames):
    """Corners (2, 2) [L] around the mesh, where balls first appear and 98 % of all their places."""
    mesh = np.array([[*point, e.radius] for e in elements for point in e.corners])
    balls = [np.column_stack([balls.x, balls.R]) for balls in frames]
    fresh = np.concatenate([rows[len(before):] for before, rows in zip([[]] + balls, balls)])
    parts = [(rows[:, :3] @ axes[:2].T, rows[:, 3:4], tail) for rows, tail in
             ((mesh, 0), (fresh, 0), (np.concatenate(balls), 0.01)) if len(rows)]
    low = [np.quantile(centre - radius, tail, axis=0) for centre, radius, tail in parts]
    high = [np.quantile(centre + radius, 1 - tail, axis=0) for centre, radius, tail in parts]
    return np.array([np.min(low, axis=0), np.max(high, axis=0)] if parts else [[-1, -1], [1, 1]])


def unit_normal(face):
    """Unit normal (3,) of a triangle or rectangle (3 or 4, 3); zero if it has no area."""
    normal = np.cross(face[1] - face[0], face[-1] - face[0])
    return normal / max(np.linalg.norm(normal), 1e-30)


def outline(faces):
    """Edges of faces, but not the seams within a smooth surface, as a list of Elements."""
    edges = {}
    for face in faces:
        for ends in zip(face.corners, np.roll(face.corners, -1, axis=0)):
            same = edges.setdefault(frozenset(map(tuple, ends)), [])
            same.append((face._replace(corners=np.array(ends)), unit_normal(face.corners)))
    return [same[0][0] for same in edges.values()
            if len(same) != 2 or abs(same[0][1] @ same[1][1]) < CREASE]


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


def body_axes(q):
    """Rotations (N, 3, 3) that take vectors of space into the frame of a particle; q (N, 4)."""
    w, x, y, z = q.T
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
                     [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
                     [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]]
                    ).transpose(2, 0, 1)


def is_light(body):
    """Is a point of a patterned ball white? body (n, 3): unit vectors in the particle's frame."""
    sector = np.floor(SECTORS / 2 / np.pi * np.arctan2(body[:, 1], body[:, 0])).astype(int)
    return (sector % 2 == 0) ^ (body[:, 2] > CAP)


class Stage:
    """The mesh before a camera, drawn once; render() adds the particles of one frame."""

    def __init__(self, axes, box, elements, size):
        """axes (3, 3), box (2, 2) [L], mesh elements, size (width, height) [pixels]."""
        low, high = FINE * np.array([[LEFT, BOTTOM], size - [RIGHT, TOP]])
        self.axes, self.scale = axes, ((high - low) / np.maximum(box[1] - box[0], 1e-30)).min()
        self.turn = self.scale * axes.T  # view coordinates are points @ turn + shift
        self.shift = np.append((low + high) / 2 - self.scale * box.mean(axis=0), 0)
        shape = [2 * FINE * round(n / 2) for n in size[::-1]]  # even, which video needs
        self.depth, self.owner = np.full(shape, -np.inf, np.float32), np.full(shape, -1, np.int32)
        faces = [e for e in elements if len(e.corners) > 2]
        solids = [e for e in elements if len(e.corners) <= 2] + outline(faces)
        ends = np.reshape([e.corners[[0, -1]] for e in solids], (-1, 2, 3))
        self.ends = ends @ self.turn + self.shift
        for k, ((a, b), e) in enumerate(zip(self.ends, solids)):
            radius = e.radius * self.scale  # spheres in a row, too dense to see them
            n = 2 + int(np.linalg.norm(b - a) / max(radius / 8, 1))
            draw_spheres(self.depth, self.owner, np.linspace(a, b, n), np.full(n, radius), [k] * n)
        self.panes = [glass_pane(shape, e.corners @ self.turn + self.shift) for e in faces]

    def render(self, balls, colors, pattern=False):
        """Image, bottom row first, of balls in colors (N, 3) from 0 to 1."""
        depth, owner, solid = self.depth.copy(), self.owner.copy(), len(self.ends)
        centres, radii = balls.x @ self.turn + self.shift, balls.R * self.scale
        draw_spheres(depth, owner, centres, radii, range(solid, solid + len(radii)))
        place = np.nonzero(owner >= 0)
        who = owner[place]
        normal = self.normals(place, depth[place], who, centres)
        light = (0.35 + 0.18 * (1 + normal @ LIGHT)**2) * occlusion(depth, place)
        glint = 0.22 * np.maximum(normal @ HALFWAY, 0)**40
        colors = np.concatenate([np.tile(STEEL, (solid, 1)), colors]).astype(np.float32)[who]
        if pattern:
            ball = who >= solid
            turn = body_axes(balls.q)[who[ball] - solid]
            body = np.einsum("nij,nj->ni", turn, normal[ball] @ self.axes)
            colors[ball] = np.where(is_light(body)[:, None], 0.93, colors[ball])
        image = np.full(depth.shape + (3,), 255, np.uint8)
        image[place] = 255 * np.minimum(colors * light[:, None] + glint[:, None], 1)
        return self.through_glass(image, depth)

    def normals(self, place, depth, who, centres):
        """Unit normals (n, 3) in view coordinates of the samples at place, of bodies `who`."""
        rows, cols = place
        normal = np.column_stack([cols + 0.5, rows + 0.5, depth])
        normal -= np.concatenate([self.ends[:, 0], centres])[who]
        long = np.flatnonzero(who < len(self.ends))  # capsules: their normal starts on an axis
        axis = (self.ends[:, 1] - self.ends[:, 0])[who[long]]
        part = (normal[long] * axis).sum(axis=1) / np.maximum((axis**2).sum(axis=1), 1e-12)
        normal[long] -= np.clip(part, 0, 1)[:, None] * axis
        return (normal / np.linalg.norm(normal, axis=1)[:, None]).astype(np.float32)

    def through_glass(self, image, depth):
        """The image behind the faces of the mesh, reduced from samples to pixels."""
        clear = np.full(depth.shape, 255, np.float32)  # what the panes in front let through
        for pane, z, opacity in self.panes:
            clear[pane] *= np.where(z > depth[pane], np.float32(1 - opacity), np.float32(1))
        image, clear = Image.fromarray(image), Image.fromarray(clear.astype(np.uint8))
        return Image.composite(image, Image.new("RGB", image.size, GLASS), clear).reduce(FINE)


class Painter:
    """Colours of balls, and the bar that explains them."""

    def __init__(self, options, frames):
        """frames: all Balls that are drawn, so that colours mean the same in each of them."""
        self.pattern, self.dyed = options.pattern, bool(options.dye)
        self.label = {"speed": "speed\n(m/s)", "spin": "spin\n(1/s)", "R": "R (m)",
                      **dict.fromkeys(["vx", "vy", "vz"], f"{options.color}\n(m/s)"),
                      **dict.fromkeys(["wx", "wy", "wz"], f"{options.color}\n(1/s)"),
                      **dict.fromkeys("xyz", f"{options.color} (m)")}.get(options.color)
        values = np.concatenate([balls.value for balls in frames]) if frames else np.zeros(0)
        self.few = np.unique(values) if not self.dyed else np.arange(3)
        self.few = self.few if self.dyed or 1 < len(self.few) < 3 else None
        low, high = np.quantile(values, [0.005, 0.995]) if len(values) else (0, 1)
        if options.color in ("speed", "spin"):
            low = 0
        self.scale = cm.ScalarMappable(colors.Normalize(low, max(high, low + 1e-6)), COLORMAP)

    @property
    def has_bar(self):
        """Is there a scale of colours to show?"""
        return self.few is None and not self.pattern

    def colors(self, balls):
        """RGB (N, 3) from 0 to 1."""
        if self.pattern:
            return MARBLES[np.arange(len(balls.R)) % len(MARBLES)]
        if self.few is not None:
            return TWO[np.searchsorted(self.few, balls.value)]
        return self.scale.to_rgba(balls.value)[:, :3]


def draw_frames(stage_at, numbers, frames, painter, interval):
    """RGB images of frames {number: Balls}; stage_at(number) gives the Stage of a frame."""
    stage = stage_at(0)
    h, w = (np.array(stage.depth.shape) / FINE + 0.01) / DPI  # inches, rounded down to pixels
    figure = Figure((w, h), dpi=DPI)
    canvas = FigureCanvasAgg(figure)
    label = figure.text(LEFT / DPI / w, 1 - 0.35 / h, "", size=13)
    if painter.has_bar:
        bar = figure.add_axes([1 - 0.82 / w, 0.25, 0.16 / w, 0.5])
        figure.colorbar(painter.scale, cax=bar, format="%.3g").ax.tick_params(labelsize=11)
        bar.set_title(painter.label, fontsize=11, pad=8)
    picture = figure.figimage(np.zeros((1, 1, 3)), origin="lower", zorder=-1)
    for number in numbers:
        balls = frames[number]
        label.set_text(f"t = {number * interval:.4g} s,  N = {len(balls.R)}")
        image = stage_at(number).render(balls, painter.colors(balls), painter.pattern)
        picture.set_data(np.asarray(image))
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


def numbers(count):
    """A parser of so many numbers, separated by commas (or an x)."""
    return lambda text: tuple(np.array(text.replace("x", ",").split(","), float).reshape(count))


def dye(text):
    """A parser of x,0 or x,0,z,0.5."""
    words = text.split(",")
    pairs = [(name, float(level)) for name, level in zip(words[::2], words[1::2])]
    if len(words) not in (2, 4) or any(name not in ("x", "y", "z") for name, _ in pairs):
        raise ValueError
    return pairs


def parse_arguments(words):
    """The command line after the options of the scene; a mistake ends the program, exit code 2."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("directory", type=Path, metavar="OUTPUT", help="directory that a run wrote")
    add("--frames", default="start,middle,end", metavar="LIST", help="or numbers, like 0,50,100")
    add("--out", type=Path, metavar="DIR", help="where to write, default: OUTPUT")
    add("--animate", nargs="?", const="gif", choices=["gif", "mp4"], help="animate, too")
    add("--every", type=int, metavar="K", help=f"frame to animate, default: {MAX_FRAMES} at most")
    add("--size", type=numbers(2), metavar="WxH", help="of a picture [pixels], 300x300 or more")
    add("--view", type=numbers(2), metavar="A,E",
        help="azimuth and elevation, negative: --view=-76,14")
    add("--color", default="speed", metavar="NAME", help="speed, spin or a column, like R or vz",
        choices=["speed", "spin", "x", "y", "z", "R", "vx", "vy", "vz", "wx", "wy", "wz"])
    add("--dye", type=dye, metavar="AXIS,LEVEL[,AXIS,LEVEL]",
        help="two colours: side of a plane at first, or when falling through the second level")
    add("--pattern", action="store_true", help="balls with sectors, which show their orientation")
    add("--box", type=numbers(6), metavar="X,Y,Z,X,Y,Z", help="two corners of what to show")
    add("--hide", type=lambda t: {int(w) for w in t.split(",")}, default=set(), metavar="GROUPS",
        help="groups of the mesh that are not drawn, like 0,2")
    first = parser.parse_args(words)
    path = first.directory / "scene.ini"
    line = read_scene(path).get("render", "") if path.is_file() else ""
    try:
        return parser.parse_args([*shlex.split(line), *words])
    except ValueError as error:
        return fail(f"{path}: the line # render: has no good options ({error}); try: --view 300,20")


def pick_frames(args, files):
    """Numbers {name: number} of the frames to draw from files {number: path}."""
    first = next((k for k, p in enumerate(files.values()) if p.read_bytes().count(b"\n") > 1), 0)
    known, words = list(files), args.frames.split(",")
    names = {"start": known[first], "middle": known[(first + len(known)) // 2],
             "end": known[-1], **{str(n): n for n in known}}
    if unknown := set(words) - set(names):
        fail(f"--frames: no {', '.join(unknown)}; try: start, middle, end or 0 to {known[-1]}")
    return {w if w.isalpha() else f"frame{names[w]:06d}": names[w] for w in words}


def read_balls(run, wanted, args):
    """{number: Balls} of the wanted frames; a dye follows the grains through all frames."""
    if not args.dye:
        pairs = ((n, run.frame(n)) for n in wanted)
        return {n: Balls.of(frame, value_of(frame, args.color)) for n, frame in pairs}
    stain, balls = Dye(*args.dye), {}
    for n, frame in run.frames():
        value = stain.value(frame)
        if n in wanted:
            balls[n] = Balls.of(frame, value)
    return balls


def main(args):
    """Write the pictures and the animation that the command line asks for."""
    if args.animate == "mp4" and not shutil.which("ffmpeg"):
        fail("--animate mp4: there is no ffmpeg; try: install it, or --animate gif")
    run = read_run(args.directory)
    stills = pick_frames(args, run.files)
    movie = list(run.files)[::args.every or -(-len(run.files) // MAX_FRAMES)] if args.animate else []
    frames = read_balls(run, sorted({*stills.values(), *movie}), args)

    def mesh(number):
        """Elements of a frame that are to be drawn."""
        return [e for e in run.mesh_at(run.time(number)) if e.group not in args.hide]
    axes = camera(args.view, np.concatenate([balls.x for balls in frames.values()]))
    seen = frames if run.scene.get("motion") else [0]
    box = bounding_box(axes, sum((mesh(n) for n in seen), []), list(frames.values()))
    if args.box:
        corners = np.array(args.box).reshape(2, 3)
        eight = np.array(np.meshgrid(*corners.T)).reshape(3, -1).T @ axes[:2].T
        box = np.array([eight.min(axis=0), eight.max(axis=0)])
    aspect = math.sqrt(np.clip(np.divide(*np.maximum(box[1] - box[0], 1e-30)), 0.4, 2.5))
    best = SIDE * aspect + LEFT + RIGHT, SIDE / aspect + BOTTOM + TOP
    size = np.maximum(args.size or best, 300)
    painter = Painter(args, list(frames.values()))

    def draw(names, zoom):
        """Images of frames; a mesh at rest is drawn once."""
        rest = None if run.scene.get("motion") else Stage(axes, box, mesh(0), zoom * size)
        return draw_frames(lambda n: rest or Stage(axes, box, mesh(n), zoom * size), names, frames,
                           painter, run.interval)
    (out := args.out or args.directory).mkdir(parents=True, exist_ok=True)
    for name, image in zip(stills, draw(stills.values(), 1)):
        image.save(out / f"{name}.png")
    if args.animate:
        save, zoom = (save_gif, GIF_SCALE) if args.animate == "gif" else (save_mp4, 1)
        save(out / f"animation.{args.animate}", list(draw(movie, zoom)))
    print(f"{out}: {', '.join(stills)}.png{' and animation.' + args.animate if movie else ''}")


if __name__ == "__main__":
    main(parse_arguments(sys.argv[1:]))
