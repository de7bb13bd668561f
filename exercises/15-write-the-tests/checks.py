"""Exercise 15: write the tests."""
import math
from pathlib import Path

from grader.course import PUBLIC_SEEDS, Lost, check, load_module

TITLE, LEVEL, KIND = "Capstone: write the tests", "***", "tests"
#: number of a solver -> tests, those that fail, expectations, and what the first one said
FUNCTIONS = {"run_tests": ("solver", "")}
LIMITS = {"cpu": 8, "wall": 20}

HERE = Path(__file__).resolve().parent
LIST = load_module(HERE / "solvers.py")
#: All replacements; the solver number k is the one with the change k - 1. Number 0 is right.
CHANGES = [change for changes in LIST.BROKEN.values() for change in changes] + LIST.RIGHT
if (HERE / "hidden.py").exists():
    HIDDEN = load_module(HERE / "hidden.py").HIDDEN
    CHANGES += [HIDDEN[name] for name in LIST.BROKEN]
NAMES = list(LIST.BROKEN)
FIRST_RIGHT = len(NAMES) + 1
RIGHT = [0, *range(FIRST_RIGHT, FIRST_RIGHT + len(LIST.RIGHT))]


def broken(ask, name):
    """The number of a broken solver: another one for seeds that are not public."""
    k = 1 + NAMES.index(name)
    return k if ask.seed in PUBLIC_SEEDS or RIGHT[-1] == len(CHANGES) else RIGHT[-1] + k


def run(ask, solver, unchanged=False):
    """(tests, those that fail, what the first of them says). A crash is a failure."""
    try:
        call = ask.right if unchanged else ask.call
        n, failed, expected, *said = call("run_tests", [(float(solver),)], any_value=True)[0]
    except Lost as problem:
        if problem.late:
            raise
        return 0, 1, str(problem)
    return int(n), int(failed), "".join(map(chr, map(int, said)))


def nothing_found(ask, names=NAMES):
    """True if no broken solver is noticed: these tests have not begun."""
    return all(run(ask, broken(ask, name))[1] == 0 for name in names)


@check("contract", 10, "", sharp=True,
       cause="an expected value or a tolerance; or nothing is tested yet")
def right_solver(ask):
    """Five tests or more, each of which expects something, pass with the solver as it is"""
    n, failed, said = run(ask, 0, unchanged=True)
    if failed:
        return ask.outcome(math.inf, f"{failed} of {n} fail: {said}", "all pass")
    if n < 5 or nothing_found(ask):
        return ask.outcome(math.inf, f"{n} tests, and no broken solver is noticed" if n >= 5
                           else f"{n} tests", "five or more, that find something")
    return ask.outcome(0)


def notices(name, category, points, eq, what):
    """Makes the check whether the tests fail with a broken solver and pass with the right one."""
    def evaluate(ask):
        once, again = ([0, broken(ask, name)] for _ in range(2))
        ask.random.shuffle(once), ask.random.shuffle(again)
        for solver in once + again:
            n, failed, said = run(ask, solver)
            if failed and not solver:
                return ask.outcome(math.inf, f"with the right solver: {said}", "all pass")
            if not failed and solver:
                return ask.outcome(math.inf, f"all {n} tests pass", "a test that fails")
        return ask.outcome(0)
    evaluate.__name__, evaluate.__doc__ = name, f"A test fails when {what}"
    globals()[name] = check(category, points, eq, sharp=True, cause="no test measures this, or its "
                            "tolerance is too wide; which result changes most?")(evaluate)


notices("contact_radius", "pointwise", 5, "Eq. (14)", "the radius of the contact is wrong")
notices("elastic_modulus", "pointwise", 5, "Eq. (15)", "E* is wrong")
notices("effective_radius", "pointwise", 5, "Eq. (17)", "R* is wrong, if the radii differ")
notices("stiffness_of_walls", "pointwise", 5, "Eqs. (22), (23)", "a wall has another stiffness")
notices("damping", "pointwise", 5, "Eq. (18)", "c_n has a wrong factor")
notices("tangential_stiffness", "pointwise", 5, "Eq. (13)", "k_s has a wrong factor")
notices("sliding_limit", "pointwise", 5, "Eq. (11)", "the limit of sliding friction is wrong")
notices("spring_in_slip", "invariants", 5, "Eq. (55)", "the spring of a slipping contact is wrong")
notices("contact_velocity", "invariants", 5, "Eq. (26)", "the spins enter the contact velocity wrongly")
notices("torque_on_the_other", "invariants", 5, "Eq. (60)", "the torque on j has a wrong lever arm")
notices("rolling_velocity", "invariants", 5, "Eq. (38)", "rolling takes a wrong difference of spins")
notices("rolling_limit", "invariants", 5, "Eq. (39)", "the limit of rolling friction is wrong")
notices("motion", "convergence", 5, "Eq. (45)", "the position advances by a wrong velocity")
notices("drag", "convergence", 5, "Eq. (3)", "Stokes drag is wrong")
notices("orientation", "convergence", 5, "Eqs. (47), (48)", "the orientation turns wrongly")


@check("clean", 10, "", sharp=True,
       cause="a tolerance without room for rounding, a value copied from one run, or a static "
             "variable")
def other_roundings(ask):
    """The tests pass with right solvers whose last digits differ, however often they run"""
    for solver in RIGHT * 4:
        n, failed, said = run(ask, solver)
        if failed:
            return ask.outcome(math.inf, f"{failed} of {n} fail: {said}", "all pass",
                               "a solver that is right, but rounds differently" if solver else
                               "the right solver, after some other runs")
    return ask.outcome(math.inf if nothing_found(ask) else 0, "no broken solver is noticed",
                       "tests that find something")
