// What the fuzz targets share. A target reads arbitrary bytes as a file; a reader may refuse them
// with an InputError that names the file, and what it accepts must be usable. Anything else (a
// crash, another exception, an invalid value) is a finding. Ten minutes by hand, with clang++:
//
//   tests/fuzz/fuzz.sh off 600 build/fuzz /usr/include/eigen3
#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

/// Stops the fuzzer at the present input when something does not hold.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}
/// A file in memory with these bytes; the same path every time.
inline std::string file_with(const void* data, std::size_t size) {
  static const int file = memfd_create("input", 0);
  require(file >= 0 && ftruncate(file, 0) == 0, "a file in memory can be made");
  require(pwrite(file, data, size, 0) == static_cast<ssize_t>(size), "and written");
  return "/proc/self/fd/" + std::to_string(file);
}
/// Calls read(path) and use(result). A refusal must begin with the path, or with "default:" where a
/// value of the file makes a default wrong.
template <class Error, class Read, class Use>
void try_reading(const std::uint8_t* data, std::size_t size, Read read, Use use) {
  const std::string path = file_with(data, size);
  try {
    use(read(path));
  } catch (const Error& e) {
    const std::string message = e.what();
    require(message.rfind(path + ":", 0) == 0 || message.rfind("default: ", 0) == 0,
            "a message begins with the place");
  }
}
