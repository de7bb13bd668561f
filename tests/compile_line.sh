#!/bin/sh
# compile_line.sh COMPILER [FLAG ...]: the two files alone, in a directory with nothing else, build
# with the one line of the README, and the program writes the particles that it has read. An optimizer
# may find what the other tests do not: they are built by one compiler. 77 = no such compiler.
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
cat > grains.csv << END
x,y,z,R,vx,vy,vz,q0,q1,q2,q3,wx,wy,wz
1.5,-2,0.25,0.125,4,-5.5,6,0.5,0.5,-0.5,0.5,7,8,-9.5
-1.5,2,-0.25,0.5,-4,5.5,-6,1,0,0,0,-7,-8,9.5
END
./tinydem '' grains.csv output --quiet --Nspawn 0 --Nframes 0
diff grains.csv output/particles000000.csv
