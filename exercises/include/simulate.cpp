// Runs a copy of the solver for the grader: numbers in, numbers out. grader/solver.py writes the ones
// and reads the others. The exercises that change the solver compile this file with the student's copy.
#include "tinydem.cpp"

namespace {

using namespace tinydem;

/// The numbers of a question, one after the other.
struct Question {
  const double* next;
  double number() { return *next++; }
  int whole() { return int(number()); }
  Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  string text() {
    string all;
    for (int n = whole(); n > 0; --n) all += char(whole());
    return all;
  }
};

struct Reply {
  std::vector<double> all{};
  void add(double a) { all.push_back(a); }
  void add(const Vec3& a) { add(a.x), add(a.y), add(a.z); }
  void add(const string& text) {
    for (const char c : text) add(double(c));
  }
};

Parameters scene(const string& lines) {
  std::vector<Setting> settings;
  for (const string& line : split(lines, ';'))
    if (const auto words = split(line, '='); words.size() == 2)
      settings.push_back({words[0], words[1], "scene"});
  return resolve(settings);
}

void add_frame(const Simulation& s, Reply& reply) {
  const auto particles = s.particles();
  const auto contacts = s.contacts();
  const Summary e = s.summary();
  for (const double a : {e.kinetic, e.rotational, e.potential, e.elastic}) reply.add(a);
  reply.add(double(particles.size())), reply.add(double(contacts.size()));
  for (const Particle& a : particles) {
    reply.add(a.x), reply.add(a.R), reply.add(a.v), reply.add(a.w);
    for (const double q : a.q) reply.add(q);
  }
  for (const Contact& c : contacts) {
    for (const int k : {c.i, c.j, c.element}) reply.add(double(k));
    reply.add(c.delta), reply.add(c.fn), reply.add(c.fs), reply.add(c.us);
  }
}

}  // namespace

/// Scene (text), particles (x, R, v, w), mesh (vertices; corners and group of each element), and the
/// numbers of steps between frames. The first number of the reply is 0 when all went well, 1 when
/// the run failed and 2 when the input was refused, both with a text.
std::vector<double> simulate(const std::vector<double>& numbers) {
  Question q{numbers.data()};
  Reply reply;
  try {
    const Parameters p = scene(q.text());
    std::vector<Particle> particles;
    for (int n = q.whole(); n > 0; --n) {
      Particle a;
      a.x = q.vector(), a.R = q.number(), a.v = q.vector(), a.w = q.vector();
      particles.push_back(a);
    }
    Mesh mesh;
    for (int n = q.whole(); n > 0; --n) mesh.vertices.push_back(q.vector());
    for (int n = q.whole(); n > 0; --n) {
      Element e{q.whole(), {}, 0};
      for (int& corner : e.vertex) corner = q.whole();
      e.group = q.whole(), mesh.elements.push_back(e);
    }
    Simulation s(p, mesh, particles);
    reply.add(0);
    for (int n = q.whole(); n > 0; --n) s.run(q.whole()), add_frame(s, reply);
  } catch (const InputError& e) {
    reply.all = {2}, reply.add(string(e.what()));
  } catch (const RunError& e) {
    reply.all = {1}, reply.add(string(e.what()));
  }
  return reply.all;
}
