#!/bin/sh
# Compiles a fuzz target with clang++ into a folder and runs it for some seconds, starting with the
# files of seeds/ and with what earlier runs left in FOLDER/corpus_TARGET.
# Usage: fuzz.sh TARGET SECONDS FOLDER EIGEN; TARGET is off, csv or scene
set -e
target=$1 seconds=$2 folder=$3 eigen=$4 program=$3/fuzz_$1
here=$(cd "$(dirname "$0")" && pwd)
source=$here/../../tinydem
flags="-std=c++17 -g1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all"

mkdir -p "$folder/corpus_$target"
echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
  clang++ -x c++ $flags -o "$folder/probe_$target" - 2>/dev/null ||
  { echo "no clang++ with libFuzzer; skipped"; exit 77; }
if [ -z "$(find "$program" -newer "$source/tinydem.hpp" -newer "$source/tinydem.cpp" \
           -newer "$here/fuzz_$target.cpp" -newer "$here/fuzz_support.hpp" 2>/dev/null)" ]; then
  clang++ $flags -O0 -DTINYDEM_NO_MAIN -D_GLIBCXX_ASSERTIONS -I"$source" -isystem "$eigen" \
    -o "$program" "$here/fuzz_$target.cpp"  # -O0: with sanitizers, -O1 compiles for minutes
fi
# libFuzzer ends with 77 at a finding, which ctest would take for skipped.
exec "$program" -error_exitcode=1 -max_total_time="$seconds" -rss_limit_mb=1024 \
  -timeout=60 -print_final_stats=1 -dict="$here/words.dict" \
  -artifact_prefix="$folder/finding_${target}_" \
  "$folder/corpus_$target" "$here/seeds/$target"
