# loses: energy
# The elastic energy knows nothing of contacts across the boundary.
CHANGES = [
    ('bj = j < 0 ? wall(-1 - j, bi.x) : image(grains[j], bi.x);',
     'bj = j < 0 ? wall(-1 - j, bi.x) : Body<real>(grains[j]);'),
]
