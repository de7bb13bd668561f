"""The right results of exercise 09: quaternions as complex 2 x 2 matrices, rotations as 3 x 3."""
import math


def matrix(q):
    """s - i (v . sigma): the product of these matrices is that of the quaternions."""
    s, x, y, z = q
    return ((complex(s, -z), complex(-y, -x)), (complex(y, -x), complex(s, z)))


def times(a, b):
    return tuple(tuple(sum(a[i][k] * b[k][j] for k in (0, 1)) for j in (0, 1)) for i in (0, 1))


def quaternion(m):
    return m[0][0].real, -m[0][1].imag, m[1][0].real, -m[0][0].imag


def product(*n):
    """p q; n: the 8 numbers of p and q."""
    return quaternion(times(matrix(n[0:4]), matrix(n[4:8])))


def rotated(s, x, y, z, *a):
    """The rotation matrix of a unit quaternion times a."""
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - s * z), 2 * (x * z + s * y)),
            (2 * (x * y + s * z), 1 - 2 * (x * x + z * z), 2 * (y * z - s * x)),
            (2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)))
    return tuple(sum(r * b for r, b in zip(row, a)) for row in rows)


def rotation(h):
    """The quaternion (cos |h|, sin |h| h/|h|)."""
    angle = math.sqrt(sum(c * c for c in h))
    share = math.sin(angle) / angle if angle > 0 else 1.0
    return (math.cos(angle), *(share * c for c in h))


def turned(*n):
    """Eqs. (47), (48), with the factors on the left; n: q, w, alpha, dt."""
    q, w, alpha, dt = n[0:4], n[4:7], n[7:10], n[10]
    phi, theta = rotation([dt / 2 * c for c in w]), rotation([dt * dt / 4 * c for c in alpha])
    return product(*theta, *product(*phi, *q))


def spin(wx, wy, wz, t):
    """Orientation after a time t with a constant angular velocity, from (1, 0)."""
    return rotation([t / 2 * c for c in (wx, wy, wz)])


def tumble(*n):
    """Orientation at the time T, from (1, 0), with w(t) = w + t alpha; n: w, alpha, T.

    q' = w q / 2 with the classical method of Runge and Kutta, error below 1e-9.
    """
    w, alpha, T = n[0:3], n[3:6], n[6]
    steps = 200
    h, q = T / steps, (1.0, 0.0, 0.0, 0.0)

    def rate(t, q):
        return product(0.0, *(0.5 * (a + t * b) for a, b in zip(w, alpha)), *q)

    def moved(s, by):
        return tuple(a + s * b for a, b in zip(q, by))

    for k in range(steps):
        t = k * h
        a = rate(t, q)
        b = rate(t + h / 2, moved(h / 2, a))
        c = rate(t + h / 2, moved(h / 2, b))
        d = rate(t + h, moved(h, c))
        q = moved(h / 6, tuple(p + 2 * u + 2 * v + r for p, u, v, r in zip(a, b, c, d)))
    return q
