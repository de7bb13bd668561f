# loses: pair_across replicas momentum energy shift_invariance history ring
# No reaction on a partner that is an image.
CHANGES = [
    ('if (&j < head',
     'if (square(aj[l]->x - j.x) > 0) continue;\n'
     '      if (&j < head'),
]
