// Any bytes as a particle file: refused, or particles with R > 0 and unit quaternions that come
// back bit for bit when they are written and read again.
#include <cstring>

#include "fuzz_support.hpp"
#include "tinydem.hpp"

using namespace tinydem;

static void check(const vector<Particle>& all) {
  string again = string(csv_header) + "\n";
  for (const Particle& a : all) {
    real norm2 = 0;
    for (const real q : a.q) norm2 += q * q;
    require(a.R > 0, "radii are positive");
    require(std::abs(std::sqrt(norm2) - 1) < real(1e-3), "quaternions have norm 1");
    for (int k = 0; k < 14; ++k) {
      require(std::isfinite((&a.x.x)[k]), "numbers are finite");
      again += (k == 0 ? "" : ",") + text((&a.x.x)[k]);
    }
    again += "\n";
  }
  const auto back = read_particles(file_with(again.data(), again.size()));
  require(back.size() == all.size(), "as many particles come back");
  for (size_t k = 0; k < all.size(); ++k)
    require(std::memcmp(&back[k], &all[k], sizeof(Particle)) == 0, "bit for bit");
}
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try_reading<InputError>(data, size, read_particles, check);
  return 0;
}
