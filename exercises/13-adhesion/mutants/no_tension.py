# loses: apart two_spheres sphere_and_wall ceiling energy equilibrium unchanged
# The force is cut where it would attract.
CHANGES = [
    ('const T total = fn - mat.adhesion * c.Rstar;',
     'const T pulling = fn - mat.adhesion * c.Rstar;\n  const T total = select(pulling < 0, T(0), pulling);'),
]
