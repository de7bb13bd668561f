#!/bin/sh
# install_consumer.sh BUILD_DIR COMPILER: after an install into an empty prefix, the program runs
# and somebody else's CMake project finds the package, compiles against it and runs.
set -eu
build=$1 compiler=$2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cmake --install "$build" --prefix "$dir/prefix" > "$dir/install.log"
"$dir/prefix/bin/tinydem" --version
for file in src/tinydem.hpp src/tinydem.cpp scenes/hourglass/scene.ini; do
  [ -f "$dir/prefix/share/tinydem/$file" ] || { echo "not installed: $file"; exit 1; }
done

mkdir "$dir/consumer"
cat > "$dir/consumer/CMakeLists.txt" << 'END'
cmake_minimum_required(VERSION 3.22)
project(consumer LANGUAGES CXX)
find_package(TinyDEM 0.1 REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE tinydem::tinydem)
if(CMAKE_SYSTEM_NAME STREQUAL Linux)  # link all of it: whatever it needs must have come along
  target_link_options(consumer PRIVATE -Wl,--whole-archive $<TARGET_FILE:tinydem::tinydem>
    -Wl,--no-whole-archive)
endif()
END
cat > "$dir/consumer/main.cpp" << 'END'
#include "tinydem.hpp"
int main() { return tinydem::real(1) / 2 == tinydem::real(0.5) ? 0 : 1; }
END
cmake -S "$dir/consumer" -B "$dir/consumer/build" "-DCMAKE_PREFIX_PATH=$dir/prefix" \
  "-DCMAKE_CXX_COMPILER=$compiler"
cmake --build "$dir/consumer/build"
"$dir/consumer/build/consumer"
