# loses: apart energy
# Bodies attract each other before they touch.
CHANGES = [
    ('bool touch = square(a.x - c.x) < square(a.R + c.R);',
     'const real range = s.p.gamma > 0 ? real(1.05) : real(1);\n      bool touch = square(a.x - c.x) < square(range * (a.R + c.R));'),
    ('const T a = sqrt(c.Rstar * c.delta);',
     'const T a = sqrt(c.Rstar * max(c.delta, T(1e-15)));'),
]
