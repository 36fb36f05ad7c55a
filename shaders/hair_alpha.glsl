// The base colour, and which texels a pass draws. Each pass owns a half-open range of alpha, so no texel is drawn by
// two colour passes.
uniform vec3 alpha_range;  // x <= alpha < y is drawn; z 1: as fully opaque

#ifdef COIF_BASE_TEXTURE
uniform sampler2D base_texture;  // sRGB decoded by the sampler; alpha not premultiplied

vec4 base_at(vec2 uv) { return texture(base_texture, uv) * base_color; }
#else
vec4 base_at(vec2 uv) { return base_color; }
#endif

#ifdef COIF_ALPHA_TEST
void keep_to_range(float alpha) {
  if (alpha < alpha_range.x || alpha >= alpha_range.y) discard;
}
#else
// All texels are in the pass's range. Without a discard the depth test can come before the shading.
void keep_to_range(float alpha) {}
#endif
