# loses: parameter spawning pair_across replicas energy shift_invariance history ring unchanged
# Truncation where rounding belongs.
CHANGES = [
    ('l * std::round(a / l)',
     'l * std::trunc(a / l)'),
]
