"""Exercise 13: a parameter, a constant of the material, a term of the law, a term of the energy."""

CHANGES = [
    ('X(eta, real,',
     'X(gamma, real, 0, "M/T^2", "[0, inf)", "surface energy (adhesion)") \\\n  X(eta, real,'),
    ('struct Material { T Estar,', 'struct Material { T adhesion, Estar,'),
    ('m.mus = T(p.mus),', 'm.adhesion = 4 * T(pi) * T(p.gamma), m.mus = T(p.mus),'),
    ('r.f = fn * c.n, r.fn = fn * c.n,',
     'const T total = fn - mat.adhesion * c.Rstar;\n  r.f = total * c.n, r.fn = total * c.n,'),
    ('const real normal = real(0.4) * r.kn * square(c.delta),',
     'const real pulled = mat.adhesion * c.Rstar * c.delta;\n'
     '    const real normal = real(0.4) * r.kn * square(c.delta) - pulled,'),
]
