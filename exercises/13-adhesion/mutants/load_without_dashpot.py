# loses: friction unchanged
# The limit of friction takes the spring of f_n only.
CHANGES = [
    ('const T load = norm(fn),',
     'const T load = norm(kn * c.delta),'),
]
