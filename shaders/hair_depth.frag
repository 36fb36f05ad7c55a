// Fourth pass: depth only, for the texels of the pass's range.
in vec2 uv;

void main() {
  if (outside_alpha_range(texture(base_texture, uv).a * base_color.a)) discard;
}
