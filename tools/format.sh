#!/bin/sh
# Puts every C++ and C file of the project into the one form that .clang-format describes.
#   tools/format.sh            rewrites what is in another form
#   tools/format.sh --check    names it and fails, changing nothing
set -eu
cd "$(dirname "$0")/.."
sh tools/install_packages.sh style

case ${1-} in
  "") how=-i ;;
  --check) how='--dry-run --Werror' ;;
  *) echo "usage: tools/format.sh [--check]" >&2; exit 1 ;;
esac
# shellcheck disable=SC2086  # two words
git ls-files -z '*.h' '*.cpp' '*.c' | xargs -0 -n 50 -P "$(nproc)" clang-format $how
