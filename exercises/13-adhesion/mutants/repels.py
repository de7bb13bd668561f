# loses: two_spheres sphere_and_wall ceiling vertical_wall energy equilibrium
# The wrong sign.
CHANGES = [
    ('fn - mat.adhesion * c.Rstar',
     'fn + mat.adhesion * c.Rstar'),
]
