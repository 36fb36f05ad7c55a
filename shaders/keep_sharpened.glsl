// How much of a pixel lies inside the line where alpha crosses the cut, for alpha to coverage: over the width of one pixel
// it goes from 0 to 1, however slowly the texture's own alpha changes there.
uniform vec3 alpha_range;  // x: the cut

const float kLeastWidth = 1e-4;  // of a pixel, in alpha: where alpha does not change the cut is a step

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  float inside = (alpha - alpha_range.x) / max(fwidth(alpha), kLeastWidth) + 0.5;
  if (inside <= 0.0) discard;
  return min(inside, 1.0);
#else
  return 1.0;
#endif
}
