// Any bytes as an OFF file: refused, or a mesh whose numbers and indices are all in range.
#include "fuzz_support.hpp"
#include "tinydem.hpp"

using namespace tinydem;

static void check(const Mesh& mesh) {
  for (const Vec3& x : mesh.vertices)
    require(std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z), "vertices are finite");
  for (const Element& e : mesh.elements) {
    require(1 <= e.n && e.n <= 4, "a face has one to four vertices");
    require(0 <= e.group && e.group < 3, "a group is an index into Rmesh");
    for (int k = 0; k < e.n; ++k)
      require(0 <= e.vertex[k] && e.vertex[k] < count(mesh.vertices), "a vertex is in the file");
  }
}
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = [](const string& path) { return read_mesh(path, 3); };
  try_reading<InputError>(data, size, read, check);
  return 0;
}
