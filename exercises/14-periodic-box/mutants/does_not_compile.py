# loses: everything
# A semicolon is missing.
CHANGES = [
    ('j.x += Vec3{whole(d.x, L.x), whole(d.y, L.y), whole(d.z, L.z)};',
     'j.x += Vec3{whole(d.x, L.x), whole(d.y, L.y), whole(d.z, L.z)}'),
]
