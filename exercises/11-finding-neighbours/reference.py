"""The right results of exercise 11."""
import functools
import math


def cell_of(x, y, z, size):
    return tuple(float(math.floor(a / size)) for a in (x, y, z))


def spheres(numbers):
    """x, y, z, R of all spheres as a list of tuples."""
    return [numbers[k:k + 4] for k in range(0, len(numbers), 4)]


def touch(a, b):
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2 < (a[3] + b[3]) ** 2


def touching_pairs(*numbers):
    """i, j of all pairs that touch, i < j: everybody against everybody."""
    s = spheres(numbers)
    return tuple(float(n) for j in range(len(s)) for i in range(j) if touch(s[i], s[j])
                 for n in (i, j))


def summary(*numbers):
    """The number of pairs and the sum of (i + 1)(j + 1): spheres sorted along x, for many."""
    return summary_of(numbers)


@functools.lru_cache(maxsize=64)
def summary_of(numbers):
    s = spheres(numbers)
    order = sorted(range(len(s)), key=lambda i: s[i][0])
    reach, count, total = 2 * max(a[3] for a in s), 0, 0
    for k, i in enumerate(order):
        a = s[i]
        for j in order[k + 1:]:
            b = s[j]
            if b[0] - a[0] >= reach:
                break
            if touch(a, b):
                count, total = count + 1, total + (i + 1) * (j + 1)
    return float(count), float(total)
