#!/bin/sh
# precision.sh PROGRAM: a build in another precision runs 100 steps of the hourglass and writes
# frames without a NaN.
set -eu
program=$1
root=$(cd "$(dirname "$0")/.." && pwd)
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
"$program" '' '' "$dir/out" --scene "$root/tinydem/scenes/hourglass/scene.ini" \
  --Nframes 1 --Nsteps 100
for frame in "$dir/out/particles000000.csv" "$dir/out/particles000001.csv"; do
  [ -s "$frame" ] || { echo "missing or empty: $frame"; exit 1; }
  if grep -niE 'nan|inf' "$frame"; then echo "not finite: $frame"; exit 1; fi
done
