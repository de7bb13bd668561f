# loses: two_spheres sphere_and_wall ceiling vertical_wall equilibrium
# 2 pi gamma R*: gamma is the energy of one of the two surfaces.
CHANGES = [
    ('= 4 * T(pi)',
     '= 2 * T(pi)'),
]
