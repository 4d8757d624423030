#!/bin/bash
# Builds tilemend, makes a scene with lakes, a river and small holes, fills it and draws it before and after.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/jobs.sh

steps=5
step=0
# Prints which step begins, after how many seconds.
begin() { step=$((step + 1)); echo "[$step/$steps] $1 (${SECONDS} s since the start)"; }

begin "Install the Debian packages that are missing; next: configure"
scripts/install.sh

begin "Configure the build; next: compile (everything the first time, seconds if nothing changed)"
mkdir -p build
cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }

begin "Compile tilemend with $jobs compilers; next: make the scene"
NINJA_STATUS='      %f of %t compiled, %e s: ' cmake --build --preset release -j "$jobs" --target tilemend tilemend-make-scene

begin "Make a scene of 30 cells; next: fill it"
bin=build/release/bin
rm -rf demo/scene
"$bin/tilemend-make-scene" demo/scene --cols 6 --rows 5 --cell 250 --spacing 2.5 --seed 7 \
  --holes lakes,islands,river,small --small-per-cell 3 --empty 4:3

begin "Fill the scene and draw it before and after; then the demonstration is done"
# 100: done, but some holes were left open; report.json says which and why.
result=0
"$bin/tilemend" run demo/scene --out demo/out --overwrite || result=$?
if [[ $result -ne 0 && $result -ne 100 ]]; then exit "$result"; fi

scripts/render.py demo/scene demo/out demo/before_after.png --grid --width 1200
cat <<'END'

Before and after:  demo/before_after.png   (filled surface in blue)
Filled tiles:      demo/out/tiles/         (faces with tilemend_filled = 1 are new)
Report:            demo/out/report.json
END
