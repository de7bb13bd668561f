"""Exercise 12: the sums, in one thread."""
import math


def sums(threads, order, n, R, Estar, *rest):
    """Three numbers per sphere, for a row of checks.cpp."""
    n = int(n)
    x = [rest[3 * k:3 * k + 3] for k in range(n)]
    pairs = [int(k) for k in rest[3 * n:]]
    total = [[0.0, 0.0, 0.0] for _ in range(n)]
    for i, j in zip(pairs[::2], pairs[1::2]):
        d = [a - b for a, b in zip(x[i], x[j])]
        distance = math.sqrt(sum(c * c for c in d))
        delta = 2 * R - distance
        if delta > 0:
            size = 4 / 3 * Estar * math.sqrt(R / 2 * delta) * delta / distance
            for k in range(3):
                total[i][k] += size * d[k]
                total[j][k] -= size * d[k]
    return tuple(c for f in total for c in f)
