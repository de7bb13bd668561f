"""Exercise 14, written differently: wrapped in every step; the search looks at everybody."""

CHANGES = [
    ('X(mus, real,',
     'X(period, Vec3, (Vec3{0, 0, 0}), "L", "[0, inf)", "period in x, y, z; 0: none") \\\n'
     '  X(mus, real,'),
    ('real time() const {',
     '''
  bool periodic() const { return p.period.x > 0 || p.period.y > 0 || p.period.z > 0; }
  /// Takes whole periods off a vector: rest(a, 0.5) is in [-L/2, L/2), rest(a, 0) in [0, L).
  Vec3 rest(Vec3 a, real share) const {
    for (auto side : {&Vec3::x, &Vec3::y, &Vec3::z})
      if (const real L = p.period.*side; L > 0) a.*side -= std::floor(a.*side / L + share) * L;
    return a; }
  Body<real> beside(const Vec3& x, const Body<real>& j) const {
    Body<real> moved = j; if (periodic()) moved.x = x - rest(x - j.x, real(0.5));
    return moved; }
  real time() const {'''),
    ('int k[block]; Grain', 'int k[block]; Grain partner[block]; Grain'),
    ('aj[n] = &grains[p.j];', 'aj[n] = &partner[n], partner[n] = grains[p.j];\n'
     '      static_cast<Body<real>&>(partner[n]) = s.beside(ai[n]->x, grains[p.j]);'),
    ('&c = p.j < 0 ? wall[n] : grains[p.j];', '&c = p.j < 0 ? wall[n] : partner[n];'),
    ('if (p.j < 0) static_cast<Body<real>&>(c) =',
     'if (p.j >= 0) static_cast<Body<real>&>(c) = s.beside(a.x, grains[p.j]);\n'
     '      if (p.j < 0) static_cast<Body<real>&>(c) ='),
    ('&j = *aj[l];', '&j = b.pairs[k[l]].j < 0 ? *aj[l] : grains[b.pairs[k[l]].j];'),
    ('f[square(g.x - c.x) >=', 'f[square(rest(g.x - c.x, real(0.5))) >='),
    (': Body<real>(grains[j]);', ': beside(bi.x, grains[j]);'),
    ('return square(g.x - x) < square(g.reach() + R); };',
     'return square(rest(g.x - x, real(0.5))) < square(g.reach() + R); };'),
    ('      particle_tree.visit(box, [&](int j) {\n',
     '      if (periodic()) box = Box::around({}, inf);\n'
     '      particle_tree.visit(box, [&](int j) {\n'),
    ('for (Grain& g : grains) g.room =',
     'for (Grain& g : grains) g.x = rest(g.x, 0), g.room ='),
    ('const real way = norm(dt * g.v);',
     'const real way = norm(dt * g.v); g.x = s.rest(g.x, 0);'),
    ('check(j, grains[j], grains[j].room); };',
     'check(j, beside(x, grains[j]), grains[j].room); };'),
    ('particle_tree.visit(Box::around(x, R + far), check_grain);',
     'particle_tree.visit(Box::around(x, periodic() ? inf : R + far), check_grain);'),
]
