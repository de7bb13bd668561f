"""Exercise 13, written differently: the pull is a property of the approach, friction takes it back."""

CHANGES = [
    ('X(mus, real,', 'X(gamma, real, 0, "M/T^2", "[0, inf)", "DMT surface energy") \\\n'
                     '  X(mus, real,'),
    ('struct Material { T Estar,', 'struct Material { T gamma; T Estar,'),
    ('m.mus = T(p.mus),', 'm.gamma = T(p.gamma);\n  m.mus = T(p.mus),'),
    ('template <class T> struct Loads { Vec<T> f, ti, tj, fn; T kn, ks; };',
     'template <class T> struct Loads { Vec<T> f, ti, tj, fn; T kn, ks, pull; };'),
    ('const T fn = kn * c.delta - cn * c.vn;',
     'const T pressure = kn * c.delta - cn * c.vn;\n'
     '  r.pull = T(4 * pi) * c.Rstar * mat.gamma;\n  const T fn = pressure - r.pull;'),
    ('const T load = norm(fn),', 'const T load = norm(pressure),'),
    ('const real energy = normal + rolling',
     'const real energy = normal - r.pull * c.delta + rolling'),
]
