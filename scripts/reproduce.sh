#!/usr/bin/env bash
# Repeats the experiments of the papers and writes docs/papers.md; --help says what can be chosen.
set -euo pipefail
cd "$(dirname "$0")/.."
exec /usr/bin/python3 tests/bench/reproduce.py "$@"
