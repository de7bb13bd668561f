# loses: spawning pair_across replicas shift_invariance history
# Neighbour boxes behind faces, none behind edges and corners.
CHANGES = [
    ('    use(Vec3{real(i) * L.x',
     '    if (i * i + j * j + k * k < 2) use(Vec3{real(i) * L.x'),
]
