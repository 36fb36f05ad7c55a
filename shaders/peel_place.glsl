// A texel's place in the order of its pixel: by depth, at one depth by its triangle's last vertex. Texels are peeled from
// the far one on.
uniform highp usampler2D peeled_layer;  // the texel drawn last: bits of its depth, corner
flat in int corner;

uint place_depth() { return floatBitsToUint(gl_FragCoord.z); }  // positive floats compare as their bits do
uint place_corner() { return uint(corner) & 0xFFFFFFu; }        // as many bits as a float holds exactly

bool is_peeled() {
  uvec2 last = texelFetch(peeled_layer, ivec2(gl_FragCoord.xy), 0).rg;
  return place_depth() > last.x || (place_depth() == last.x && place_corner() <= last.y);
}
