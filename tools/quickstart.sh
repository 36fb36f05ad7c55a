#!/bin/sh
# From a fresh checkout to a picture: installs what is missing, builds the coif program, cooks the sample, simulates it
# and draws it. Everything it makes lies in out/.
set -eu
cd "$(dirname "$0")/.."
sh tools/install_packages.sh program

echo "building the coif program"
cmake --preset release -DCOIF_TESTS=OFF >/dev/null
cmake --build --preset release --parallel "$(nproc)" --target coif_cli

coif=build/release/tools/cli/coif
sample=sample_assets/bob/bob.glb
mkdir -p out
"$coif" cook "$sample" -o out/bob.coif
"$coif" simulate out/bob.coif --motion turn -o out/bob_turn.glb
"$coif" simulate out/bob.coif --motion turn -o out/bob_turn.csv
"$coif" render out/bob.coif --body "$sample" --size 1024x768 -o out/bob.png

cat <<EOF

out/bob.coif       the cooked asset: what a game loads
out/bob_turn.glb   the head shaken, as an animation: open it in Blender or any glTF viewer
out/bob_turn.csv   the same as positions: one row per frame and bone
out/bob.png        the picture, drawn by the runtime's own renderer

Next:
  $coif info out/bob.coif
  $coif render out/bob.coif --body $sample --motion turn --time 0.4 --view 140,10 -o out/bob_back.png
  $coif cook YOUR_MODEL.fbx --list                     what hair, head and bones are called there
  $coif cook YOUR_MODEL.fbx -o out/yours.coif
EOF
