#!/bin/sh
# Draws hair that artists made, as it comes out of `coif cook` and `coif render` with nothing said.
#
#   sample_assets/artists/make_picture.sh COIF ASSETS [OUT]
#
# COIF is the program; ASSETS has the files that the README here names, which are not part of coif; OUT, by default this folder, gets
# artists.webp. ImageMagick puts the pictures together.
set -eu
coif=$1
assets=$2
out=${3:-$(cd "$(dirname "$0")" && pwd)}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

draw() { # NAME FILE, then what else is asked of `coif render`
  name=$1
  file=$assets/$2
  shift 2
  "$coif" cook "$file" -o "$work/$name.coif"
  "$coif" render "$work/$name.coif" "$@" --size 360x400 --view 35,5 -o "$work/$name.png"
}
draw bob hair/mh_bob01/bob01.obj
draw ponytail hair/mh_ponytail01/ponytail01.obj
draw braid hair/mh_braid01/braid01.obj
draw strands groom/amd_ponytail/ponytail_lines.obj
draw low_poly hair/quaternius_witch/Witch.glb --body "$assets/hair/quaternius_witch/Witch.glb"
draw avatar hair/godette/Godette_vrm_v4.vrm --body "$assets/hair/godette/Godette_vrm_v4.vrm"
(cd "$work" && montage bob.png ponytail.png braid.png strands.png low_poly.png avatar.png -tile 3x2 -geometry +4+4 -quality 85 \
  "$out/artists.webp")
