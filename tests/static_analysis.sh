#!/bin/sh
# static_analysis.sh TOOL [FLAG ...]: clang-tidy (checks and reasons: .clang-tidy) or cppcheck has
# nothing to say about the two files. 77 = no such tool, or another version: every version has other
# checks. -DTINYDEM_NO_MAIN leaves out part 4, which includes CLI11: less than half the time.
#   tests/static_analysis.sh clang-tidy -I/usr/include/eigen3
set -eu
tool=$1
shift
case $tool in
  clang-tidy) known='version 14.' ;;
  cppcheck) known='Cppcheck 2.10' ;;
  *) echo "static_analysis.sh '$tool': use clang-tidy or cppcheck" >&2; exit 2 ;;
esac
"$tool" --version 2> /dev/null | grep -qF "$known" || { echo "skipped: no $tool, $known"; exit 77; }
cd "$(dirname "$0")/../tinydem"
if [ "$tool" = clang-tidy ]; then
  exec clang-tidy --quiet tinydem.cpp -- -std=c++17 -fopenmp "$@"
fi
# Suppressed, because all findings (in 2.10) are as we want it:
#   constParameter, constVariable  auto& is const where that which it names is
#   knownConditionTrueFalse        return a = b, true;
#   noExplicitConstructor          our vector is made from std::vector, to look the same
#   shadowFunction                 a local variable may have the name of a function elsewhere
#   unusedStructMember             used in templates, or by structured bindings: not seen
#   useStlAlgorithm                a loop of one line says the same
exec cppcheck --quiet --error-exitcode=1 --std=c++17 --language=c++ \
  --enable=warning,style,performance,portability \
  --suppress=constParameter --suppress=constVariable --suppress=knownConditionTrueFalse \
  --suppress=noExplicitConstructor --suppress=shadowFunction \
  --suppress=unusedStructMember --suppress=useStlAlgorithm "$@" tinydem.cpp
