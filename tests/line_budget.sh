#!/bin/sh
# line_budget.sh LINES: the two files of the solver together have at most so many, and none is wide.
set -eu
cd "$(dirname "$0")/../tinydem"
lines=$(cat tinydem.hpp tinydem.cpp | wc -l)
echo "tinydem.hpp and tinydem.cpp have $lines lines, $1 are allowed"
awk 'length > 100 { print FILENAME ":" FNR ": more than 100 columns"; wide = 1 } END { exit wide }' \
  tinydem.hpp tinydem.cpp
[ "$lines" -le "$1" ]
