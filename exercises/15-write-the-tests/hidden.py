"""Exercise 15: other ways to break the same statements, for seeds that are not public."""

HIDDEN = {
    "contact_radius": ("sqrt(c.Rstar * c.delta)", "sqrt(2 * c.Rstar * c.delta)"),
    "elastic_modulus": ("E / (2 * (1 - nu * nu))", "E / (1 - nu * nu)"),
    "effective_radius": ("product * m_inv", "c.R / 2"),
    "stiffness_of_walls": ("select(wall, T(2), T(1))", "select(wall, T(4), T(1))"),
    "damping": ("sqrt(5 * c.mstar * kn)", "sqrt(4 * c.mstar * kn)"),
    "tangential_stiffness": ("8 * (c.stiff * mat.Gstar) * a", "6 * (c.stiff * mat.Gstar) * a"),
    "sliding_limit": ("mat.mus * load", "mat.mus * load / 2"),
    "spring_in_slip": ("-m.k_inv * rest", "u + m.dt * v"),
    "contact_velocity": ("cross(c.n, c.ri * i.w + c.rj * j.w)", "cross(c.n, c.ri * i.w)"),
    "torque_on_the_other": ("c.rj * cross(fs, c.n)", "c.rj / 2 * cross(fs, c.n)"),
    "rolling_velocity": ("i.w - j.w", "i.w - T(0) * j.w"),
    "rolling_limit": ("mat.mur * load", "2 * mat.mur * load"),
    "motion": ("step * v", "step * (v - dt / 2 * a)"),
    "drag": ("stokes * R2_inv", "stokes * R2_inv / 2"),
    "orientation": ("dt / 2 * w", "dt * w"),
}
