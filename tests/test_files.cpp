// Files and options: what is read, and how every mistake is reported with its place.
#include <filesystem>
#include <fstream>

#include "test_support.hpp"

using namespace tinydem;

/// A file that lasts as long as the test.
struct File {
  string path = (std::filesystem::temp_directory_path() / ("tinydem_test_" + std::to_string(std::random_device()()))).string();
  explicit File(const string& content) { std::ofstream(path, std::ios::binary) << content; }
  ~File() { std::filesystem::remove(path); }
};
/// The message of the error that an action ends with; FILE stands for the path.
template <class F> static string message(F action, const string& path = " ") {
  string text;
  try {
    action();
  } catch (const InputError& e) {
    text = e.what();
  }
  for (size_t at; (at = text.find(path)) != string::npos && path != " ";) text.replace(at, path.size(), "FILE");
  return text;
}
static vector<string> lines(const string& text) { return text.empty() ? vector<string>() : split(text, '\n'); }
static bool has(const string& text, const string& part) { return text.find(part) != string::npos; }
/// As many lines as parts, and every line has its part.
static bool match(const string& text, const vector<string>& parts) {
  const auto all = lines(text);
  return std::equal(all.begin(), all.end(), parts.begin(), parts.end(), has);
}

// ------------------------------------------------------------------------------------ numbers

TEST_CASE("exact: numbers come back bit for bit") {
  Random random(1);
  int different = 0;
  const auto compare = [&](real a) {
    real b = 0;
    different += !parse(text(a), b) || std::memcmp(&a, &b, sizeof(real)) != 0;
  };
  for (int k = 0; k < 10000; ++k) compare(random(-1, 1) * std::pow(real(10), random(-300, 300)));
  for (const real a : {real(0), real(-0.0), real(0.1), std::numeric_limits<real>::max(), std::numeric_limits<real>::min(),
                       std::numeric_limits<real>::denorm_min(), pi})
    compare(a);
  CHECK(different == 0);
}
TEST_CASE("exact: what is a finite number") {
  struct Case {
    string token;
    bool good;
  };
  const Case cases[] = {{"1", true},    {"+1", true},   {"-1.5e-3", true}, {".5", true},  {"1e400", false}, {"nan", false},
                        {"inf", false}, {"", false},    {"1x", false},     {"1,5", false}, {"0x1", false},   {"--1", false},
                        {"+-1", false}, {"1 2", false}, {"e5", false}};
  for (const Case& c : cases) {
    real a = 0;
    CAPTURE(c.token);
    CHECK(parse(c.token, a) == c.good);
  }
}

// -------------------------------------------------------------------------------------- mesh

static const string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
TEST_CASE("exact: mesh files") {
  struct Case {
    string content;
    int vertices, elements;
  };
  const Case cases[] = {
      {off + "4 0 1 2 3\n3 0 1 2 1\n", 4, 2},                                               // default group
      {"\xEF\xBB\xBF# made by hand\r\nOFF # a comment\r\n\r\n1 1 0\r\n0\t 0  0 # origin\r\n1 0\r\n", 1, 1},
      {"OFF 1 1 0\n0 0 0\n1 0 1", 1, 1},                                                    // counts on the first line
      {"OFF\n0 0 0\n", 0, 0},
      {"OFF\n2 1 1\n0 0 1e-3\n-1.5 +2 3\n2 0 1 2\n", 2, 1}};
  for (const Case& c : cases) {
    const File file(c.content);
    CAPTURE(c.content);
    Mesh mesh;
    CHECK(message([&] { mesh = read_mesh(file.path, 3); }) == "");
    CHECK(int(mesh.vertices.size()) == c.vertices);
    CHECK(int(mesh.elements.size()) == c.elements);
  }
  const File file(off + "4 0 1 2 3 2\n3 2 1 0\n");
  const Mesh mesh = read_mesh(file.path, 3);
  CHECK(mesh.vertices[2].y == 1);
  CHECK(mesh.elements[0].group == 2);
  CHECK(mesh.elements[1].group == 0);
  CHECK(mesh.elements[1].n == 3);
  CHECK(mesh.elements[1].vertex[0] == 2);
}
TEST_CASE("exact: mistakes in mesh files are reported together with their lines") {
  struct Case {
    string content;
    vector<string> mistakes;
  };
  const Case cases[] = {
      {"", {"FILE:0: must start with OFF", "FILE:0: number of vertices", "FILE:0: number of faces", "FILE:0: number of edges"}},
      {"solid x\n", {"FILE:1: must start with OFF", "'x'", "number of faces", "number of edges"}},
      {"OFF\n1 1 0\n0 0 x\n1 0\n", {"FILE:3: z = 'x' must be a finite number"}},
      {"OFF\n2 1 0\n0 0\n1 0 inf 7\n1 0\n", {"FILE:3: z = ''", "FILE:4: z = 'inf'", "FILE:4: '7' is one value too many"}},
      {off + "3 0 1 4\n5 0 1 2 3 0\n",
       {"FILE:7: vertex index = '4' must be an integer in [0, 3]", "FILE:8: vertices of a face = '5'"}},
      {off + "3 0 1 1.5\n3 0 1\n", {"FILE:7: vertex index = '1.5'", "FILE:8: vertex index = ''"}},
      {off + "3 0 1 2 3\n3 0 1 2 -1\n", {"FILE:7: index into Rmesh", "FILE:8: index into Rmesh"}},
      {off + "3 0 1 2 0 9\n3 0 1 2\n", {"FILE:7: '9' is one value too many"}},
      {off + "4 0 2 1 3\n3 0 1 2\n", {"FILE:7: four vertices must be the corners of a rectangle"}},
      {off + "3 0 1 2\n", {"FILE:7: must end after 4 vertices, 2 faces, has 4, 1"}},
      {"OFF\n3 1 0\n0 0 0\n", {"FILE:3: must end after 3 vertices, 1 faces, has 1, 0"}},
      {"OFF\n1 0 0\n0 0 0\n1 0\n", {"FILE:4: must end after 1 vertices, 0 faces, has 1, 0"}},
      {"OFF\n-1 1 0\n", {"FILE:2: number of vertices = '-1'"}},
      {"OFF\n1e99 1 0\n", {"FILE:2: number of vertices = '1e99'"}}};
  for (const Case& c : cases) {
    const File file(c.content);
    const string said = message([&] { read_mesh(file.path, 3); }, file.path);
    CAPTURE(c.content);
    CAPTURE(said);
    CHECK(match(said, c.mistakes));
  }
  CHECK(has(message([] { read_mesh("/nowhere/mesh.off", 1); }), "/nowhere/mesh.off: cannot be read"));
  CHECK(has(message([] { read_mesh("/", 1); }), "/: cannot be read"));
}

// --------------------------------------------------------------------------------- particles

TEST_CASE("exact: particle files, columns by name") {
  const File file("\xEF\xBB\xBFR,x,y,z,q0,q1,q2,q3,wx,wy,wz,vx,vy,vz\r\n# a comment\r\n"
                  "0.5, 1, 2, 3, 0, 1, 0, 0, 7, 8, 9, 4, 5, 6 # and one more\r\n\r\n");
  const vector<Particle> all = read_particles(file.path);
  REQUIRE(all.size() == 1);
  Particle a = all[0];
  const real expected[] = {1, 2, 3, real(0.5), 4, 5, 6, 0, 1, 0, 0, 7, 8, 9};
  for (size_t k = 0; k < 14; ++k) CHECK((&a.x.x)[k] == expected[k]);
  CHECK(read_particles(File(string(csv_header) + "\n").path).empty());
}
TEST_CASE("exact: particle files come back bit for bit") {
  string content = string(csv_header) + "\n";
  vector<Particle> all = swarm(5);
  for (Particle& a : all) {
    for (size_t k = 0; k < 14; ++k) content += (k ? "," : "") + text((&a.x.x)[k]);
    content += "\n";
  }
  CHECK(same_bits(read_particles(File(content).path), all));
}
TEST_CASE("exact: mistakes in particle files are reported together with their lines") {
  const string header = string(csv_header) + "\n";
  struct Case {
    string content;
    vector<string> mistakes;
  };
  const Case cases[] = {
      {"", {"FILE:0: column 'wz' must stand here once; the header is x,y,z,R,"}},
      {"x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,w\n", {"FILE:1: column 'wz' must stand here once"}},
      {"x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz,m\n", {"FILE:1: column 'm' is unknown"}},
      {"x,x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz\n", {"FILE:1: column 'x' must stand here once"}},
      {header + "0,0,nan,1,0,0,0,1,0,0,0,0,0,0\n0,0,0,1,0,0,0,1,0,0,0,0,0\n",
       {"FILE:2: z = 'nan' must be a finite number", "FILE:3: wz = ''"}},
      {header + "0,0,0,1,0,0,0,1,0,0,0,0,0,0,5\n", {"FILE:2: '5' is one value too many"}},
      {header + "0,0,0,0,0,0,0,1,0,0,0,0,0,0\n0,0,0,-1,0,0,0,2,0,0,0,0,0,0\n",
       {"FILE:2: R = 0 must be > 0", "FILE:3: R = -1 must be > 0", "FILE:3: q0 ... q3 must have norm 1, not 2"}}};
  for (const Case& c : cases) {
    const File file(c.content);
    const string said = message([&] { read_particles(file.path); }, file.path);
    CAPTURE(c.content);
    CAPTURE(said);
    CHECK(match(said, c.mistakes));
  }
}

// -------------------------------------------------------------------------------- parameters

TEST_CASE("exact: defaults are those of Table 2, and Eqs. 41 and 50") {
  const Parameters p = resolve();
  CHECK(p.Rmin == real(0.002));
  CHECK(p.Rmax == real(0.01));
  CHECK(p.Rmesh == Reals{real(0.002), real(0.02), real(0.01)});
  CHECK(p.smin.z == real(0.3));
  CHECK(p.smax.x == real(0.1));
  CHECK(p.rho == 1000);
  CHECK(p.E == 1e6);
  CHECK(p.nu == real(0.3));
  CHECK(p.en == real(0.5));
  CHECK(p.mus == real(0.3));
  CHECK(p.mur == real(0.3));
  CHECK(std::abs(p.mut - 0.2) < 1e-16);
  CHECK(p.eta == 0);
  CHECK(p.v0.z == -1);
  CHECK(square(p.w0) == 0);
  CHECK(p.g.z == real(-9.81));
  CHECK(std::abs(p.dt / (0.002 * std::sqrt(1e3 * 0.91 / 1e6)) - 1) < 1e-15);
  CHECK(p.Nmax == 1000);
  CHECK(p.Nframes == 100);
  CHECK(p.Nsteps == 500);
  CHECK(p.Nspawn == 100);
  CHECK(scene("mus = 0.6; mut = 0.1").mut == real(0.1));
  CHECK(scene("dt = 1e-3").dt == real(1e-3));
}
TEST_CASE("exact: values out of range, malformed values and unknown names") {
  struct Case {
    string name, value, mistake;  // mistake empty: a good value
  };
  const Case cases[] = {
      {"Rmin", "0", "(0, inf)"},      {"Rmin", "1e-9", ""},         {"Rmax", "0.001", "[Rmin, inf)"}, {"Rmax", "0.002", ""},
      {"Rmesh", "0", ""},             {"Rmesh", "0,-1", "[0, inf)"}, {"Rmesh", "1,2,3,4", ""},        {"rho", "0", "(0, inf)"},
      {"E", "-1", "(0, inf)"},        {"nu", "-1", "(-1, 0.5]"},    {"nu", "-0.999", ""},             {"nu", "0.5", ""},
      {"nu", "0.5001", "(-1, 0.5]"},  {"en", "0", ""},              {"en", "1", ""},                  {"en", "1.001", "[0, 1]"},
      {"en", "-0.1", "[0, 1]"},       {"mus", "-0.1", "[0, inf)"},  {"mur", "-1", "[0, inf)"},        {"mut", "-1", "[0, inf)"},
      {"eta", "-1", "[0, inf)"},      {"dt", "0", "(0, inf)"},      {"dt", "-1", "(0, inf)"},         {"dt", "nan", "a number"},
      {"g", "inf,0,0", "three numbers"}, {"g", "1,2", "three numbers"}, {"g", "1,2,3,4", "three numbers"}, {"g", "1 2 3", "three numbers"},
      {"smax", "-0.2,1,1", "[smin, inf)"}, {"smax", "1,1,0.2", "[smin, inf)"}, {"smax", "-0.1,-0.1,0.3", ""},
      {"Nmax", "-1", "[0, 2e9]"},     {"Nmax", "1.5", "an integer"}, {"Nframes", "1000000", "[0, 999999]"}, {"Nsteps", "1e3", ""},
      {"scheme", "Paper", "consistent|paper"}, {"scheme", "paper", ""}, {"orientation", "yes", "on|off"}, {"orientation", "off", ""},
      {"Rmim", "1", "did you mean 'Rmin'?"}, {"mu_s", "1", "did you mean 'mus'?"}, {"nspawn", "1", "did you mean 'Nspawn'?"},
      {"gravity", "1", "is unknown"}, {"E", "", "a number"},        {"E", "1e6 Pa", "a number"},      {"mesh", "any name", ""}};
  for (const Case& c : cases) {
    const string said = message([&] { resolve({{c.name, c.value, "PLACE"}}); });
    CAPTURE(c.name);
    CAPTURE(c.value);
    CAPTURE(said);
    CHECK(match(said, c.mistake.empty() ? vector<string>() : vector<string>{c.mistake}));
    if (!c.mistake.empty()) CHECK(has(said, "PLACE: "));
  }
  CHECK(match(message([] { resolve({{"E", "-1", "A"}, {"nu", "9", "B"}, {"en", "2", "C"}}); }), {"A: E", "B: nu", "C: en"}));
  CHECK(match(message([] { resolve({{"E", "x", "A"}, {"foo", "9", "B"}}); }), {"A: E", "B: 'foo'"}));
  CHECK(match(message([] { resolve({{"Rmin", "1", "A"}}); }), {"A: Rmax = '0.01' must be a number in [Rmin, inf)"}));
}
TEST_CASE("exact: a later setting beats an earlier one") {
  CHECK(resolve({{"E", "1", "scene"}, {"E", "2", "command line"}}).E == 2);
}
TEST_CASE("exact: scene files") {
  const File file("\xEF\xBB\xBF# a scene\r\n\r\n E = 5 # soft\r\nmesh=a/b.off\r\ng = 0, 0 ,-1\n");
  const auto settings = read_scene(file.path);
  REQUIRE(settings.size() == 3);
  CHECK(settings[0].name == "E");
  CHECK(settings[0].text == "5");
  CHECK(settings[0].where == file.path + ":3");
  CHECK(settings[1].text == (std::filesystem::path(file.path).parent_path() / "a/b.off").string());
  CHECK(resolve(settings).g.z == -1);
  const File bad("E = 1\nE = 2\nE 3\nnu = 0.1 = 0.2\n");
  CHECK(match(message([&] { read_scene(bad.path); }, bad.path),
              {"FILE:2: 'E' is repeated, it stands in FILE:1", "FILE:3: 'E 3' must be name = value",
               "FILE:4: 'nu = 0.1 = 0.2' must be name = value"}));
  const File wrong("E = -1\n\nnu = 7\n");
  CHECK(match(message([&] { resolve(read_scene(wrong.path)); }, wrong.path), {"FILE:1: E = '-1'", "FILE:3: nu = '7'"}));
}
