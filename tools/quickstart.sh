#!/bin/sh
# From a fresh checkout to a picture and a page: installs what is missing, builds the coif program, cooks hair that grows on
# the portrait, simulates it and draws it. Everything it makes lies in out/.
set -eu
cd "$(dirname "$0")/.."
sh tools/install_packages.sh program

echo "building the coif program"
cmake --preset release -DCOIF_TESTS=OFF >/dev/null
cmake --build --preset release --parallel "$(nproc)" --target coif_cli

coif=build/release/tools/cli/coif
sample=sample_assets/portrait
mkdir -p out
# Hair grows on the portrait by its recipe. A draft takes a fraction of the time and looks nearly the same.
"$coif" cook "$sample/bob.recipe.json" --draft -o out/portrait.coif
"$coif" simulate out/portrait.coif --motion turn -o out/portrait_turn.glb
"$coif" simulate out/portrait.coif --motion turn -o out/portrait_turn.csv
"$coif" render out/portrait.coif --body "$sample/portrait.glb" --size 540x600 --samples 4 --view 28,4 -o out/portrait.png
"$coif" view out/portrait.coif --body "$sample/portrait.glb" --motion turn -o out/portrait.html

cat <<EOF

out/portrait.coif       the cooked asset: what a game loads
out/portrait_turn.glb   the head shaken, as an animation: open it in Blender or any glTF viewer
out/portrait_turn.csv   the same as positions: one row per frame and bone
out/portrait.png        the picture, drawn by the runtime's own renderer
out/portrait.html       the head to turn, shake and tune: open it in a browser

Next:
  $coif info out/portrait.coif
  $coif view $sample/bob.recipe.json --body $sample/portrait.glb    the same page, which cooks again when you change the recipe
  $coif render out/portrait.coif --body $sample/portrait.glb --motion turn --time 0.4 --view 140,10 -o out/portrait_back.png
  $coif cook YOUR_MODEL.fbx --list                       what hair, head and bones are called there
  $coif cook YOUR_MODEL.fbx -o out/yours.coif
EOF
