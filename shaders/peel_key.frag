// Of the texels at the depth that was found, finds the one that comes first: the depth buffer keeps the lowest corner.
// After peel_place.glsl.
uniform highp usampler2D found_layer;
in vec2 uv;
out uvec2 found;

void main() {
  keep(base_at(uv).a);
  if (is_peeled() || place_depth() != texelFetch(found_layer, ivec2(gl_FragCoord.xy), 0).r) discard;
  found = uvec2(place_depth(), place_corner());
  gl_FragDepth = float(place_corner()) / 16777216.0;
}
