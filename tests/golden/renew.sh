#!/bin/sh
# Takes the golden pictures anew. Look at each before it is committed: whatever is in them counts as right from then on.
#
# usage: tests/golden/renew.sh BUILD_FOLDER
set -eu
build=${1:?usage: tests/golden/renew.sh BUILD_FOLDER}
source=$(cd "$(dirname "$0")/../.." && pwd)
sample=$(mktemp -d)
trap 'rm -r "$sample"' EXIT
cmake --build "$build" --target coif_cli coif_write_golden
"$build/tools/cli/coif" cook "$source/sample_assets/bob/bob.glb" -o "$sample/bob.coif"
"$build/tests/coif_write_golden" "$sample/bob.coif" "$source/tests/golden"
ls -l "$source"/tests/golden/*.png
