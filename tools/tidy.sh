#!/bin/sh
# Asks clang-tidy, by the checks in .clang-tidy, about the sources named, or about all; fails where it finds anything.
#   tools/tidy.sh [FILE.cpp...]     all of them take an hour of two cores
set -eu
cd "$(dirname "$0")/.."
sh tools/install_packages.sh program tests tidy
cmake --preset tidy >/dev/null

# clang knows neither of these flags of g++.
commands=build/tidy/compile_commands.json
sed -i 's/ -fno-tree-[a-z-]*//g; s/ -fno-move-loop-invariants//g; s/ -mno-fma4//g' "$commands"

if [ $# -eq 0 ]; then
  # What the build makes itself, such as embedded texts, is nobody's to mend.
  set -- $(sed -n 's|^ *"file": "\(.*\)".*|\1|p' "$commands" | grep -v "^$PWD/build/" | sort -u)
fi
printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" clang-tidy-16 -p build/tidy --quiet 2>/dev/null
