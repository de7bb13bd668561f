# loses: energy
# The energy of the adhesion with the wrong sign.
CHANGES = [
    ('square(c.delta) - pulled,',
     'square(c.delta) + pulled,'),
]
