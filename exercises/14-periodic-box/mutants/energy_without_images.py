# loses: energy
# The elastic energy knows nothing of contacts across the boundary.
CHANGES = [
    (': image(grains[j], bi.x);',
     ': Body<real>(grains[j]);'),
]
