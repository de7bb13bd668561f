# loses: parameter in_the_box spawning pair_across replicas shift_invariance history ring unchanged
# x / L without a look whether there is a period.
CHANGES = [
    ('return l > 0 ? a - l * std::floor(a / l) : a;',
     'return a - l * std::floor(a / l);'),
]
