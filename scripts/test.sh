#!/bin/bash
# Builds everything and runs all tests.
#
#   scripts/test.sh [PRESET]     PRESET: release (default), dev, asan, tsan, geometry-only
#
# JOBS sets how many compilers and tests run at once (default: one a core, at most one per 1.5 GB of memory).
set -euo pipefail
cd "$(dirname "$0")/.."
preset="${1:-release}"
source scripts/jobs.sh

scripts/install.sh --python
cmake --preset "$preset"
cmake --build --preset "$preset" -j "$jobs"

log="build/$preset/ctest.log"
result=0
# Tests of services wait more than they compute, but sanitizers make the others slow: two at once suit both.
ctest --preset "$preset" -j2 --no-tests=error 2>&1 | tee "$log" || result=$?
total=$(sed -n 's/.*tests failed out of \([0-9]*\).*/\1/p' "$log" | tail -1)
failed=$(sed -n 's/.*, \([0-9]*\) tests failed out of.*/\1/p' "$log" | tail -1)
skipped=$(grep -c '\*\*\*Skipped' "$log" || true)
if [[ -n "$total" ]]; then
  echo "$preset: $((total - failed - skipped)) passed, $failed failed, $skipped skipped"
fi
exit "$result"
