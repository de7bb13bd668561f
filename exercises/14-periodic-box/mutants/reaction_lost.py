# loses: pair_across replicas momentum energy shift_invariance history ring
# No reaction on a partner that is an image.
CHANGES = [
    ('s.grains[j].f += -r.f; if (M::any)',
     'if (square(wall[l].x - s.grains[j].x) > 0) continue;\n'
     '      s.grains[j].f += -r.f; if (M::any)'),
]
