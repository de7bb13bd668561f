"""What the commands in the documentation do when tests/test_docs.py runs them.

Everything is run for real, in a copy of the repository, except for the commands of this file: they
are slow, or change the machine. Each says here what happens instead. A copy of the repository is
the working directory; TINYDEM is a program that has been built, DOCS_LOG a file that gets a line
for every command that was not run as it stands.

    docs_commands.py COMMAND [ARGUMENT ...]
"""
import ast
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

COPY = Path(os.environ["DOCS_COPY"])
ORIGINAL = Path(__file__).resolve().parents[1]
SOLVER = ("tinydem/tinydem.cpp", "tinydem/tinydem.hpp")
#: Runs of the solver are cut to so many frames of so many time steps.
FRAMES, STEPS = 2, 20

#: Verbs of ./dem that are checked, but not run, and why.
NOT_RUN = {
    "setup": "installs packages",
    "build": "the program has been built",
    "demo": "installs packages, runs and draws for half a minute",
    "test": "is what runs this; names of tests are looked up",
    "verify": "takes minutes; names of cases are looked up",
    "bench": "takes ten minutes",
    "grade": "the exercises have tests of their own; numbers are looked up",
    "gradebook": "has a test of its own",
    "lab": "needs a prediction, then runs for minutes; names are looked up",
    "docs": "installs packages, renders for half a minute; has tests of its own",
    "clean": "would only remove build/",
}
#: Other programs that are not run, and why.
MACHINE = {
    "apt": "changes the machine; names of packages are looked up",
    "apt-get": "changes the machine; names of packages are looked up",
    "dnf": "changes the machine; names of packages are looked up",
    "brew": "changes the machine; names of packages are looked up",
    "conda": "changes the machine; names of packages are looked up",
    "cmake": "compiles for minutes; presets and options are looked up",
    "ctest": "is what runs this; presets and names are looked up",
    "git": "needs the network",
    "lmp": "LAMMPS need not be here; files that it reads must",
    "paraview": "has windows",
}


def stop(message):
    """Ends a command of the documentation that would fail for a reader."""
    sys.exit(f"documentation: {message}")


def note(words, why):
    """Writes into the log that a command was not run as it stands."""
    with open(os.environ["DOCS_LOG"], "a") as log:
        log.write(f"{' '.join(words)}: {why}\n".replace(f"{COPY}/", ""))


def fewer(words):
    """The arguments of a run of the solver, cut to a few steps."""
    words, kept = list(words), []
    if "--help" in words or "--version" in words:
        return words
    frames, steps = FRAMES, STEPS
    while words:
        word = words.pop(0)
        name, equals, value = word.partition("=")
        if name not in ("--Nframes", "--Nsteps"):
            kept.append(word)
            continue
        value = int(value if equals else words.pop(0))
        frames = min(frames, value) if name == "--Nframes" else frames
        steps = min(steps, value) if name == "--Nsteps" else steps
    return kept + ["--Nframes", str(frames), "--Nsteps", str(steps)]


def tinydem(words):
    """Runs the solver for a few steps."""
    short = fewer(words)
    if short != words:
        note(["tinydem", *words], f"{FRAMES} frames of {STEPS} steps at most")
    return subprocess.run([os.environ["TINYDEM"], *short]).returncode


def unchanged(source):
    """Is this tinydem.cpp, with tinydem.hpp beside it, both as they are in the repository?"""
    pairs = [(Path(source).with_name(Path(name).name), ORIGINAL / name) for name in SOLVER]
    return Path(source) == pairs[0][0] and all(
        here.is_file() and here.read_text() == there.read_text() for here, there in pairs)


def compiler(name, words):
    """Compiles, but not the unchanged solver again: that is tests/compile_line.sh."""
    real = os.environ["DOCS_REAL_" + name.upper().replace("+", "P")]
    if not real:
        return note([name, *words], "there is no such compiler here") or 0
    sources = [word for word in words if word.endswith(".cpp")]
    for source in sources:
        if not Path(source).is_file():
            stop(f"there is no {source}")
    if len(sources) != 1 or not unchanged(sources[0]):
        slow = [word for word in words if re.fullmatch(r"-O[23s]|-march=\w+", word)]
        if slow:
            note([name, *words], f"without {' '.join(slow)}")
        quick = [word for word in words if word not in slow]
        return subprocess.run([real, "-O0", *quick]).returncode
    note([name, *words], "tests/compile_line.sh compiles this; here only the flags are checked")
    flags = [word for word in words if word.startswith("-") and word != "-o"]
    code = subprocess.run([real, *flags, "-fsyntax-only", "-x", "c++", "/dev/null"]).returncode
    if code == 0 and "-o" in words:
        shutil.copy(COPY.parent / "commands/tinydem", words[words.index("-o") + 1])
    return code


def known_packages():
    """Names of packages that ./dem or docs/dependencies.md know, for any system."""
    table = (ORIGINAL / "dem").read_text().split("<< END\n")[1].split("\nEND")[0]
    listed = (ORIGINAL / "docs/dependencies.md").read_text()
    return set(table.split()) | set(re.findall(r"`([\w.+-]+)`", listed))


def packages(words):
    """Are these packages that we name elsewhere?"""
    actions = {"install", "update", "-y", "-c", "conda-forge", "create", "-n", "sudo",
               "--no-install-recommends"}
    for word in words[1:]:
        if word not in actions and word not in known_packages():
            stop(f"./dem and docs/dependencies.md do not know the package {word}")
    return 0


def presets(words):
    """Do the presets, build trees and options of a cmake or ctest line exist?"""
    names = {preset["name"] for preset in
             json.loads((ORIGINAL / "CMakePresets.json").read_text())["configurePresets"]}
    lists = "".join(path.read_text() for path in
                    [ORIGINAL / "CMakeLists.txt", *ORIGINAL.glob("*/CMakeLists.txt")])
    for k, word in enumerate(words):
        name = word.removeprefix("--preset=") if word.startswith("--preset=") else \
            words[k + 1] if word == "--preset" else ""
        if name and name not in names:
            stop(f"there is no preset {name}")
        option = re.match(r"-D(TINYDEM_\w+)", word)
        if option and not re.search(rf"(option|set)\({option[1]}\b", lists):
            stop(f"there is no option {option[1]}")
        tree = re.match(r"build/(\w+)$", word)
        if tree and tree[1] not in names:
            stop(f"no preset builds in {word}")
        if word == "--target" and not re.search(
                rf"(add_executable|add_custom_target|add_library)\({words[k + 1]}\b", lists) \
                and words[k + 1] not in ("all", "install"):
            stop(f"there is no target {words[k + 1]}")
    return find_tests(words) if words[0] == "ctest" else 0


def find_tests(words):
    """Do -R and -L find a test? Asked of the build tree that TINYDEM is in, if it has all tests."""
    tree = Path(os.environ["TINYDEM"]).parent
    cache = tree / "CMakeCache.txt"
    if not cache.exists() or "TINYDEM_BUILD_VERIFICATION:BOOL=ON" not in cache.read_text():
        return 0
    chosen = [part for k, word in enumerate(words) if word in ("-R", "-L", "-E", "-LE")
              for part in words[k:k + 2]]
    if not chosen:
        return 0
    done = subprocess.run([os.environ["DOCS_REAL_CTEST"], "--test-dir", tree, "-N", *chosen],
                          capture_output=True, text=True)
    if not re.search(r"Total Tests: [1-9]", done.stdout):
        stop(f"no test is called {' '.join(chosen)}")
    return 0


def options_of(program):
    """The options of a Python program, read from its source."""
    tree = ast.parse(program.read_text())
    return {argument.value for call in ast.walk(tree) if isinstance(call, ast.Call)
            and getattr(call.func, "attr", "") == "add_argument"
            for argument in call.args if isinstance(argument, ast.Constant)}


def help_of(verb):
    """The help text of a verb of ./dem."""
    text = "\n".join(line[3:] for line in (ORIGINAL / "dem").read_text().splitlines()
                     if line.startswith("#: "))
    found = re.search(rf"^{verb} .*?(?=^\w|\Z)", text, re.S | re.M)
    return found[0] if found else stop(f"./dem has no verb {verb}")


def scene_of(word):
    """The scene file of a name or path, as ./dem run finds it."""
    for path in (COPY / "tinydem/scenes" / word / "scene.ini", Path(word)):
        if path.is_file():
            return path
    return stop(f"there is no scene {word}")


def run_scene(words):
    """./dem run: the solver for a few steps, without pictures."""
    scene, name = scene_of(words[0]), Path(words[0]).stem
    options, ours = list(words[1:]), {"--full", "--series", "--resume"}
    if "--seeds" in options:
        place = options.index("--seeds")
        if int(options[place + 1]) < 1:
            stop("--seeds must be at least 1")
        del options[place:place + 2]
    if "--full" in options and not scene.with_name("full.ini").is_file():
        stop(f"{name} has no full.ini")
    if "--series" in options and len(list(scene.parent.glob("*.ini"))) < 2:
        stop(f"{name} has no variants")
    options = [word for word in options if word not in ours]
    if "--help" in options or "--version" in options:
        return tinydem(options)
    for path in re.findall(r"^(?:mesh|particles)\s*=\s*(\S+)", scene.read_text(), re.M):
        if not (scene.parent / path).exists() and scene.with_name("make_mesh.py").exists():
            subprocess.run([sys.executable, scene.with_name("make_mesh.py")], check=True)
    out = COPY / "output" / name
    out.parent.mkdir(exist_ok=True)
    return tinydem(["", "", str(out), "--scene", str(scene), "--overwrite", *options])


def dem(words):
    """./dem VERB: see NOT_RUN; `run` runs the solver for a few steps, the rest is run for real."""
    verb = words[0] if words else "help"
    known = help_of(verb)
    if verb == "run":
        return run_scene(words[1:])
    if verb not in NOT_RUN:
        return subprocess.run(["sh", COPY / "dem.real", *words]).returncode
    note(["./dem", *words], NOT_RUN[verb])
    options = set(re.findall(r"--?\w[\w-]*", known))
    program = {"verify": "verification/verify.py", "bench": "verification/bench/bench.py",
               "grade": "exercises/grade.py", "gradebook": "exercises/grade.py",
               "lab": "exercises/grade.py"}.get(verb)
    options |= options_of(ORIGINAL / program) if program else set()
    for word in words[1:]:
        if verb != "test" and word.startswith("-") and word.partition("=")[0] not in options:
            stop(f"./dem {verb} has no option {word}")
    places = {"grade": ("exercises", "exercises/labs"), "verify": ("verification/cases",),
              "lab": ("exercises/labs",)}
    for k, word in enumerate(words[1:]):
        if verb not in places or word.startswith("-") or words[k].startswith("--"):
            continue
        name = word.removeprefix("lab-")
        if not any(list((ORIGINAL / place).glob(f"*{name}*")) for place in places[verb]):
            stop(f"./dem {verb}: there is no {word}")
    return find_tests(words) if verb == "test" else 0


def main():
    """The program; see the top of this file."""
    name, words = sys.argv[1], sys.argv[2:]
    if name == "sudo":
        name, words = words[0], words[1:]
    if name == "dem":
        return dem(words)
    if name == "tinydem":
        return tinydem(words)
    if name in ("g++", "clang++"):
        return compiler(name, words)
    note([name, *words], MACHINE[name])
    if name in ("apt", "apt-get", "dnf", "brew", "conda"):
        return packages([name, *words])
    if name in ("cmake", "ctest"):
        return presets([name, *words])
    for k, word in enumerate(words):
        if word == "-in" and not Path(words[k + 1]).exists():
            stop(f"there is no {words[k + 1]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
