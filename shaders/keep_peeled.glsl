// Draws the one texel of each pixel that was peeled last. After peel_place.glsl.
uniform vec3 alpha_range;  // x <= alpha < y is drawn

float keep(float alpha) {
  uvec2 last = texelFetch(peeled_layer, ivec2(gl_FragCoord.xy), 0).rg;
  if (last != uvec2(place_depth(), place_corner()) || alpha < alpha_range.x || alpha >= alpha_range.y) discard;
  return alpha;
}
