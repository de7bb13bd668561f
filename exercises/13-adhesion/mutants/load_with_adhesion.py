# loses: friction vertical_wall
# The limit of friction takes the force with the adhesion in it.
CHANGES = [
    ('const T load = norm(fn),',
     'const T load = norm(fn - mat.adhesion * c.Rstar),'),
]
