"""Exercise 10: the closest point of a point, an edge, a triangle, a rectangle."""
import math

from grader.course import check, number
from grader.vec import add, cross, dot, norm, scale, sub

TITLE = "The closest point"
LEVEL = "**"
P, A, B, C, D = ("p_x p_y p_z", *(f"{c}_x {c}_y {c}_z" for c in "abcd"))
#: Functions of the answer: names of the numbers that go in and that come out.
FUNCTIONS = {"closest_on_edge": (" ".join((P, A, B)), "q_x q_y q_z"),
             "closest_on_triangle": (" ".join((P, A, B, C)), "q_x q_y q_z"),
             "closest_on_rectangle": (" ".join((P, A, B, C, D)), "q_x q_y q_z")}
LIMITS = {"cpu": 1}  # a right answer needs 0.01 s
NAME = {2: "closest_on_edge", 3: "closest_on_triangle", 4: "closest_on_rectangle"}  # by corners


# ------------------------------------------------------------------------------------- shapes

def frame(ask):
    """Three unit vectors, all perpendicular."""
    n = ask.direction()
    t = unit(across(ask, n))
    return n, t, cross(n, t)


def across(ask, e):
    """A vector perpendicular to the unit vector e, not too short."""
    while True:
        v = cross(e, ask.direction())
        if norm(v) > 0.3:
            return v


def edge(ask):
    a = scale(3 * ask.uniform(0, 1), ask.direction())
    return [a, add(a, scale(ask.uniform(0.5, 2), ask.direction()))]


def triangle(ask, flat=None):
    """Corners of a triangle; flat: height over its base, with the foot anywhere, also outside."""
    _, x, y = frame(ask)
    a, length = scale(3 * ask.uniform(0, 1), ask.direction()), ask.uniform(0.5, 2)
    foot, height = ask.uniform(-1, 2), flat or ask.uniform(0.2, 1)
    corners = [a, add(a, scale(length, x)),
               add(a, add(scale(foot * length, x), scale(height * length, y)))]
    k = ask.random.randrange(3)
    return corners[k:] + corners[:k]


def rectangle(ask):
    _, x, y = frame(ask)
    a = scale(3 * ask.uniform(0, 1), ask.direction())
    x, y = scale(ask.uniform(0.5, 2), x), scale(ask.uniform(0.5, 2), y)
    return [a, add(a, x), add(add(a, x), y), add(a, y)]


SHAPE = {2: edge, 3: triangle, 4: rectangle}


def unit(v):
    return scale(1 / norm(v), v)


def between(a, b, s):
    return add(a, scale(s, sub(b, a)))


def anywhere(ask, corners):
    """A point around a shape."""
    middle = scale(1 / len(corners), tuple(map(sum, zip(*corners))))
    return add(middle, scale(ask.uniform(0.2, 2), ask.direction()))


def inside(ask, corners):
    """A point of a shape, not at its border."""
    s, t = ask.uniform(0.1, 0.8), ask.uniform(0.1, 0.9)
    if len(corners) == 2:
        return between(*corners, t)
    a, b, last = corners[0], corners[1], corners[-1]
    t = t if len(corners) == 4 else t * (0.95 - s)
    return add(between(a, b, s), scale(t, sub(last, a)))


def row(p, corners):
    return (*p, *(x for c in corners for x in c))


def size_of(corners):
    return max(norm(sub(a, b)) for a in corners for b in corners)


# ------------------------------------------------- points whose closest point is known beforehand

def seen_from(ask, q, directions, n):
    """A point that is q plus positive amounts of `directions`, and any amount of n."""
    p = add(q, scale(ask.sign() * ask.uniform(0.1, 1), n))
    for d in directions:
        p = add(p, scale(ask.uniform(0.1, 1), d))
    return p


def regions_of_triangle(ask, corners):
    """(region, p, q): the seven regions of space, in each a point p whose closest point is q."""
    n = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])))
    outwards = [unit(cross(sub(corners[(k + 1) % 3], corners[k]), n)) for k in range(3)]
    found = [("the face", inside(ask, corners), [])]
    for k, name in enumerate(("ab", "bc", "ca")):
        q = between(corners[k], corners[(k + 1) % 3], ask.uniform(0.1, 0.9))
        found.append((f"edge {name}", q, [outwards[k]]))
    for k, name in enumerate("abc"):
        found.append((f"corner {name}", corners[k], [outwards[k], outwards[k - 1]]))
    return [(name, seen_from(ask, q, directions, n), q) for name, q, directions in found]


def regions_of_rectangle(ask, corners):
    """The same for the nine regions of a rectangle."""
    a, b, _, d = corners
    x, y = sub(b, a), sub(d, a)
    n, found = unit(cross(x, y)), []
    for i, side in enumerate(("beyond ad", "", "beyond bc")):
        for j, other in enumerate(("beyond ab", "", "beyond dc")):
            s, t = ((0.0, ask.uniform(0.1, 0.9), 1.0)[k] for k in (i, j))
            directions = [scale(k - 1, unit(v)) for k, v in ((i, x), (j, y)) if k != 1]
            name = " and ".join(filter(None, (side, other))) or "over the face"
            q = add(a, add(scale(s, x), scale(t, y)))
            found.append((name, seen_from(ask, q, directions, n), q))
    return found


def known(ask, corners, triples):
    """Outcomes: what the answer gives for (region, p, q)."""
    name = NAME[len(corners)]
    rows = [row(p, corners) for _, p, _ in triples]
    return [ask.outcome(norm(sub(got, q)) / max(size_of(corners), norm(sub(p, q))), number(got),
                        number(q), f"{region}: {ask.inputs(name, r)}")
            for (region, p, q), r, got in zip(triples, rows, ask.call(name, rows))]


# ------------------------------------------------------------------------------------- checks

def dyadic(ask):
    """A vector of small whole numbers over 8: all products and sums of a few are exact."""
    while True:
        v = tuple(ask.random.randrange(-8, 9) / 8 for _ in range(3))
        if norm(v) > 0.5:
            return v


@check("contract", 10, "Fig. 4", tol=1e-12, sharp=True,
       cause="a division by a length or an area that is zero; a shape without area is as good as "
             "its edges")
def degenerate(ask):
    """Edges of length 0, triangles whose corners lie on a line or coincide, flat rectangles"""
    outcomes = []
    for _ in range(6):
        a, e = dyadic(ask), dyadic(ask)
        far, q = add(a, scale(4, e)), add(a, scale(ask.uniform(0.1, 3.9), e))
        n = across(ask, unit(e))
        p, beyond = add(q, n), add(sub(a, scale(ask.uniform(0.1, 1), e)), scale(0.5, n))
        point = [("a point", p, a)]
        line = [("as on an edge", p, q), ("as on an edge", beyond, a)]
        third = add(a, scale(ask.random.choice((0, 1, 2, 3, 4)), e))
        for corners in [a, far, third], [third, a, far], [far, third, a]:
            outcomes += known(ask, corners, line)
        for corners in [a, a, far, far], [a, far, far, a]:
            outcomes += known(ask, corners, line)
        for count in 2, 3, 4:
            outcomes += known(ask, [a] * count, point)
    return outcomes


# Tolerances: rounding errors, 1e-14 for triangles as flat as these.
@check("pointwise", 8, "Fig. 4B", tol=1e-12,
       cause="not beyond the ends: the share of the edge lies between 0 and 1")
def on_edge(ask):
    """Points beyond both ends of an edge, and beside it"""
    outcomes = []
    for _ in range(12):
        a, b = corners = edge(ask)
        e = unit(sub(b, a))
        n = unit(cross(e, across(ask, e)))
        outcomes += known(ask, corners, [("end a", seen_from(ask, a, [scale(-1, e)], n), a),
                                         ("end b", seen_from(ask, b, [e], n), b)])
        q = between(a, b, ask.uniform(0.1, 0.9))
        outcomes += known(ask, corners, [("beside it", seen_from(ask, q, [], n), q)])
    return outcomes


@check("pointwise", 15, "Fig. 4C", tol=1e-12,
       cause="inside for all three edges: the foot on the plane; else the best of three edges. At "
             "an obtuse angle p may be outside of one edge and yet closest to another")
def regions(ask):
    """The seven regions of a triangle: face, edges, corners; obtuse triangles as well"""
    outcomes = []
    for k in range(16):
        corners = triangle(ask, ask.uniform(0.15, 0.4) if k % 2 else None)
        outcomes += known(ask, corners, regions_of_triangle(ask, corners))
    return outcomes


@check("pointwise", 12, "Fig. 4D", tol=1e-12,
       cause="along each of the two sides the share lies between 0 and 1, whatever it is along the "
             "other")
def on_rectangle(ask):
    """The nine regions of a rectangle"""
    outcomes = []
    for _ in range(10):
        corners = rectangle(ask)
        outcomes += known(ask, corners, regions_of_rectangle(ask, corners))
    return outcomes


def area(a, b, c):
    return norm(cross(sub(b, a), sub(c, a))) / 2


def excess(q, corners):
    """How much longer are the ways, or larger the areas, from q to a shape than the shape itself?
    0 if q is on the shape; relative."""
    if len(corners) == 2:
        a, b = corners
        return (norm(sub(q, a)) + norm(sub(q, b))) / norm(sub(a, b)) - 1
    parts = sum(area(q, a, b) for a, b in zip(corners, corners[1:] + corners[:1]))
    return parts / (area(*corners[:3]) * (len(corners) - 2)) - 1


@check("invariants", 8, "the definition", tol=1e-10,
       cause="the point is not on the shape, or another one of the shape is closer")
def nothing_closer(ask):
    """The answer is a point of the shape, and no point of the shape is closer"""
    outcomes = []
    for count in 2, 3, 4:
        for _ in range(100 if count == 3 else 20):
            corners = SHAPE[count](ask)
            p = anywhere(ask, corners)
            r = row(p, corners)
            q = ask.call(NAME[count], [r])[0]
            outcomes.append(ask.outcome(abs(excess(q, corners)), f"{number(q)}, not on the shape",
                                        "a point of the shape", ask.inputs(NAME[count], r)))
            others = corners + [inside(ask, corners) for _ in range(30)] + [
                between(a, b, k / 12) for a, b in zip(corners, corners[1:] + corners[:1])
                for k in range(1, 12)]
            best = min(others, key=lambda o: norm(sub(o, p)))
            here, there = norm(sub(q, p)), norm(sub(best, p))
            outcomes.append(ask.outcome(max(0.0, 1 - there / here) if here else 0.0,
                                        f"{number(q)} at a distance of {here:.6g} m",
                                        f"{number(best)} is closer: {there:.6g} m",
                                        ask.inputs(NAME[count], r)))
    return outcomes


def moved_along(ask, change, text):
    """Outcomes: shapes and points before and after `change` of (p, corners), which also returns
    the function that moves the answer."""
    outcomes = []
    for count in 2, 3, 4:
        shapes = [SHAPE[count](ask) for _ in range(40)]
        before = [(anywhere(ask, s), s) for s in shapes]
        after = [change(*b) for b in before]
        rows, new = [row(*b) for b in before], [row(p, s) for p, s, _ in after]
        answers = ask.call(NAME[count], rows)
        if all(q == answers[0] for q in answers):
            return ask.outcome(math.inf, f"always {number(answers[0])}", "answers that differ")
        for r, q, now, (_, s, move) in zip(new, answers, ask.call(NAME[count], new), after):
            outcomes.append(ask.outcome(norm(sub(now, move(q))) / size_of(s), number(now),
                                        f"{number(move(q))}{text}", ask.inputs(NAME[count], r)))
    return outcomes


@check("invariants", 6, "rigid motion", tol=1e-12,
       cause="a coordinate axis has a part in it, or the sign of a normal; both sides of a face "
             "are alike")
def motion(ask):
    """Move, turn and mirror point and shape together: the answer goes with them"""
    def change(p, corners):
        axes, by = frame(ask), scale(ask.uniform(0.5, 2), ask.direction())
        signs = [ask.sign() for _ in axes]

        def move(x):
            return add(by, tuple(s * dot(a, x) for s, a in zip(signs, axes)))
        return move(p), [move(c) for c in corners], move
    return moved_along(ask, change, ", as before")


@check("invariants", 6, "names exchanged", tol=1e-12,
       cause="an edge that is forgotten, or treated in another way than the other ones")
def names(ask):
    """Begin with another corner, or go round the other way: the same point"""
    def change(p, corners):
        k = ask.random.randrange(len(corners))
        corners = corners[k:] + corners[:k]
        return p, corners[::-1] if ask.random.random() < 0.5 else corners, lambda q: q
    return moved_along(ask, change, ", as with the other order of the corners")


@check("invariants", 5, "a point of the shape is its own closest point", tol=1e-12,
       cause="the result is the point on the shape, not the vector that leads there")
def own_point(ask):
    """Corners, points of the edges, and points inside: each is its own closest point"""
    outcomes = []
    for count in 2, 3, 4:
        for _ in range(8):
            corners = SHAPE[count](ask)
            points = list(corners) + [inside(ask, corners)] + [
                between(a, b, ask.uniform(0, 1)) for a, b in zip(corners, corners[1:])]
            outcomes += known(ask, corners, [("the point itself", p, p) for p in points])
    return outcomes


@check("convergence", 15, "0 <= d_n - d <= sqrt(d^2 + (L/n)^2) - d, about L^2/(2 d n^2)", tol=1e-12,
       sharp=True, cause="the answer is not on the shape, or some points of the shape are closer")
def brute_force(ask):
    """The least distance d_n to n x n points of the shape comes down to the answer's, like 1/n^2"""
    cases = []
    for count, number_of in (3, 40), (4, 15):
        for _ in range(number_of):
            corners = SHAPE[count](ask)
            cases.append((corners, anywhere(ask, corners)))
    mine = [norm(sub(ask.call(NAME[len(c)], [row(p, c)])[0], p)) for c, p in cases]
    outcomes = []
    for n in 8, 16, 32:
        grid = []
        for count, name in (3, "on_triangle"), (4, "on_rectangle"):
            grid += ask.reference(name, [(float(n), *p, *c[0], *c[1], *c[-1])
                                         for c, p in cases if len(c) == count])
        for (corners, p), d, (least,) in zip(cases, mine, grid):
            # A point of the grid is within L/n of the closest point, across the shortest way to p.
            most = math.sqrt(d * d + (size_of(corners) / n) ** 2)
            outcomes.append(ask.outcome(
                max(d - least, least - most, 0.0), f"a distance of {d:.8g} m",
                f"{least:.8g} m, up to {most - d:.2g} m less",
                f"{n} x {n} points; {ask.inputs(NAME[len(corners)], row(p, corners))}"))
    return outcomes


@check("clean", 10, "functions of their arguments alone", sharp=True)
def no_memory(ask):
    """The same arguments give the same bits: in any order, once or often, in a new process"""
    outcomes = []
    for count in 2, 3, 4:
        shapes = [SHAPE[count](ask) for _ in range(20)]
        outcomes.append(ask.same_bits(NAME[count], [row(anywhere(ask, s), s) for s in shapes]))
    return outcomes
