#!/bin/sh
# vectorized.sh COMPILER [FLAG ...]: the loops that are marked so become vector instructions with the
# plain compiler line, on every instruction set. A change of the contact law that the compiler cannot
# vectorize is right, but several times slower. 77 = the compiler cannot tell.
set -eu
compiler=$1
shift
"$compiler" --version | grep -qE 'Free Software Foundation' || { echo "skipped: not GCC"; exit 77; }
[ "$(uname -m)" = x86_64 ] || { echo "skipped: not x86_64"; exit 77; }
cd "$(dirname "$0")/../tinydem"
for real in double float; do
  report=$("$compiler" -std=c++17 -O3 "$@" -DTINYDEM_NO_MAIN -DTINYDEM_REAL=$real -S -o /dev/null \
    -fopt-info-vec-optimized tinydem.cpp 2>&1)
  for line in $(grep -n 'becomes vector instructions' tinydem.cpp | cut -d: -f1); do
    for bytes in 16 32 64; do
      echo "$report" | grep -q "tinydem.cpp:$line:.*loop vectorized using $bytes byte" ||
        { echo "tinydem.cpp:$line: $real: not vectorized for $bytes bytes"; exit 1; }
    done
  done
done
