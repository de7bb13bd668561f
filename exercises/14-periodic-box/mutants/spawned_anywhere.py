# loses: spawning
# Spawned without a look at the images.
CHANGES = [
    ('check(image(grains[j], centre)); }); });',
     'check(grains[j]); }); });'),
    ('j < size(); ++j) check(image(grains[j], centre));',
     'j < size(); ++j) check(grains[j]);'),
]
