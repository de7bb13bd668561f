"""Angle of repose against sliding friction: what is run, what is read off, what is asked."""
from grader.labs import Result, mean_at, power_between

TITLE, LEVEL = "Lab: angle of repose", "*"
VARY, VALUES, LEAST = "mus", (0.1, 0.3, 0.9), 4  # parameter, its values, seeds for each of them
ROW, SCATTERS = "mus seed angle", "angle"
INSTRUCTOR = range(1, 7)  # seeds of runs.csv
EQUATIONS = {"first_result": "Eq. (11)", "second_result": "p = ln(a3/a1)/ln 9"}
TREND = "rises"


def run(mus, seed):
    """The scene and the options of a run."""
    return "heap/scene.ini", ["--mus", f"{mus:g}", "--mur", "0", "--seed", str(seed),
                              "--Nmax", "1200", "--Nframes", "45"]


def read(result):
    """What stands in a row, from result.csv as {quantity: (value, unit)}."""
    return [next(v for name, (v, _) in result.items() if name.startswith("angle of repose"))]


def levels(rows):
    """What must rise or fall with the parameter."""
    return [mean_at("angle", "mus", mus)(rows) for mus in VALUES]


RESULTS = {
    "angle": Result("angle of repose at mus = 0.3", {"deg": 1, "rad": 57.29578}, (11, 22),
                    mean_at("angle", "mus", 0.3)),
    "exponent": Result("p in angle ~ mus^p", {"": 1}, (0.35, 0.9),
                       power_between("angle", "mus", 0.1, 0.9, 9)),
}
