// Hashed alpha testing (Wyman and McGuire, "Hashed Alpha Testing", I3D 2017): a soft texel is drawn, solid, where its
// alpha is above a threshold that is a hash of its place on the hair at rest. The pattern is fixed to the hair, whatever
// the bones and the camera do, and its grain has about the size of a pixel.
uniform vec3 alpha_range;  // from x on drawn, from z on in every pixel
in vec3 rest_place;        // metres, head space

uint scattered(uint value) {
  value = (value ^ value >> 16) * 0x7FEB352Du;
  value = (value ^ value >> 15) * 0x846CA68Bu;
  return value ^ value >> 16;
}

// Even in 0..1 over the cells of a grid.
float hash_of_cell(vec3 cell) {
  ivec3 c = ivec3(floor(cell));
  uint bits = scattered(uint(c.x) ^ scattered(uint(c.y) ^ scattered(uint(c.z))));
  return float(bits >> 8) / 16777216.0;
}

// Of the paper's section 4, with a width for each axis: hair is mostly seen at a slant, and a grid as coarse as its widest
// side would show. Cells are powers of two in size, and between two sizes the hashes are mixed. The sum of two even numbers
// is not even; its distribution function makes it so again.
float hashed_threshold(vec3 place) {
  vec3 width = max(abs(dFdx(place)), abs(dFdy(place)));  // metres of the hair to a pixel
  vec3 level = -log2(max(width, vec3(1e-7)));
  vec3 coarse = floor(level);
  float share = dot(level - coarse, vec3(1.0 / 3.0));  // of the finer grid
  float mixed = mix(hash_of_cell(exp2(coarse) * place), hash_of_cell(exp2(coarse + 1.0) * place), share);
  float least = min(share, 1.0 - share);
  float rest = 1.0 - least;
  float scale = 1.0 / max(2.0 * least * rest, 1e-6);
  if (mixed < least) return mixed * mixed * scale;
  if (mixed > rest) return 1.0 - (1.0 - mixed) * (1.0 - mixed) * scale;
  return (mixed - 0.5 * least) / rest;
}

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  float threshold = hashed_threshold(rest_place);  // before any discard: it needs the neighbours' places
  if (alpha < alpha_range.x) discard;
  if (alpha < alpha_range.z && alpha < threshold) discard;
#endif
  return 1.0;
}
