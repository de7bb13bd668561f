# loses: parameter
# The range allows negative periods.
CHANGES = [
    ('"L", "[0, inf)", "size of a periodic',
     '"L", "(-inf, inf)", "size of a periodic'),
]
