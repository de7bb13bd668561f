#!/bin/sh
# warnings_clean.sh COMPILER [FLAG ...]: no warning in our own code, as program and as library.
# Optimized, because some warnings come from the optimizer. 77 = no such compiler, or no OpenMP.
#   tests/warnings_clean.sh g++ -Wall -Wextra -isystem /usr/include/eigen3
set -eu
compiler=$1
shift
echo '#include <omp.h>' | "$compiler" -fopenmp -x c++ -E - > /dev/null 2>&1 ||
  { echo "skipped: no $compiler with OpenMP"; exit 77; }
cd "$(dirname "$0")/../tinydem"
"$compiler" -std=c++17 -O2 -fopenmp -Werror "$@" -c -o /dev/null tinydem.cpp
"$compiler" -std=c++17 -fopenmp -Werror "$@" -DTINYDEM_NO_MAIN -fsyntax-only tinydem.cpp
