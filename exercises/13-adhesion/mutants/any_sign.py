# loses: parameter
# The range allows negative numbers.
CHANGES = [
    ('"M/T^2", "[0, inf)"',
     '"M/T^2", "(-inf, inf)"'),
]
