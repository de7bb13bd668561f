"""The right results of exercise 06."""
import math


def sliding_force(*q):
    """Eqs. (52), (53), (6), (11), (54), (55) in the order of the scheme `consistent`.

    q: u (3 numbers), n (3), v (3), f_n, k, c, mu, dt. Returns the force and the new spring.
    """
    u, n, v, (fn, k, c, mu, dt) = q[0:3], q[3:6], q[6:9], q[9:14]
    up = sum(a * b for a, b in zip(u, n))
    flat = [a - up * b for a, b in zip(u, n)]
    short, long = math.hypot(*flat), math.hypot(*u)
    spring = [a * long / short + dt * b if short else dt * b for a, b in zip(flat, v)]
    trial = [-k * a - c * b for a, b in zip(spring, v)]
    size, limit = math.hypot(*trial), mu * abs(fn)
    if size <= limit:
        return tuple(trial + spring)
    force = [limit * a / size for a in trial]
    return tuple(force + [-a / k for a in force])


def law(nu, en):
    """k_s/k_n, c_n^2/(m* k_n) and c_s/c_n: Eqs. (12), (13), (18), (21)-(23), (25)."""
    beta = 0.0 if en == 1 else 1 / math.sqrt(1 + (math.pi / math.log(en)) ** 2)
    return 3 * (1 - nu) / (2 - nu), 5 * beta ** 2, math.sqrt((1 - nu) / (10 * (2 - nu)))


def stiffness():
    """k_n/sqrt(delta) in the unit m v^2/R^(5/2), for the impacts of OBLIQUE: Eqs. (12), (14) with
    E* = E/(1 - nu^2) and R* = R at a plate."""
    E, nu, rho, R, v = 1e6, 0.3, 1000, 0.01, 1
    mass = 4 / 3 * math.pi * rho * R ** 3
    return 4 / 3 * E / (1 - nu ** 2) * R ** 3 / (mass * v ** 2)


def duration(vn):
    """Time that an elastic sphere touches the plate, speed vn: 2.943 delta/vn with the deepest
    overlap delta, K delta^(5/2)/2.5 = vn^2/2."""
    return 2.943 * (1.25 * vn ** 2 / stiffness()) ** 0.4 / vn


def rebound(k):
    """Line k of OBLIQUE, with sine and cosine of the angle in place of the angle."""
    en, mu, angle, v, spin = OBLIQUE[int(k)]
    return en, mu, math.sin(math.radians(angle)), math.cos(math.radians(angle)), v, spin


#: Impacts on a plate, integrated by GSL, see oblique.cpp: e_n, mu, angle in degrees, and after the
#: impact v_t and R w, over the speed before it.
OBLIQUE = [
    (0.6, 0.1, 10, 0.110296891, -0.152919050),
    (0.6, 0.1, 40, 0.515273305, -0.309897787),
    (0.6, 0.1, 50, 0.659047237, -0.261011640),
    (0.6, 0.1, 60, 0.782796352, -0.203948885),
    (0.6, 0.1, 70, 0.882760596, -0.140248262),
    (0.6, 0.1, 80, 0.955902607, -0.071648323),
    (0.6, 0.3, 30, 0.315159176, -0.447538734),
    (0.6, 0.3, 40, 0.395172517, -0.600607939),
    (0.6, 0.3, 70, 0.768896548, -0.420744786),
    (0.6, 0.3, 80, 0.898092314, -0.214944969),
    (1, 0.1, 10, 0.112216609, -0.146057793),
    (1, 0.1, 20, 0.198967486, -0.341606890),
    (1, 0.1, 30, 0.327124855, -0.415625744),
    (1, 0.1, 40, 0.489578721, -0.369737085),
    (1, 0.1, 50, 0.637486921, -0.311705888),
    (1, 0.1, 60, 0.766025404, -0.243836110),
    (1, 0.1, 70, 0.871288592, -0.167898342),
    (1, 0.1, 80, 0.950078117, -0.085905512),
    (1, 0.3, 10, 0.163115016, -0.024444570),
    (1, 0.3, 20, 0.261100777, -0.192741241),
    (1, 0.3, 30, 0.316460799, -0.438590606),
    (1, 0.3, 40, 0.378579268, -0.634542799),
    (1, 0.3, 50, 0.455168654, -0.751777651),
    (1, 0.3, 60, 0.567309402, -0.728315965),
    (1, 0.3, 70, 0.734480535, -0.503695025),
    (1, 0.3, 80, 0.880618846, -0.257716537),
]
