#!/bin/bash
# Prints which share of the lines of each folder the tests run, and fails where it is below the least.
#
#   scripts/coverage.sh
#
# Builds the preset coverage and runs its tests: all but those that start the programs. So the programs' main.cc do not
# count. JOBS as in scripts/test.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
least=90  # percent
source scripts/jobs.sh

scripts/install.sh --coverage
cmake --preset coverage
cmake --build --preset coverage -j "$jobs"
# What is left of earlier runs, and of sources that are no more.
find build/coverage -name '*.gcda' -delete
ninja -C build/coverage -t cleandead >/dev/null
find build/coverage -name '*.gcno' | while read -r notes; do
  [[ -e "${notes%.gcno}.o" ]] || rm "$notes"
done
echo "The whole output of the tests: build/coverage/ctest.log"
ctest --preset coverage -j2 --no-tests=error 2>&1 | tee build/coverage/ctest.log | tail -20

gcovr --root . --object-directory build/coverage --filter 'common/' --filter 'worker/' --filter 'coordinator/' \
  --exclude '.*/main\.cc' --csv build/coverage/coverage.csv build/coverage
awk -F, -v least="$least" '
  function add(name) {lines[name] += $2; covered[name] += $3}
  NR > 1 {folder = $1; sub("/[^/]*$", "", folder); add(folder); add("all")}
  END {
    if (!("all" in lines)) {
      print "coverage.csv has no rows" > "/dev/stderr"
      exit 1
    }
    for (name in lines) {
      share = lines[name] > 0 ? 100 * covered[name] / lines[name] : 100
      printf "%-28s %6d lines %6.1f %%%s\n", name, lines[name], share, share < least ? "  below " least " %" : "" | "sort"
      if (share < least) failed = 1
    }
    close("sort")
    exit failed
  }' build/coverage/coverage.csv
