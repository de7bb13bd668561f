# loses: parameter unchanged
# The default is a box of one metre.
CHANGES = [
    ('X(period, Vec3, (Vec3{0, 0, 0})',
     'X(period, Vec3, (Vec3{1, 1, 1})'),
]
