// Depth only, for the texels that the pass keeps.
in vec2 uv;

void main() {
  keep(base_at(uv).a);
}
