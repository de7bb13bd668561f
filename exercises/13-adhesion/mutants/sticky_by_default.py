# loses: parameter unchanged
# The default is not 0.
CHANGES = [
    ('X(gamma, real, 0,',
     'X(gamma, real, 0.05,'),
]
