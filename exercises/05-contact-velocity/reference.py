"""The right results of exercise 05: velocities of material points, with plain numbers."""
import math


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def contact_velocity(*q):
    """r_i, r_j, v_n, v_s. q: x (3 numbers), R, v (3), w (3) of i, then of j.

    The point of i at the contact is -r_i n away from its centre and moves with v_i - w_i x r_i n;
    the point of j moves with v_j + w_j x r_j n.
    """
    xi, Ri, vi, wi = q[0:3], q[3], q[4:7], q[7:10]
    xj, Rj, vj, wj = q[10:13], q[13], q[14:17], q[17:20]
    distance = math.dist(xi, xj)
    n = [(a - b) / distance for a, b in zip(xi, xj)]
    ri, rj = (distance + Ri - Rj) / 2, (distance + Rj - Ri) / 2
    at_i = [a - ri * b for a, b in zip(vi, cross(wi, n))]
    at_j = [a + rj * b for a, b in zip(vj, cross(wj, n))]
    v = [a - b for a, b in zip(at_i, at_j)]
    vn = sum(a * b for a, b in zip(v, n))
    return (ri, rj, vn) + tuple(a - vn * b for a, b in zip(v, n))


def arms(*q):
    """r_i, r_j."""
    return contact_velocity(*q)[:2]
