#!/bin/bash
# Fills a folder of tiles: run.sh SCENE OUT
set -euo pipefail
[[ $# -eq 2 ]] || { sed -n 2p "$0" >&2; exit 2; }
scene="$1" out="$2"

tilemend inspect "$scene"            # the grid, the holes and what they would be filled as
tilemend run "$scene" --out "$out" --dry-run

# 100: done, but some holes stay open; the report says which and why.
result=0
tilemend run "$scene" --out "$out" || result=$?
[[ $result == 0 || $result == 100 ]] || exit "$result"

tilemend check "$out" || [[ $? == 100 ]]   # 100: faults were found, and named
