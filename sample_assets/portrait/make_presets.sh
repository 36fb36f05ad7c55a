#!/bin/sh
# Makes presets.webp: what each of the presets of `coif cook --list-presets` is for, on hair that grows on the portrait.
#
#   sample_assets/portrait/make_presets.sh COIF [OUT]
#
# COIF is the program; OUT, by default this folder, gets presets.webp.
set -eu
coif=$1
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$here}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for shown in realistic:wavy anime:fringe_bob stylised:bob ponytail:ponytail curly:curly short:short; do
  preset=${shown%:*}
  cat >"$work/$preset.recipe.json" <<END
{"grow": {"style": "${shown#*:}", "strands": 9000}, "cards": {"rounds": 2}, "order": {"method": "head"}, "lods": {"levels": 1}}
END
  "$coif" cook "$work/$preset.recipe.json" --preset "$preset" --body "$here/portrait.glb" -o "$work/$preset.coif"
  "$coif" render "$work/$preset.coif" --body "$here/portrait.glb" --size 360x400 --view 35,5 -o "$work/$preset.png"
done
cd "$work"
montage -label %t realistic.png anime.png stylised.png ponytail.png curly.png short.png -tile 3x2 -geometry +4+4 \
  -quality 85 "$out/presets.webp"
