// Draws soft texels in as many pixels of each square of 4 x 4 as their alpha asks for, solid.
uniform vec3 alpha_range;  // from x on drawn, from z on in every pixel
flat in int corner;        // the triangle's last vertex

// Bayer's ordered matrix: entry (x, y) interleaves the bits of y and x ^ y, the lowest ones first in rank.
uint rank_in_square(uvec2 pixel) {
  uint y = pixel.y & 3u, mixed = (pixel.x ^ pixel.y) & 3u;
  return (mixed & 1u) << 3 | (y & 1u) << 2 | (mixed & 2u) | y >> 1;
}

// Integers that have nothing to do with each other.
uint scattered(uint value) {
  value = (value ^ value >> 16) * 0x7FEB352Du;
  value = (value ^ value >> 15) * 0x846CA68Bu;
  return value ^ value >> 16;
}

float keep(float alpha) {
#ifdef COIF_ALPHA_TEST
  if (alpha < alpha_range.x) discard;
  // With one pattern for all, a strand would hide just those behind it that have its own pixels, and two layers would
  // cover no more than one. Each triangle mixes the ranks in another way, which leaves them as evenly spread; and in another
  // way in each square, or two large triangles would cover too much or too little together wherever they meet.
  uvec2 pixel = uvec2(gl_FragCoord.xy), square = pixel >> 2u;
  uint rank = rank_in_square(pixel) ^ (scattered(uint(corner) ^ square.x << 10 ^ square.y << 20) & 15u);
  if (alpha < alpha_range.z && alpha * 16.0 < float(rank) + 0.5) discard;
#endif
  return 1.0;
}
