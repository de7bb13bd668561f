# loses: in_the_box
# Never put back into the box: right for a while, and only near it.
CHANGES = [
    ('g.x = in_box(g.x), g.room',
     'g.room'),
    ('= {in_box(g.x), g.R,',
     '= {g.x, g.R,'),
]
