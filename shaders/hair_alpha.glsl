// Which texels a pass draws. Each pass owns a half-open range of alpha, so no texel is drawn by two colour passes.
uniform sampler2D base_texture;  // sRGB decoded by the sampler; alpha not premultiplied
uniform vec3 alpha_range;        // x <= alpha < y is drawn; z 1: as fully opaque

bool outside_alpha_range(float alpha) {
  return alpha < alpha_range.x || alpha >= alpha_range.y;
}
