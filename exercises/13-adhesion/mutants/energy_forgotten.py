# loses: energy
# The elastic energy knows nothing of the adhesion.
CHANGES = [
    ('square(c.delta) - pulled,',
     'square(c.delta) + 0 * pulled,'),
]
