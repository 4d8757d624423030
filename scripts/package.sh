#!/bin/bash
# Builds the Debian packages tilemend and python3-tilemend, and a wheel. Prints their paths and how to install them.
#
#   scripts/package.sh [FOLDER]     FOLDER: where they are put (default: build/packages)
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

scripts/install.sh --package --python
mkdir -p build "$folder"

# Configures the preset $1 and builds the targets that follow.
build() {
  local preset=$1; shift
  cmake --preset "$preset" >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }
  cmake --build --preset "$preset" -j "$jobs" --target "$@"
}

# Prints the path of the Debian package that the tree of preset $1 makes.
pack() {
  local log=build/$1/cpack.log
  cpack -G DEB --config "build/$1/CPackConfig.cmake" -B "$folder" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
  rm -rf "$folder/_CPack_Packages"
  sed -n 's/^CPack: - package: \(.*\.deb\) generated\.$/\1/p' "$log"
}

build release tilemend tilemend-coordinator tilemend-worker tilemend_gdal tilemend_manuals
package=$(pack release)
build python tilemend_python_package
python_package=$(pack python)
wheel_log=build/python/wheel.log
JOBS=$jobs /usr/bin/python3 -m build --wheel --no-isolation --outdir "$folder" python >"$wheel_log" 2>&1 ||
  { cat "$wheel_log" >&2; exit 1; }
wheel=$folder/$(sed -n 's/^Successfully built //p' "$wheel_log")

echo
echo "Package:  $package"
printf 'Install:  sudo apt-get install %q\n' "$package"
printf 'Python:   sudo apt-get install %q\n' "$python_package"
printf 'Wheel:    pip install %q\n' "$wheel"
