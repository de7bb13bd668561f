"""Rise of large balls against the amplitude: what is run, what is read off, what is asked."""
from grader.labs import Result, mean_at, power_between

TITLE, LEVEL = "Lab: Brazil nuts", "**"
VARY, VALUES, LEAST = "A", (4, 5, 6.25), 4  # parameter, its values, seeds for each of them
ROW, SCATTERS = "A seed cycles", "cycles"
INSTRUCTOR = range(1, 7)  # seeds of runs.csv
EQUATIONS = {"first_result": "", "second_result": "q = ln(c3/c1)/ln(25/16)"}
TREND = "falls"
FRAMES = {4: 150, 5: 100, 6.25: 70}  # a frame per cycle; the balls are up long before the end


def run(A, seed):
    """The scene and the options of a run; A in mm."""
    return "brazil_nut/scene.ini", ["--motion", f"1 vibrate 0,0,{A / 1000:g} 13.651", "--seed",
                                    str(seed), "--Nmax", "1507", "--Nframes", str(FRAMES[A])]


def read(result):
    """What stands in a row, from result.csv as {quantity: (value, unit)}."""
    return [result["cycles until they were there"][0]]


def levels(rows):
    """What must rise or fall with the parameter."""
    return [mean_at("cycles", "A", A)(rows) for A in VALUES]


RESULTS = {
    "cycles": Result("cycles until a large ball is up, at A = 5 mm", {"cycles": 1, "s": 13.651},
                     (20, 70), mean_at("cycles", "A", 5)),
    "exponent": Result("q in cycles ~ A^q", {"": 1}, (-3.2, -0.8),
                       power_between("cycles", "A", 4, 6.25, 6.25 / 4)),
}
