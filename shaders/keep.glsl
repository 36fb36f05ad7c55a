// Which texels are drawn, and how much of a pixel each covers: one piece for each way to draw hair that lets light
// through.

//// keep_range.glsl
// Which texels a pass draws. Each pass owns a half-open range of alpha, so no texel is drawn by two colour passes.
uniform vec3 alpha_range;  // x <= alpha < y is drawn; from z on as fully opaque

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x || alpha >= alpha_range.y) discard;
#endif
  // Else all texels are in the range, and without a discard the depth test can come before the shading.
  return alpha >= alpha_range.z ? 1.0 : alpha;
}

//// keep_sharpened.glsl
// How much of a pixel lies inside the line where alpha crosses the cut, for alpha to coverage: over the width of one
// pixel it goes from 0 to 1, however slowly the texture's own alpha changes there.
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

//// coverage_output.glsl
// Writes a colour whose alpha the rasterizer turns into a number of samples. Those get the whole colour, so it is not
// multiplied with alpha here.
out vec4 fragment;

void write_fragment(vec3 linear, float coverage) { fragment = vec4(encoded(linear), coverage); }

//// keep_proportional.glsl
// Alpha to coverage (the thesis's 4.1.2) without its random pattern: of a pixel's samples as many as come nearest to
// the texel's alpha. The number is told as an exact share, since drivers may round any other up or down.
uniform vec3 alpha_range;  // from x on drawn; y: samples of a pixel; from z on all of them

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  if (alpha >= alpha_range.z) return 1.0;
  float samples = floor(alpha * alpha_range.y + 0.5);
  if (samples < 0.5) discard;
  return samples / alpha_range.y;
#else
  return 1.0;
#endif
}

//// scattered.glsl
// Integers that have nothing to do with each other.
uint scattered(uint value) {
  value = (value ^ value >> 16) * 0x7FEB352Du;
  value = (value ^ value >> 15) * 0x846CA68Bu;
  return value ^ value >> 16;
}

//// keep_jittered.glsl after scattered.glsl
// Alpha to coverage by a random pattern (the thesis's 4.1.2, and the jitter of its Figure 16): the number of samples is
// rounded up or down at random, each pixel and triangle for itself, so that on average it is what alpha says.
uniform vec3 alpha_range;  // from x on drawn; y: samples of a pixel; from z on all of them
flat in int corner;        // the triangle's last vertex

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  if (alpha >= alpha_range.z) return 1.0;
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  float random = float(scattered(pixel.x ^ scattered(pixel.y ^ scattered(uint(corner)))) >> 8) / 16777216.0;
  float samples = floor(alpha * alpha_range.y + random);
  if (samples < 0.5) discard;
  return samples / alpha_range.y;
#else
  return 1.0;
#endif
}

//// keep_masked.glsl after scattered.glsl
// The same where a shader may say which samples are drawn (OpenGL ES 3.2): so many of them from a random one on, so
// that what two surfaces leave out has nothing to do with each other.
uniform vec3 alpha_range;  // from x on drawn, from z on all samples
flat in int corner;        // the triangle's last vertex

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint random = scattered(pixel.x ^ scattered(pixel.y ^ scattered(uint(corner))));
  float most = float(gl_NumSamples);
  float samples = alpha >= alpha_range.z ? most : min(floor(alpha * most + float(random >> 8) / 16777216.0), most);
  if (samples < 0.5) discard;
  int drawn = (1 << int(samples)) - 1, first = int((random & 255u) % uint(gl_NumSamples));
  gl_SampleMask[0] = drawn << first | drawn >> (gl_NumSamples - first);
#endif
  return 1.0;
}

//// keep_checkerboard.glsl
// Screen-door as published (the thesis's 4.1.1): soft texels are drawn, solid, in half of the pixels, whatever their
// alpha. The half is the same for all surfaces, so the nearest soft one hides all others there, and the other half
// shows what is solid behind them: two surfaces at most (its Figure 7).
uniform vec3 alpha_range;  // from x on drawn, from z on in every pixel

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  if (alpha < alpha_range.z && ((pixel.x ^ pixel.y) & 1u) != 0u) discard;
#endif
  return 1.0;
}

//// bayer_square.glsl
// Bayer's ordered matrix of 4 x 4: entry (x, y) interleaves the bits of y and x ^ y, the lowest ones first in rank.
uint rank_in_square(uvec2 pixel) {
  uint y = pixel.y & 3u, mixed = (pixel.x ^ pixel.y) & 3u;
  return (mixed & 1u) << 3 | (y & 1u) << 2 | (mixed & 2u) | y >> 1;
}

//// keep_bayer.glsl
// Screen-door with Bayer's ordered pattern: 17 levels of alpha instead of one. The pattern is the same for all
// surfaces, so one behind another is seen only as far as its alpha is greater.
uniform vec3 alpha_range;  // from x on drawn, from z on in every pixel

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  if (alpha < alpha_range.z && alpha * 16.0 < float(rank_in_square(uvec2(gl_FragCoord.xy))) + 0.5) discard;
#endif
  return 1.0;
}

//// keep_screen_door.glsl after scattered.glsl
// Draws soft texels in as many pixels of each square of 4 x 4 as their alpha asks for, solid: of Bayer's matrix, mixed.
uniform vec3 alpha_range;  // from x on drawn, from z on in every pixel
flat in int corner;        // the triangle's last vertex

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  // With one pattern for all, a strand would hide just those behind it that have its own pixels, and two layers would
  // cover no more than one. Each triangle mixes the ranks in another way, which leaves them as evenly spread; and in
  // another way in each square, or two large triangles would cover too much or too little together wherever they meet.
  uvec2 pixel = uvec2(gl_FragCoord.xy), square = pixel >> 2u;
  uint rank = rank_in_square(pixel) ^ (scattered(uint(corner) ^ square.x << 10 ^ square.y << 20) & 15u);
  if (alpha < alpha_range.z && alpha * 16.0 < float(rank) + 0.5) discard;
#endif
  return 1.0;
}

//// keep_hashed.glsl after scattered.glsl
// Hashed alpha testing (Wyman and McGuire, "Hashed Alpha Testing", I3D 2017): a soft texel is drawn, solid, where its
// alpha is above a threshold that is a hash of its place on the hair at rest. The pattern is fixed to the hair,
// whatever the bones and the camera do, and its grain has about the size of a pixel.
uniform vec3 alpha_range;  // from x on drawn, from z on in every pixel
in vec3 rest_place;        // metres, head space

// Even in 0..1 over the cells of a grid.
float hash_of_cell(vec3 cell) {
  ivec3 c = ivec3(floor(cell));
  uint bits = scattered(uint(c.x) ^ scattered(uint(c.y) ^ scattered(uint(c.z))));
  return float(bits >> 8) / 16777216.0;
}

// The paper's section 4, with a width for each axis: hair is mostly seen at a slant, and a grid as coarse as its
// widest side would show. Cells are powers of two in size, and between two sizes the hashes are mixed. The sum of two
// even numbers is not even; its distribution function makes it so again.
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
