"""Exercise 14: the partner is put where it is nearest; the search asks for shifted boxes as well."""

CHANGES = [
    ('X(eta, real,',
     'X(period, Vec3, (Vec3{0, 0, 0}), "L", "[0, inf)", "size of a periodic box, 0: open") \\\n'
     '  X(eta, real,'),
    ('bool step();',
     'bool step();\n'
     '  Body<real> image(Body<real> j, const Vec3& centre) const;\n'
     '  Vec3 in_box(const Vec3& x) const; bool is_shortest(const Vec3& d) const;\n'
     '  template <class F> void each_shift(const F& use) const;'),
    ('static void fail(Slab& b, int i,',
     '''/// The image of j that is nearest to a place.
Body<real> Simulation::image(Body<real> j, const Vec3& centre) const {
  const Vec3 d = centre - j.x, L = p.period;
  const auto whole = [](real a, real l) { return l > 0 ? l * std::round(a / l) : real(0); };
  j.x += Vec3{whole(d.x, L.x), whole(d.y, L.y), whole(d.z, L.z)};
  return j; }
/// The image of a place that lies in the box.
Vec3 Simulation::in_box(const Vec3& x) const { const Vec3 L = p.period;
  const auto inside = [](real a, real l) { return l > 0 ? a - l * std::floor(a / l) : a; };
  return {inside(x.x, L.x), inside(x.y, L.y), inside(x.z, L.z)}; }
/// Is a distance that of the nearest images?
bool Simulation::is_shortest(const Vec3& d) const { const Vec3 L = p.period;
  const auto near = [](real a, real l) { return !(l > 0) || (-l < 2 * a && 2 * a <= l); };
  return near(d.x, L.x) && near(d.y, L.y) && near(d.z, L.z); }
/// Calls use(shift) for the box and its neighbours.
template <class F> void Simulation::each_shift(const F& use) const {
  const Vec3 L = p.period; const int a = L.x > 0, b = L.y > 0, c = L.z > 0;
  for (int i = -a; i <= a; ++i) for (int j = -b; j <= b; ++j) for (int k = -c; k <= c; ++k)
    use(Vec3{real(i) * L.x, real(j) * L.y, real(k) * L.z}); }
static void fail(Slab& b, int i,'''),
    ('aj[n] = &grains[p.j];',
     'aj[n] = &wall[n];\n'
     '      static_cast<Body<real>&>(wall[n]) = s.image(grains[p.j], ai[n]->x);'),
    ('&c = p.j < 0 ? wall[n] : grains[p.j];', '&c = wall[n];'),
    ('if (p.j < 0) static_cast<Body<real>&>(c) = s.wall(-1 - p.j, a.x, a.v);',
     'static_cast<Body<real>&>(c) = p.j < 0 ? s.wall(-1 - p.j, a.x, a.v)\n'
     '                                           : s.image(grains[p.j], a.x);'),
    ('&j = *aj[l];', '&j = b.pairs[k[l]].j < 0 ? *aj[l] : grains[b.pairs[k[l]].j];'),
    (': Body<real>(grains[j]);', ': image(grains[j], bi.x);'),
    ('''      particle_tree.visit(box, [&](int j) {
        if (j > i || j < b.first) near.push_back({grains[j].x, grains[j].reach(), j}); }); }''',
     '''      each_shift([&](const Vec3& d) {
        particle_tree.visit({box.low - d, box.high - d}, [&](int j) {
          if (j > i || j < b.first) near.push_back({grains[j].x + d, grains[j].reach(), j}); }); }); }'''),
    ('n += (o.j > i || o.j < b.first) & close(o.x, o.reach);',
     'n += (o.j > i || o.j < b.first) & is_shortest(g.x - o.x) & close(o.x, o.reach);'),
    ('f[square(g.x - c.x) >=', 'f[square(g.x - image(c, g.x).x) >='),
    ('for (Grain& g : grains) g.room =',
     'for (Grain& g : grains) g.x = in_box(g.x), g.room ='),
    ('all[id[i]] = {g.x, g.R,', 'all[id[i]] = {in_box(g.x), g.R,'),
    ('check(j, grains[j], grains[j].room); };',
     'check(j, image(grains[j], x), grains[j].room); };'),
    ('particle_tree.visit(Box::around(x, R + far), check_grain);',
     'each_shift([&](const Vec3& d) {\n'
     '    particle_tree.visit(Box::around(x - d, R + far), check_grain); });'),
]
