// Closest points of mesh elements against a search that knows nothing of regions: the closest point
// of a simplex is the closest among the orthogonal projections to the spans of all sets of its
// vertices, as far as they lie inside (long double, least squares).
#include <Eigen/Dense>

#include "test_support.hpp"

using namespace tinydem;

typedef Eigen::Matrix<long double, 3, 1> Point;
static Point point(const Vec3& a) { return Point(a.x, a.y, a.z); }

/// Distance from p to the simplex of up to 3 corners; region: the vertices that it is closest to.
static long double simplex_distance(const Point& p, const vector<Point>& corners, int* region = nullptr) {
  long double best = std::numeric_limits<long double>::infinity();
  for (int set = 1; set < 1 << corners.size(); ++set) {
    vector<Point> chosen;
    for (size_t k = 0; k < corners.size(); ++k)
      if (set >> k & 1) chosen.push_back(corners[k]);
    Eigen::Matrix<long double, 3, Eigen::Dynamic> edges(3, chosen.size() - 1);
    for (size_t k = 1; k < chosen.size(); ++k) edges.col(long(k) - 1) = chosen[k] - chosen[0];
    Point q = chosen[0];
    if (chosen.size() > 1) {
      const auto qr = edges.colPivHouseholderQr();
      if (qr.rank() < edges.cols()) continue;  // then fewer vertices span the same
      const auto t = qr.solve(p - q).eval();
      if (t.minCoeff() < 0 || t.sum() > 1) continue;
      q += edges * t;
    }
    if ((p - q).norm() >= best) continue;
    best = (p - q).norm();
    if (region) *region = set;
  }
  return best;
}
static long double distance(const Vec3& p, const vector<Vec3>& corners, int* region = nullptr) {
  vector<Point> c;
  for (const Vec3& a : corners) c.push_back(point(a));
  if (c.size() < 4) return simplex_distance(point(p), c, region);
  return min(simplex_distance(point(p), {c[0], c[1], c[2]}), simplex_distance(point(p), {c[0], c[2], c[3]}));
}
/// Is q the closest point? Its distance is right, and it belongs to the element.
static double closest_error(const Vec3& p, const vector<Vec3>& corners, int* region = nullptr) {
  const Mesh mesh = one_element(corners);
  const Vec3 q = closest_point(mesh, mesh.elements[0], p);
  const long double away = fabsl((point(p) - point(q)).norm() - distance(p, corners, region));
  Largest worst;
  worst(double(away)), worst(double(distance(q, corners)));
  return worst.error;
}

TEST_CASE("exact: closest points of all elements in all regions") {
  Random random(1);
  Largest worst;
  std::array<int, 8> seen{};
  for (int k = 0; k < 3000; ++k) {
    const Vec3 p = random.vector(2), a = random.vector(1), b = random.vector(1), c = random.vector(1);
    int region = 0;
    worst(closest_error(p, {a})), worst(closest_error(p, {a, b}));
    worst(closest_error(p, {a, b, c}, &region));
    ++seen[size_t(region)];
    const Vec3 normal = cross(b - a, c - a), side = random(real(0.2), 2) / norm(normal) * cross(normal, b - a);
    worst(closest_error(p, {a, b, b + side, a + side}));
  }
  CHECK(*std::min_element(seen.begin() + 1, seen.end()) > 30);  // 3 corners, 3 edges, the inside
  CHECK(worst.error < 5e-15);  // measured 7.5e-16
}

TEST_CASE("exact: closest points of degenerate elements") {
  Random random(2);
  Largest worst;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 p = random.vector(2), a = random.vector(1), e = random.vector(1), side = random.vector(1);
    const real s = random(-1, 2), tiny = std::pow(real(10), random(-17, -5));
    const Vec3 b = a + e, between = a + s * e, near = between + tiny * side;
    const vector<Vec3> shapes[] = {
        {a, a},       {a, a + tiny * e},                          // edges without length
        {a, a, a},    {a, a, b},         {a, b, a},  {b, a, a},   // triangles without area
        {a, between, b}, {a, b, between}, {a, b, near}, {near, a, b}, {a, a + tiny * e, b},
        {a, a, a, a}, {a, a, b, b},      {a, b, b, a}};           // rectangles without area
    for (const auto& corners : shapes) worst(closest_error(p, corners));
  }
  CHECK(worst.error < 3e-15);  // measured 3.1e-16
}

TEST_CASE("exact: closest points on a triangle whose corners lie on a line, up to rounding") {
  Random random(2);
  Largest worst;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 a = random.vector(1), e = random.vector(1);
    worst(closest_error(a + random(0, 1) * e, {a, a + e, a + random(-1, 2) * e}));
  }
  CHECK(worst.error < 3e-15);  // measured 
}

TEST_CASE("exact: the tree finds every element within reach") {
  Random random(3);
  Mesh mesh;
  const Reals radii{0, real(0.05), real(0.2)};
  for (int k = 0; k < 300; ++k) {
    const int n = k % 4 + 1, first = int(mesh.vertices.size());
    const Vec3 a = random.vector(1), u = random.vector(real(0.3)), w = random.vector(real(0.3));
    const Vec3 v = n < 4 ? w : cross(u, w);  // four vertices: a rectangle
    for (const Vec3& c : {a, a + u, a + u + v, a + v}) mesh.vertices.push_back(c);
    mesh.elements.push_back({n, {first, first + 1, first + 2, first + 3}, k % 3});
  }
  Parameters p = scene("");
  p.Rmesh = radii;
  const Simulation s(p, mesh);
  int near = 0, missed = 0, repeated = 0, visited = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec3 x = random.vector(real(1.5));
    const real reach = random(0, real(0.3));
    vector<int> found(mesh.elements.size());
    for (const Group& g : s.groups)
      g.tree.visit(Box::around(x, reach), [&](int e) { ++found[g.tree.order[e]], ++visited; });
    for (size_t e = 0; e < found.size(); ++e) {
      const bool close = norm(x - closest_point(mesh, mesh.elements[e], x)) < reach + radii[size_t(mesh.elements[e].group)];
      near += close, missed += close && !found[e], repeated += found[e] > 1;
    }
  }
  CHECK(missed + repeated == 0);
  CHECK(near > 500);
  CHECK(visited < 10 * near);  // it is a search, not a list
}
