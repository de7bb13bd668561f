# loses: sphere_and_wall ceiling vertical_wall
# The factor 2 of the stiffness at a wall, for the adhesion as well.
CHANGES = [
    ('fn - mat.adhesion * c.Rstar',
     'fn - c.stiff * mat.adhesion * c.Rstar'),
]
