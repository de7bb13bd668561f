"""The right results of exercise 04."""
import math

HERTZ = 0.8 * math.sqrt(math.pi) * math.gamma(0.4) / math.gamma(0.9)


def default_step(E, nu, rho, small, large):
    """Eq. (50)."""
    return small * math.sqrt(rho * (1 - nu ** 2) / E)


def hertz(E, nu, rho, R):
    """Force / (m* delta^(3/2)) of two equal spheres: 4/3 E* sqrt(R*) / m*."""
    return 4 / 3 * E / (2 * (1 - nu ** 2)) * math.sqrt(R / 2) / (2 / 3 * math.pi * rho * R ** 3)


def contact_time(E, nu, rho, R, v):
    """From the energy: v^2/2 = 2/5 K delta^(5/2)."""
    return HERTZ * (1.25 * v ** 2 / hertz(E, nu, rho, R)) ** 0.4 / v


def speed(E, nu, rho, R, indentation):
    """Relative speed of an impact whose deepest overlap is `indentation` x 2 R*, and R* = R/2."""
    return math.sqrt(0.8 * hertz(E, nu, rho, R) * (indentation * R) ** 2.5)


def restitution(en, steps, phase):
    """The model impact m* = k_n/sqrt(delta) = v = 1, with semi-implicit Euler."""
    damping = 0.0 if en == 1 else math.sqrt(5 / (1 + (math.pi / math.log(en)) ** 2))
    dt, rate = HERTZ * 1.25 ** 0.4 / steps, 1.0
    delta = phase * dt
    while delta > 0:
        rate -= dt * (delta ** 1.5 + damping * delta ** 0.25 * rate)
        delta += dt * rate
    return -rate


def rms_error(en, steps):
    """Root of the mean square of the error over 16 phases."""
    return math.sqrt(sum((restitution(en, steps, k / 16) - en) ** 2 for k in range(1, 17)) / 16)


def fewest_steps(en, error):
    """The first of 4, 5, 6, ... that is good enough."""
    steps = 4
    while rms_error(en, steps) > error:
        steps += 1
    return float(steps)
