"""The right results of exercise 02, in plain formulas."""
import math


def damping_factor(en):
    """beta of Eq. (21), solved for: e_n = exp(-pi beta / sqrt(1 - beta^2)) is its inverse."""
    if en == 0:
        return 1.0
    loss = -math.log(en)
    return loss / math.sqrt(math.pi ** 2 + loss ** 2)


def damping(kn, mi, mj, en):
    """c_n of Eqs. (18), (20)."""
    return damping_factor(en) * math.sqrt(5 * kn * mi * mj / (mi + mj))


def normal_force(delta, vn, kn, cn):
    """f_n . n of Eqs. (5), (10)."""
    return kn * delta - cn * vn if delta > 0 else 0.0
