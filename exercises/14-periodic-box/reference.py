"""Exercise 14: the frequency of a standing wave."""
import math


def ring(waves, spheres, R, E, nu, rho, delta):
    """Angular frequency of a wave with so many wavelengths in a ring of spheres that overlap by
    delta: a chain of masses with springs of stiffness df/d(delta)."""
    kn = 4 / 3 * E / (2 * (1 - nu * nu)) * math.sqrt(R / 2 * delta)
    mass = 4 / 3 * math.pi * rho * R ** 3
    return 2 * math.sqrt(1.5 * kn / mass) * math.sin(math.pi * waves / spheres)
