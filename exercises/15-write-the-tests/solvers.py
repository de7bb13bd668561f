"""The broken solvers: a list of (expression of tinydem.cpp that stands there once, replacement).

Write your tests first. This list is here so that your grader can build the solvers; with other
seeds, teachers break the same statements in other ways.
"""

BROKEN = {
    "contact_radius": [("sqrt(c.Rstar * c.delta)", "c.delta")],
    "elastic_modulus": [("E / (2 * (1 - nu * nu))", "E / (2 * (1 - nu))")],
    "effective_radius": [("product * m_inv", "(i.R + j.R) / 4")],
    "stiffness_of_walls": [("select(wall, T(2), T(1))", "T(1)")],
    "damping": [("sqrt(5 * c.mstar * kn)", "sqrt(2 * c.mstar * kn)")],
    "tangential_stiffness": [("8 * (c.stiff * mat.Gstar) * a", "4 * (c.stiff * mat.Gstar) * a")],
    "sliding_limit": [("mat.mus * load", "2 * mat.mus * load")],
    "spring_in_slip": [("-m.k_inv * rest", "u")],
    "contact_velocity": [("cross(c.n, c.ri * i.w + c.rj * j.w)",
                          "cross(c.n, c.ri * i.w - c.rj * j.w)")],
    "torque_on_the_other": [("c.rj * cross(fs, c.n)", "c.ri * cross(fs, c.n)")],
    "rolling_velocity": [("i.w - j.w", "i.w + j.w")],
    "rolling_limit": [("mat.mur * load", "mat.mus * load")],
    "motion": [("step * v", "step * (v - step * a)")],
    "drag": [("stokes * R2_inv", "stokes * g.R_inv")],
    "orientation": [("s.printed ? -1 : 1", "-1")],
}
#: As right as the solver is, but the last digits differ.
RIGHT = [
    ("dt / 2 * w", "real(1.00000000000001) * dt / 2 * w"),
    ("c.Rstar * dot(w, c.n)", "dot(c.Rstar * w, c.n)"),
    ("kn * c.delta - cn * c.vn", "c.delta * kn - c.vn * cn * (1 + 1e-14)"),
]
