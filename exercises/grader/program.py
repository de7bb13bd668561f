"""Builds an answer, and talks with the program that evaluates it (include/check.hpp)."""
import array
import hashlib
import math
import os
import secrets
import selectors
import shutil
import signal
import struct
import subprocess
import tempfile
import time
from pathlib import Path

FLAGS = ["-std=c++17", "-O1", "-ffp-contract=off"]
WARNINGS = ["-Wall", "-Wextra"]
# A copy of the solver, as a library. Its code for each set of vector instructions takes three times
# as long to compile, and is left out under the address sanitizer.
SOLVER = ["-DTINYDEM_NO_MAIN", "-D__SANITIZE_ADDRESS__", "-Wno-unknown-pragmas"]
SANDBOX = Path(__file__).with_name("sandbox.cpp")
SLICE = 0.05  # seconds between two looks at a silent program
OUTPUT_KEPT = 2000  # characters of what an answer prints


class Lost(Exception):
    """The answer gave no usable numbers; the text says why. late: it used up its time."""

    def __init__(self, text, late=False):
        super().__init__(text)
        self.late = late


# ---------------------------------------------------------------------------------- building

def find_compiler(asked=None):
    """The compiler to use: the one asked for, $CXX, or the first usual one. None: there is none."""
    for name in [asked] if asked else [os.environ.get("CXX"), "c++", "g++", "clang++"]:
        if name and shutil.which(name):
            return name
    return None


def compile_to(output, command, folder):
    """Runs a compiler in `folder`; (succeeded, its messages). Limited to a minute and 2 GiB."""
    limits = "ulimit -t 30; ulimit -v 2097152 2>/dev/null; ulimit -c 0; exec \"$@\""
    try:
        done = subprocess.run(
            ["sh", "-c", limits, "sh", *command, "-o", str(output)], cwd=folder, timeout=60,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env={**os.environ, "LC_ALL": "C", "TMPDIR": str(folder)})
    except subprocess.TimeoutExpired:
        return False, "the compiler took longer than a minute"
    return done.returncode == 0, done.stdout.decode(errors="replace")


def needed_files(rule):
    """The files that a compiler lists in a make rule."""
    return rule.replace("\\\n", " ").split(":", 1)[-1].split()


class Workshop:
    """Compiles answers with one compiler. Files go to `folder`, a new one under `build`."""

    def __init__(self, compiler, build):
        self.compiler, self.build = compiler, Path(build)
        self.build.mkdir(parents=True, exist_ok=True)
        self.folder = Path(tempfile.mkdtemp(prefix="answer-", dir=self.build))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)

    def kept(self, name, sources, options):
        """The result of compiling sources[0] (the rest: its headers), kept for the next answer."""
        kept, said = self.compiled(name, sources, options)
        if not kept:
            raise RuntimeError(f"{sources[0]} does not compile:\n{said}")
        return kept

    def compiled(self, name, sources, options):
        """The same for what may fail; (result or None, messages)."""
        key = hashlib.sha256("\0".join([self.compiler, *FLAGS, *options]).encode())
        for path in sources:
            key.update(path.name.encode() + path.read_bytes())
        kept = self.build / f"{name}-{key.hexdigest()[:16]}"
        messages = kept.with_suffix(".txt")
        if not kept.exists():
            folder = Path(tempfile.mkdtemp(dir=self.folder))
            for path in sources:
                shutil.copy(path, folder)
            fresh = folder / "result"
            ok, said = compile_to(fresh, [self.compiler, *FLAGS, *options, sources[0].name], folder)
            if not ok:
                return None, said
            (folder / "said").write_text(said)
            os.replace(folder / "said", messages)
            os.replace(fresh, kept)
        return kept, messages.read_text()

    def sandbox(self):
        """The program that starts an answer with limits."""
        return self.kept("sandbox", [SANDBOX], [])

    def foreign(self, dependencies, exercise):
        """Files of this project that an answer includes although it must not."""
        top = exercise.folder.parent.resolve()
        files = [(self.folder / name).resolve() for name in needed_files(dependencies)]
        return [f for f in files if top in f.parents and self.folder.resolve() not in f.parents]

    def program(self, exercise, answer):
        """Compiles the answer (a path) and links it; (program or None, messages).

        The answer sees only the headers of the exercise, and its compiler options are ours. The
        checks are compiled apart, so that no macro of the answer reaches them.
        """
        if exercise.kind == "solver":
            return self.solver_program(exercise, answer)
        sources = [exercise.folder / "checks.cpp", *exercise.headers]
        checks = self.kept(exercise.slug, sources, ["-c"])
        for header in exercise.headers:
            shutil.copy(header, self.folder)
        shutil.copyfile(answer, self.folder / "answer.cpp")
        ok, said = compile_to("answer.o", [self.compiler, *FLAGS, *WARNINGS, "-MMD", "-MF",
                                           "answer.d", "-c", "answer.cpp"], self.folder)
        if not ok:
            return None, said
        foreign = self.foreign((self.folder / "answer.d").read_text(errors="replace"), exercise)
        if foreign:
            return None, f"answer.cpp must not include {foreign[0].name}"
        ok, linker = compile_to("program", [self.compiler, "answer.o", str(checks), "-pthread"],
                                self.folder)
        return (self.folder / "program" if ok else None), said + linker

    def solver_program(self, exercise, answer):
        """The same for a folder with a copy of the solver."""
        checks = self.kept(exercise.slug, [exercise.folder / "checks.cpp", *exercise.headers],
                           ["-c"])
        copy = Path(tempfile.mkdtemp(dir=self.folder))
        for name, text in exercise.solver_texts(answer).items():
            (copy / name).write_text(text)
        sources = [exercise.include / "simulate.cpp", copy / "tinydem.cpp", copy / "tinydem.hpp"]
        simulate, said = self.compiled("solver", sources, [*WARNINGS, *SOLVER, "-c"])
        if not simulate:
            return None, said
        program = copy / "program"
        ok, linker = compile_to(program, [self.compiler, str(simulate), str(checks)], copy)
        return (program if ok else None), said + linker


# ----------------------------------------------------------------------------------- running

def how_it_ended(code, limits):
    """Lost, for the exit code of a program that ended in the middle of a question."""
    if code in (-signal.SIGXCPU, -signal.SIGKILL):
        return Lost(f"used more than {limits['cpu']} s of processor time (an endless loop?) and "
                    "was ended", late=True)
    if code == -signal.SIGABRT:
        return Lost(f"was aborted: an exception, a failed assert, or more than {limits['memory']} "
                    "MiB of memory")
    if code < 0:
        return Lost(f"crashed: {signal.strsignal(-code) or 'signal'} "
                    f"({signal.Signals(-code).name})")
    return Lost(f"ended the program itself (exit code {code}) before it gave an answer")


class Starter:
    """Starts Runners of one program, a process each. After an answer has used up its time once,
    the next ones get less of it, so that an answer that always hangs is graded in 10 s."""
    IMPATIENT = {"cpu": 1, "wall": 1.5}

    def __init__(self, sandbox, program, limits):
        self.sandbox, self.program, self.limits = sandbox, program, dict(limits)

    def __call__(self):
        return Runner(self.sandbox, self.program, dict(self.limits))

    def lose_patience(self):
        for name, value in self.IMPATIENT.items():
            self.limits[name] = min(value, self.limits[name])


class Runner:
    """A running program with the functions of an answer, in its own process, with limits.

    limits: {"cpu": seconds, "memory": MiB, "wall": seconds that the grader waits for it in all,
    "threads": number}
    """
    REQUEST, REPLY = struct.Struct("=QQQ40s"), struct.Struct("=QQQQ")

    def __init__(self, sandbox, program, limits):
        self.limits, self.printed, self.waited = limits, b"", 0.0
        ask, self.to = os.pipe()
        self.back, answer = os.pipe()
        self.empty = tempfile.TemporaryDirectory()
        self.process = subprocess.Popen(
            [str(sandbox), str(limits["cpu"]), str(limits["memory"]), str(program), str(ask),
             str(answer)], pass_fds=(ask, answer),
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            cwd=self.empty.name, start_new_session=True,
            env={"LC_ALL": "C", "PATH": "/usr/bin:/bin", "GOMP_SPINCOUNT": "10000",
                 "OMP_NUM_THREADS": str(limits["threads"])})
        os.close(ask), os.close(answer)
        for file in self.to, self.back, self.process.stdout.fileno():
            os.set_blocking(file, False)

    def close(self):
        """Ends the program and whatever it may have started in its group."""
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except (ProcessLookupError, PermissionError):
            pass
        self.process.wait()
        while len(self.printed) < OUTPUT_KEPT and self.keep_output():
            pass
        self.process.stdout.close()
        os.close(self.to), os.close(self.back)
        self.empty.cleanup()

    def ask(self, name, rows):
        """Evaluates function `name` on rows of float; a list of tuples of float."""
        width = len(rows[0]) if rows else 0
        token = secrets.randbits(64)
        numbers = array.array("d", [float(x) for row in rows for x in row])
        request = self.REQUEST.pack(token, len(rows), width, name.encode())
        reply, values = self.exchange(request + numbers.tobytes())
        if reply[0] != token or (reply[1] == 0 and reply[2] != len(rows)):
            raise Lost("sent something that is no answer to the question")
        if reply[1] != 0:
            raise RuntimeError(f"checks.cpp and checks.py disagree about {name}: status {reply[1]}")
        width = reply[3]
        return [tuple(values[k * width:(k + 1) * width]) for k in range(len(rows))]

    def exchange(self, request):
        """Sends bytes, receives one reply: its header and its numbers."""
        got = bytearray()
        with selectors.DefaultSelector() as files:
            files.register(self.to, selectors.EVENT_WRITE)
            files.register(self.back, selectors.EVENT_READ)
            files.register(self.process.stdout, selectors.EVENT_READ)
            while len(got) < self.REPLY.size or len(got) < self.length(got):
                events = self.wait(files)
                for key, _ in events:
                    if key.fileobj == self.to:
                        request = self.write(request)
                        if not request:
                            files.unregister(self.to)
                    elif key.fileobj == self.back:
                        chunk = self.read(self.back)
                        got += chunk
                        if not chunk:
                            raise self.post_mortem()
                    elif not self.keep_output():
                        files.unregister(self.process.stdout)
        header = self.REPLY.unpack(got[:self.REPLY.size])
        values = array.array("d")
        values.frombytes(bytes(got[self.REPLY.size:]))
        return header, values

    def wait(self, files):
        """What is ready to be read or written; Lost when the time of the answer is used up."""
        start = time.monotonic()
        events = files.select(SLICE)
        if events or not self.paused():
            self.waited += min(time.monotonic() - start, 2 * SLICE)
        if self.waited > self.limits["wall"]:
            raise Lost(f"kept the grader waiting for {self.limits['wall']} s (an endless "
                       "loop?) and was ended", late=True)
        return events

    def length(self, got):
        """Bytes of a reply whose header has come; refuses what no exercise asks for."""
        _, _, rows, width = self.REPLY.unpack(got[:self.REPLY.size])
        if rows * width > 10 ** 7:
            raise Lost("sent far too many numbers")
        return self.REPLY.size + 8 * rows * width

    def write(self, request):
        try:
            return request[os.write(self.to, request):]
        except BlockingIOError:
            return request
        except BrokenPipeError:
            raise self.post_mortem() from None

    @staticmethod
    def read(file):
        return os.read(file, 1 << 16)

    def keep_output(self):
        """Takes what the answer prints (stdout and stderr); False if there is no more."""
        try:
            chunk = self.read(self.process.stdout.fileno())
        except BlockingIOError:
            return False
        self.printed = (self.printed + chunk)[:OUTPUT_KEPT]
        return bool(chunk)

    def paused(self):
        """True if somebody has stopped the program for a while."""
        try:
            state = Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()[0]
        except (OSError, IndexError):
            return False
        return state in "Tt"

    def post_mortem(self):
        """Lost: why the program is gone."""
        try:
            code = self.process.wait(self.limits["wall"])
        except subprocess.TimeoutExpired:
            return Lost("closed the connection to the grader")
        return how_it_ended(code, self.limits)


def finite(rows):
    """True if every number is finite."""
    return all(math.isfinite(x) for row in rows for x in row)
