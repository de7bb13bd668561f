# loses: pair_across replicas shift_invariance history ring
# A pair is listed for every image that the search comes upon.
CHANGES = [
    ('is_shortest(g.x - o.x) & close(o.x, o.reach)',
     'square(image({o.x, 0, {}, 0, {}, 0}, g.x).x - g.x) < square(g.reach() + o.reach)'),
]
