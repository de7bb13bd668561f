# loses: two_spheres equilibrium
# The smaller radius where R* belongs: right at walls only.
CHANGES = [
    ('fn - mat.adhesion * c.Rstar',
     'fn - mat.adhesion * c.R'),
    ('mat.adhesion * c.Rstar * c.delta',
     'mat.adhesion * c.R * c.delta'),
]
