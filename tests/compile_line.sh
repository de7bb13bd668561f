#!/bin/sh
# compile_line.sh COMPILER [FLAG ...]: the two files alone, in a directory with nothing else, build
# with the one line of the README and the program starts. 77 = no such compiler.
#   tests/compile_line.sh g++ -fopenmp -I/usr/include/eigen3
set -eu
compiler=$1
shift
command -v "$compiler" > /dev/null || { echo "skipped: no $compiler"; exit 77; }
solver=$(cd "$(dirname "$0")/../tinydem" && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cp "$solver/tinydem.hpp" "$solver/tinydem.cpp" "$dir"
cd "$dir"
echo "$compiler -std=c++17 -O3 $* -o tinydem tinydem.cpp"
"$compiler" -std=c++17 -O3 "$@" -o tinydem tinydem.cpp
./tinydem --version
