#!/bin/bash
# Fills the holes of one mesh (OBJ or PLY): run.sh MESH OUT
set -euo pipefail
mesh="$1" out="$2"

tilemend inspect "$mesh"
tilemend fill "$mesh" --out "$out" || [[ $? == 100 ]]   # 100: some holes stay open
tilemend check "$out" || [[ $? == 100 ]]   # 100: faults were found, and named
