"""Discharge of a silo against the orifice: what is run, what is read off, what is asked."""
from grader.course import load_module
from grader.labs import Result, mean_at, power_between

TITLE, LEVEL = "Lab: discharge of a silo", "*"
VARY, VALUES, LEAST = "D", (8, 10, 12, 15), 4  # parameter, its values, seeds for each of them
ROW, SCATTERS = "D seed time", "time"
INSTRUCTOR = range(1, 9)  # seeds of runs.csv
EQUATIONS = {"first_result": "T = 1000/W", "second_result": "n = ln(T1/T4)/ln 2"}
TREND = "falls"


def run(D, seed):
    """The scene and the options of a run."""
    return f"silo/{'scene' if D == 10 else f'orifice_{D:g}'}.ini", []


def start(seed, scene):
    """The grains at the start, as CSV text: other radii and places for every seed."""
    make = load_module(scene / "make_mesh.py")
    make.SEED = seed
    return make.csv_text()


def read(result):
    """What stands in a row, from result.csv as {quantity: (value, unit)}: seconds for 1000."""
    return [1000 / next(v for name, (v, _) in result.items() if name.startswith("rate for"))]


def levels(rows):
    """What must rise or fall with the parameter."""
    return [mean_at("time", "D", D)(rows) for D in VALUES]


RESULTS = {
    "time": Result("time for 1000 grains at D = 10 d", {"s": 1, "ms": 1e-3}, (0.6, 1.1),
                   mean_at("time", "D", 10)),
    "exponent": Result("n in 1/time ~ (D - d)^n", {"": 1}, (1.1, 1.9),
                       power_between("time", "D", 15, 8, 2)),
}
