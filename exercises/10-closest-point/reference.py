"""The right results of exercise 10, by brute force."""
import functools
import math


@functools.lru_cache(maxsize=4096)
def nearest(corners, *q):
    """Least distance of p to the points of a grid on a shape. q: n, p, a, b, and the last corner.

    corners: 3 or 4; n: the number of intervals along each side.
    """
    n, (x, y, z), a = int(q[0]), q[1:4], q[4:7]
    ab, ac = ([w - v for v, w in zip(a, q[k:k + 3])] for k in (7, 10))
    least = math.inf
    for i in range(n + 1):
        for j in range(n + 1 - i if corners == 3 else n + 1):
            dx = a[0] + i / n * ab[0] + j / n * ac[0] - x
            dy = a[1] + i / n * ab[1] + j / n * ac[1] - y
            dz = a[2] + i / n * ab[2] + j / n * ac[2] - z
            least = min(least, dx * dx + dy * dy + dz * dz)
    return math.sqrt(least)


def on_triangle(*q):
    return nearest(3, *q)


def on_rectangle(*q):
    return nearest(4, *q)
