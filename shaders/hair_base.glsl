// The base colour of a texel.
#ifdef COIF_BASE_TEXTURE
uniform sampler2D base_texture;  // sRGB decoded by the sampler; alpha not premultiplied

vec4 base_at(vec2 uv) { return texture(base_texture, uv) * base_color; }
#else
vec4 base_at(vec2 uv) { return base_color; }
#endif
