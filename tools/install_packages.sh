#!/bin/sh
# Installs those packages of the named groups of tools/packages.txt that are missing; does nothing, and needs no rights,
# when all are there.
#   tools/install_packages.sh GROUP...     program, tests, farm, web, blender, fuzz, variants, style
set -eu
list=$(dirname "$0")/packages.txt

# packages GROUP: the lines under [GROUP], up to the next group.
packages() { sed -n "/^\[$1\]\$/,/^\[/{/^[a-z]/p}" "$list"; }

wanted=
for group in "$@"; do
  found=$(packages "$group")
  [ -n "$found" ] || { echo "install_packages: $list has no group '$group'" >&2; exit 1; }
  wanted="$wanted $found"
done
[ -n "$wanted" ] || { echo "install_packages: name the groups, of$(sed -n 's/^\[\(.*\)\]$/ \1/p' "$list" | tr -d '\n')" >&2; exit 1; }

if ! command -v apt-get >/dev/null; then
  echo "install_packages: no apt-get on this system; the build needs what $list lists" >&2
  exit 0
fi

# Names that installed packages go by besides their own: other builds of nodejs are npm, too.
provided=$(dpkg-query -W -f '${db:Status-Abbrev}, ${Provides}\n' | sed -n 's/^ii ,//p' | tr ',' '\n' | sed 's/(.*//; s/ //g')
missing=
for package in $wanted; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
    echo "$provided" | grep -qxF "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  as_root=sudo
  command -v sudo >/dev/null || { echo "install_packages: as root, run: apt-get install$missing" >&2; exit 1; }
fi
echo "installing:$missing"
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
# $missing is a list: it must fall apart into words.
$as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
