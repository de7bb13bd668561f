# loses: pair_across replicas energy shift_invariance history ring
# The search finds them, but the law sees them a period away.
CHANGES = [
    ('p.j < 0 ? s.wall(-1 - p.j, a.x) : s.image(s.grains[p.j], a.x);',
     'p.j < 0 ? s.wall(-1 - p.j, a.x) : Body<real>(s.grains[p.j]);'),
]
