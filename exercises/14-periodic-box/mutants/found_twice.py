# loses: pair_across replicas shift_invariance history ring
# A pair is listed for every image that the search comes upon.
CHANGES = [
    ('is_shortest(g.x - x) && close(x, reach)',
     'square(image({x, 0, {}, 0, {}, 0}, g.x).x - g.x) < square(g.reach() + reach)'),
]
