#!/bin/sh
# weekly.sh [--short] [PART ...]: what takes too long for every `./dem test`, two hours or so. Parts,
# all if none is named:
#   analysis   clang-tidy and cppcheck on the whole program, with part 4 and CLI11
#   asan       all tests and the hourglass with AddressSanitizer and UndefinedBehaviorSanitizer
#   tsan       the same with ThreadSanitizer
#   fuzz       arbitrary bytes as mesh, particles and scene, ten minutes each; what was found before
#              stays in build/fuzz, and the next time begins with it
#   mutants    the solver is broken on purpose in all ways: does a verification case notice?
# --short: no Python tests, 10 seconds of fuzzing, the mutants that `./dem test` has. What is not
# possible here, because a tool is missing, is a failure. Exit code 1 if a part fails.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
seconds=600 mutants=all tests='' failed=''
if [ "${1:-}" = --short ]; then
  seconds=10 mutants=fast tests='-E _py$'
  shift
fi
[ $# -gt 0 ] || set -- analysis asan tsan fuzz mutants
for part; do
  case $part in
    analysis | asan | tsan | fuzz | mutants) ;;
    *) echo "weekly.sh '$part': the parts are analysis, asan, tsan, fuzz, mutants" >&2; exit 2 ;;
  esac
done
cd "$root"
eigen=${EIGEN:-/usr/include/eigen3}
export TSAN_OPTIONS=ignore_noninstrumented_modules=1  # not the runtime of OpenMP, which is trusted

# try NAME COMMAND ...: run it, remember whether it failed.
try() {
  name=$1
  shift
  echo "weekly: $name: $*"
  "$@" || { echo "weekly: $name FAILED"; failed="$failed $name"; }
}

# hourglass PRESET: particles enter all the time, and are so many that three threads share the work;
# the results are the same bits for 2 and 3.
hourglass() {
  for threads in 2 3; do
    OMP_NUM_THREADS=$threads "build/$1/tinydem" --scene tinydem/scenes/hourglass/scene.ini \
      --Rmin 0.002 --Rmax 0.003 --Nmax 30000 --Nframes 6 --Nsteps 25 --Nspawn 600 --overwrite \
      '' '' "build/$1/hourglass_$threads" || return 1
  done
  for file in "build/$1/hourglass_2"/particles*.csv; do
    cmp "$file" "build/$1/hourglass_3/$(basename "$file")" || return 1
  done
}

# sanitized PRESET: build, test, run.
sanitized() {
  # shellcheck disable=SC2086  # two words
  cmake --preset "$1" && cmake --build --preset "$1" --parallel 2 &&
    ctest --preset "$1" $tests && hourglass "$1"
}

for part; do
  case $part in
    analysis) for tool in clang-tidy cppcheck; do
        try "$tool" sh tests/static_analysis.sh "$tool" -UTINYDEM_NO_MAIN "-I$eigen"
      done ;;
    asan | tsan) try "$part" sanitized "$part" ;;
    fuzz) for target in off csv scene; do
        try "fuzz_$target" sh tests/fuzz/fuzz.sh "$target" "$seconds" build/fuzz "$eigen"
      done ;;
    mutants) try mutants ./dem verify --mutants $mutants ;;
  esac
done
[ -z "$failed" ] || { echo "weekly: failed:$failed"; exit 1; }
echo 'weekly: all is well'
