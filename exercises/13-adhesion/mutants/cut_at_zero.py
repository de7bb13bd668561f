# loses: two_spheres sphere_and_wall ceiling vertical_wall energy equilibrium
# The adhesion grows with the overlap: none is left at delta = 0, where two bodies part.
CHANGES = [
    ('fn - mat.adhesion * c.Rstar',
     'fn - mat.adhesion * c.Rstar * c.delta / c.R'),
]
