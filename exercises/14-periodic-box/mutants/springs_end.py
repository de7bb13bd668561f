# loses: shift_invariance history
# A contact begins anew when its partner changes its image.
CHANGES = [
    ('< square(a.R + c.R);',
     '< square(a.R + c.R);\n      if (p.j >= 0 && p.touching && square(c.x - grains[p.j].x) > 0 && '
     'M::any)\n        b.springs.set(next, {});'),
]
