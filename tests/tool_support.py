"""What the tests of the Python tools share: the tools on the path, runs made by hand."""
import contextlib
import io
import subprocess
import sys
from pathlib import Path

TOOLS = Path(__file__).resolve().parents[1] / "tinydem"
sys.path.insert(0, str(TOOLS))

SCENE = "Rmin = 0.01\nRmax = 0.01\nRmesh = 0,0.1\ndt = 0.001\nNsteps = 10\nseed = 3\n"
FLOOR = "OFF\n# a comment\n6 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n" \
        "4 0 1 2 3 0\n3 0 1 4 1\n2 4 5 1\n1 5\n"


def particle(x="0,0,0", R="0.01", v="0,0,0", q="1,0,0,0", w="0,0,0"):
    """A line of a particle file."""
    return f"{x},{R},{v},{q},{w}\n"


def write_run(folder, frames, scene=SCENE, mesh=None):
    """A run made by hand: frames is a list of texts of particle lines."""
    import frames as reader
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene.ini").write_text(scene + ("mesh = mesh.off\n" if mesh else ""))
    if mesh:
        (folder / "mesh.off").write_text(mesh)
    for number, text in enumerate(frames):
        (folder / f"particles{number:06d}.csv").write_text(reader.HEADER + "\n" + text)
    return folder


def message_of(test, function, *args):
    """What a call that must end with exit code 2 says on the standard error."""
    text = io.StringIO()
    with contextlib.redirect_stderr(text), test.assertRaises(SystemExit) as end:
        function(*args)
    test.assertEqual(end.exception.code, 2)
    return text.getvalue()


def run_tool(*words):
    """A tool as a program of its own: (exit code, output, errors)."""
    done = subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr
