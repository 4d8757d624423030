#!/bin/bash
# Checks format, the protocol and, with clang-tidy, the sources of a configured preset.
#
#   scripts/lint.sh [PRESET] [--format-only]
#
# PRESET is `no-pch` by default: clang-tidy cannot read GCC's precompiled headers, and looks at each source alone.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=no-pch
format_only=false
for argument in "$@"; do
  if [[ "$argument" == --format-only ]]; then format_only=true; else preset="$argument"; fi
done

scripts/install.sh --lint
git ls-files -z '*.cc' '*.h' | xargs -0 clang-format --dry-run -Werror
echo "clang-format: clean"
/usr/bin/python3 scripts/lint_protos.py
if $format_only; then exit 0; fi

source scripts/jobs.sh
cmake --preset "$preset" >/dev/null
# Generated headers must be there before a source that includes them can be checked.
if ninja -C "build/$preset" -t targets all | grep '^tilemend_proto:' >/dev/null; then
  cmake --build --preset "$preset" -j "$jobs" --target tilemend_proto
fi
# Only our own sources: generated ones lie in the build folder.
run-clang-tidy -quiet -j "$jobs" -p "build/$preset" "^$PWD/(common|worker|coordinator|client|tests)/.*\\.cc\$" 2>&1 |
  sed '/warnings\? generated/d'
echo "clang-tidy: clean"
