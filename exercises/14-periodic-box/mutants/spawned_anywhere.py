# loses: spawning
# Spawned without a look at the images.
CHANGES = [
    ('check(j, image(grains[j], x), grains[j].room); };',
     'check(j, grains[j], grains[j].room); };'),
]
