# loses: pair_across replicas energy shift_invariance history ring
# The search finds them, but the law sees them a period away.
CHANGES = [
    (': wall[n] = s.image(s.grains[p.j], a.x);',
     ': wall[n] = Body<real>(s.grains[p.j]);'),
]
