# loses: spawning pair_across replicas energy shift_invariance history ring
# Images along x only.
CHANGES = [
    ('whole(d.y, L.y), whole(d.z, L.z)}',
     'real(0), real(0)}'),
]
