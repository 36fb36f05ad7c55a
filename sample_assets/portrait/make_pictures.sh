#!/bin/sh
# Makes all pictures of this folder: hair grows on the portrait, is cooked and drawn, and a moving picture is put together by
# ImageMagick.
#
#   sample_assets/portrait/make_pictures.sh COIF [OUT]
#
# COIF is the program; OUT, by default this folder, gets bob.png, wavy.png, turn.webp and presets.webp.
set -eu
coif=$1
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$here}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The recipes ask for one order of triangles: to find those for all directions takes minutes, and these pictures hardly show it.
for style in bob wavy; do
  "$coif" grow --recipe "$here/$style.recipe.json" -o "$work/$style.hair"
  "$coif" cook "$work/$style.hair" --recipe "$here/$style.recipe.json" -o "$work/$style.coif"
done
picture() { # STYLE, then what else is asked of `coif render`
  style=$1
  shift
  "$coif" render "$work/$style.coif" --body "$here/portrait.glb" "$@"
}
picture bob --size 720x800 --view 28,4 -o "$out/bob.png"
picture wavy --size 720x800 --view -26,2 -o "$out/wavy.png"

# The motion repeats at 1.54 Hz, and after two rounds so does the hair. Shown at half its speed.
frames=20
frame=0
while [ $frame -lt $frames ]; do
  time=$(awk "BEGIN { printf \"%.4f\", (2 + $frame / $frames) / 1.54 }")
  picture bob --size 420x460 --view 28,4 --samples 4 --motion turn --time "$time" -o "$work/$(printf %02d $frame).png" >"$work/log"
  frame=$((frame + 1))
done
convert -delay 6 -loop 0 "$work"/[0-9][0-9].png -quality 82 "$out/turn.webp"

# What each preset of `coif cook --list-presets` grows where there is no hair yet.
for preset in realistic anime stylised ponytail curly short; do
  cat >"$work/$preset.recipe.json" <<END
{"grow": {"strands": 9000}, "cards": {"rounds": 1}, "order": {"method": "head"}, "lods": {"levels": 1}}
END
  "$coif" cook "$work/$preset.recipe.json" --preset "$preset" --body "$here/portrait.glb" -o "$work/$preset.coif"
  picture "$preset" --size 360x400 --view 35,5 -o "$work/$preset.png"
done
(cd "$work" && montage -label %t realistic.png anime.png stylised.png ponytail.png curly.png short.png -tile 3x2 -geometry +4+4 \
  -quality 85 "$work/presets.webp")
cp "$work/presets.webp" "$out/presets.webp"
