#!/bin/bash
# Builds the Debian package and prints its path and the command that installs it.
#
#   scripts/package.sh [FOLDER]     FOLDER: where the package is put (default: build/packages)
#
# JOBS sets how many compilers run at once.
set -euo pipefail
if [[ $# -gt 1 || "${1:-}" == -* ]]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  [[ "${1:-}" == --help ]] && exit 0
  exit 2
fi
folder="$(realpath -m "${1:-$(dirname "$0")/../build/packages}")"
cd "$(dirname "$0")/.."
source scripts/jobs.sh

scripts/install.sh --package
mkdir -p build "$folder"
cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }
cmake --build --preset release -j "$jobs" \
  --target tilemend tilemend-coordinator tilemend-worker tilemend_gdal tilemend_manuals

log=build/release/cpack.log
cpack -G DEB --config build/release/CPackConfig.cmake -B "$folder" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
rm -rf "$folder/_CPack_Packages"
package=$(sed -n 's/^CPack: - package: \(.*\.deb\) generated\.$/\1/p' "$log")

echo
echo "Package:  $package"
echo "Install:  sudo apt-get install $package"
