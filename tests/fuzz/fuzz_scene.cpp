// Any bytes as a scene file: refused, or parameters that are in range and, written as the program
// writes scene.ini, come back the same.
#include "fuzz_support.hpp"
#include "tinydem.cpp"

using namespace tinydem;

/// The lines of scene.ini, and the names and texts of the paths, which depend on the folder.
static string listed(Parameters p) {
  string lines;
  p.mesh = p.particles = p.output = "";
  for (const Option& o : options(p))
    if (const string value = text(o); !value.empty()) lines += o.name + (" = " + value) + "\n";
  return lines;
}
static void check(const vector<Setting>& settings) {
  const Parameters p = resolve(settings);
  require(p.Rmin > 0 && p.Rmax >= p.Rmin && p.rho > 0 && p.E > 0 && p.dt > 0, "what must be > 0");
  require(p.nu > -1 && p.nu <= real(0.5) && p.en >= 0 && p.en <= 1, "nu and en are in range");
  require(p.mus >= 0 && p.mur >= 0 && p.mut >= 0 && p.eta >= 0, "what must be >= 0");
  for (const real R : p.Rmesh) require(R >= 0 && std::isfinite(R), "mesh radii");
  const string lines = listed(p);
  const auto back = read_scene(file_with(lines.data(), lines.size()));
  require(listed(resolve(back)) == lines, "the parameters come back");
}
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try_reading<InputError>(data, size, read_scene, check);
  return 0;
}
