# loses: everything
# A bracket is missing.
CHANGES = [
    ('const T total = fn - mat.adhesion * c.Rstar;',
     'const T total = (fn - mat.adhesion * c.Rstar;'),
]
