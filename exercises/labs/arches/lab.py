"""Arches in two dimensions against friction: what is run, what is read off, what is asked."""
from grader.labs import Result

TITLE, LEVEL = "Lab: arches in two dimensions", "**"
VARY, VALUES, LEAST = "mu", (0.5, 0.7, 1.0), 8  # parameter, its values, seeds for each of them
ROW, SCATTERS = "mu seed bridged throats aspect arches", "aspect"
INSTRUCTOR = range(1, 15)  # seeds of runs.csv
EQUATIONS = {"first_result": "sum(bridged)/sum(throats)", "second_result": "height / (span/2)"}
TREND = "rises"


def run(mu, seed):
    """The scene and the options of a run."""
    return "jamming/scene.ini", ["--mus", f"{mu:g}", "--mur", f"{mu:g}", "--seed", str(seed),
                                 "--Nmax", "700"]


def read(result):
    """What stands in a row, from result.csv as {quantity: (value, unit)}: throats of 6 diameters,
    and all arches."""
    share, of = result.get("throats of 6 diameters that are bridged", (0.0, "of 0"))
    throats, arches = int(of.split()[1]), 0
    for name, (value, unit) in result.items():
        if name.startswith("throats of"):
            arches += round(value * int(unit.split()[1]))
    aspect = result.get("aspect ratio (height / half span)", (0.0, ""))[0]
    return [round(share * throats), throats, aspect, arches]


def share_at(mu):
    """A function of rows: the share of bridged throats with this friction."""
    def share(rows):
        rows = [r for r in rows if r["mu"] == mu]
        return sum(r["bridged"] for r in rows) / sum(r["throats"] for r in rows)
    return share


def aspect(rows):
    """Mean of all arches of all runs."""
    return sum(r["aspect"] * r["arches"] for r in rows) / sum(r["arches"] for r in rows)


def levels(rows):
    """What must rise or fall with the parameter."""
    return [share_at(mu)(rows) for mu in VALUES]


RESULTS = {
    "share": Result("share of the throats of 6 diameters that are bridged at mu = 1",
                    {"": 1, "%": 0.01}, (0.3, 1), share_at(1.0)),
    "aspect": Result("height over half span of all arches", {"": 1}, (0.4, 1.25), aspect),
}
