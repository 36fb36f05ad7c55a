// Which texels a pass draws. Each pass owns a half-open range of alpha, so no texel is drawn by two colour passes.
uniform vec3 alpha_range;  // x <= alpha < y is drawn; from z on as fully opaque

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x || alpha >= alpha_range.y) discard;
#endif
  // Else all texels are in the range, and without a discard the depth test can come before the shading.
  return alpha >= alpha_range.z ? 1.0 : alpha;
}
