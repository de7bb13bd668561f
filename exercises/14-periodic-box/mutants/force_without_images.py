# loses: pair_across replicas energy shift_invariance history ring
# The search finds them, but the law sees them a period away.
CHANGES = [
    ('static_cast<Body<real>&>(wall[n]) = s.image(grains[p.j], ai[n]->x);',
     'static_cast<Body<real>&>(wall[n]) = grains[p.j];'),
    (': s.image(grains[p.j], a.x);', ': Body<real>(grains[p.j]);'),
]
