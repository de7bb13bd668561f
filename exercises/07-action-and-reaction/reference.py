"""The right results of exercise 07, in plain formulas."""
import math


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def both_sides(*n):
    """Moments of the forces about the centres. n: n (3 numbers), r_i, r_j, R*, f_n, f_s, f_r, f_t.

    The contact point is at -r_i n from the centre of i and at +r_j n from that of j.
    """
    normal, (ri, rj, Rstar), fn, fs, fr, ft = n[0:3], n[3:6], n[6:9], n[9:12], n[12:15], n[15]
    f = tuple(a + b for a, b in zip(fn, fs))
    couple = tuple(Rstar * (a + ft * b) for a, b in zip(cross(normal, fr), normal))
    ti = tuple(-ri * a + b for a, b in zip(cross(normal, fs), couple))
    tj = tuple(-rj * a - b for a, b in zip(cross(normal, fs), couple))
    return f + ti + tuple(-a for a in f) + tj


def total(*row):
    """Force and torque on each body. row: bodies; per contact i, j, force and torque on both."""
    sums = [[0.0] * 6 for _ in range(int(row[0]))]
    for k in range(1, len(row), 14):
        for side in 0, 1:
            body, start = int(row[k + side]), k + 2 + 6 * side
            sums[body] = [a + b for a, b in zip(sums[body], row[start:start + 6])]
    return tuple(x for s in sums for x in s)


def power(*n):
    """What the contact forces do per time: f_n v_n + f_s v_s + R*/r f_r v_r + f_t v_t.

    n: the 16 numbers of both_sides, then v_i, w_i, v_j, w_j. Eqs. (26)-(28), (36)-(38).
    """
    normal, (ri, rj, Rstar), fn, fs, fr, ft = n[0:3], n[3:6], n[6:9], n[9:12], n[12:15], n[15]
    vi, wi, vj, wj = n[16:19], n[19:22], n[22:25], n[25:28]
    turning = cross(normal, tuple(ri * a + rj * b for a, b in zip(wi, wj)))
    v = tuple(a - b + c for a, b, c in zip(vi, vj, turning))
    w = tuple(a - b for a, b in zip(wi, wj))
    rolling = cross(w, normal)
    return (math.fsum(a * (b + c) for a, b, c in zip(v, fn, fs))
            + Rstar * math.fsum(a * b for a, b in zip(rolling, fr))
            + Rstar * ft * math.fsum(a * b for a, b in zip(w, normal)))


def spin_ratio(R_i, R_j):
    """Angular acceleration of j over that of i, of spheres that slide on each other: a force F on
    the lever R turns the moment of inertia 8/15 pi rho R^5."""
    return (R_j / R_j ** 5) / (R_i / R_i ** 5)
