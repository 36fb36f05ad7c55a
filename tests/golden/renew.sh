#!/bin/sh
# Takes the golden pictures, the recipe and the fingerprints of cooks anew. Look at each picture before it is committed, and know why each
# fingerprint changed: whatever is in them counts as right from then on.
#
# usage: tests/golden/renew.sh BUILD_FOLDER
set -eu
build=${1:?usage: tests/golden/renew.sh BUILD_FOLDER}
source=$(cd "$(dirname "$0")/../.." && pwd)
sample=$(mktemp -d)
trap 'rm -r "$sample"' EXIT
cmake --build "$build" --target coif_cli coif_write_golden coif_golden_test coif_cook_test
"$build/tools/cli/coif" cook "$source/sample_assets/bob/bob.glb" -o "$sample/bob.coif"
"$build/tests/coif_write_golden" "$sample/bob.coif" "$source/tests/golden"
"$build/tools/cli/coif" cook --print-recipe >"$source/tests/golden/recipe.json"
COIF_RENEW_COOKS=$sample/cooks.txt
export COIF_RENEW_COOKS
(cd "$build" && ctest --output-on-failure -R '^(GoldenCook|CookFingerprint|LongSample[.]Cooks)')
LC_ALL=C sort "$sample/cooks.txt" >"$source/tests/golden/cooks.txt"
ls -l "$source"/tests/golden
