"""The right results of exercise 08."""
import math


def relative_spin(*q):
    """Eqs. (36)-(38). q: n (3 numbers), r_i, r_j, R*, 5 that are not used, w_i (3), w_j (3)."""
    n, ri, rj, Rstar, wi, wj = q[0:3], q[3], q[4], q[5], q[11:14], q[14:17]
    w = [a - b for a, b in zip(wi, wj)]
    r = 1 / (1 / ri + 1 / rj)
    turned = (w[1] * n[2] - w[2] * n[1], w[2] * n[0] - w[0] * n[2], w[0] * n[1] - w[1] * n[0])
    return (*(r * a for a in turned), Rstar * sum(a * b for a, b in zip(w, n)))


def spring(u, v, k, c, limit, dt):
    """One step of a friction mode: force and new spring (lists), scheme `consistent`."""
    u = [a + dt * b for a, b in zip(u, v)]
    trial = [-k * a - c * b for a, b in zip(u, v)]
    size = math.hypot(*trial)
    if size <= limit:
        return trial, u
    force = [limit * a / size for a in trial]
    return force, [-a / k for a in force]


def resisting_torque(*q):
    """Eqs. (32)-(35), (39)-(41), (52)-(55): torque (3 numbers), u_r (3), u_t.

    q: u_r (3 numbers), u_t, n (3), r_i, r_j, R*, f_n, k_n, c_n, k_s, c_s, v_r (3), v_t, mu_s,
    mu_r, dt.
    """
    ur, ut, n, (_, _, Rstar, fn, kn, cn, ks, cs) = q[0:3], q[3], q[4:7], q[7:15]
    vr, vt, mus, mur, dt = q[15:18], *q[18:22]
    up = sum(a * b for a, b in zip(ur, n))
    flat = [a - up * b for a, b in zip(ur, n)]
    short, long = math.hypot(*flat), math.hypot(*ur)
    flat = [a * long / short if short else 0.0 for a in flat]
    fr, ur = spring(flat, vr, kn, cn, mur * abs(fn), dt)
    (ft,), (ut,) = spring([ut], [vt], ks, cs, 2 / 3 * mus * abs(fn), dt)
    torque = (n[1] * fr[2] - n[2] * fr[1], n[2] * fr[0] - n[0] * fr[2], n[0] * fr[1] - n[1] * fr[0])
    return (*(Rstar * (a + ft * b) for a, b in zip(torque, n)), *ur, ut)


def rocking(M, k, c, F, v0, t):
    """Place and velocity at time t of M x'' = F - k x - c x', from x = 0 with v0; underdamped."""
    a, w = c / (2 * M), math.sqrt(k / M - (c / (2 * M)) ** 2)
    rest = F / k
    A, B = -rest, (v0 - a * rest) / w  # x = rest + e^(-a t) (A cos(w t) + B sin(w t))
    fade, cos, sin = math.exp(-a * t), math.cos(w * t), math.sin(w * t)
    return (rest + fade * (A * cos + B * sin),
            fade * ((w * B - a * A) * cos - (w * A + a * B) * sin))
