# loses: parameter spawning pair_across replicas energy shift_invariance history ring unchanged
# Partners at their images, but the search does not ask for them.
CHANGES = [
    ('for (int i = -a; i <= a; ++i) for (int j = -b; j <= b; ++j) for (int k = -c; k <= c; ++k)',
     'for (int i = 0 * a; i <= 0; ++i) for (int j = 0 * b; j <= 0; ++j) for (int k = 0 * c; k <= 0; ++k)'),
]
