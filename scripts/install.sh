#!/bin/bash
# Installs the Debian packages of packages.txt that are missing; quick if none is.
#
#   install.sh               what building and testing need
#   install.sh --lint        the lint tools as well
#   install.sh --coverage    the tools that measure coverage as well
#   install.sh --package     the tools that make the Debian package as well
#   install.sh --python      what the Python package needs as well
#   install.sh --check       prints those that are missing, and installs none
#
# Several may be given.
set -euo pipefail
list="$(dirname "$0")/packages.txt"

# What stands before the first section, and the sections that are asked for.
wanted=$(awk -v sections=" $* " '
  /^# \[/ {name = "--" substr($2, 2, length($2) - 2)}
  !/^(#|$)/ && (name == "" || index(sections, " " name " "))' "$list")

if ! command -v dpkg-query >/dev/null; then
  echo "install.sh: not a Debian system; install these yourself: $(echo $wanted)" >&2
  exit 0
fi

have=$(dpkg-query -W -f '${db:Status-Abbrev}|${Package}\n' 2>/dev/null | sed -n 's/^ii *|//p' | sort -u)
missing=$(comm -23 <(sort -u <<<"$wanted") <(echo "$have"))
[[ -z "$missing" ]] && exit 0
if [[ " $* " == *" --check "* ]]; then
  echo "$missing"
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null || { echo "install.sh: missing, and neither root nor sudo: $(echo $missing)" >&2; exit 1; }
  as_root=(sudo)
fi
echo "Installing: $(echo $missing)" >&2
"${as_root[@]}" apt-get update -q >&2
# shellcheck disable=SC2086  # a list of words
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing >&2
