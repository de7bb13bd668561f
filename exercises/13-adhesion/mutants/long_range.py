# loses: apart energy
# Bodies attract each other before they touch.
CHANGES = [
    ('< square(a.R + c.R);',
     '< square((s.p.gamma > 0 ? real(1.05) : real(1)) * (a.R + c.R));'),
    ('parted = c.delta < 0;',
     'parted = c.delta < (s.p.gamma > 0 ? real(-0.05) : real(0)) * (bi.get(l).R + bj.get(l).R);'),
    ('const T a = sqrt(c.Rstar * c.delta);',
     'const T a = sqrt(c.Rstar * max(c.delta, T(1e-15)));'),
]
