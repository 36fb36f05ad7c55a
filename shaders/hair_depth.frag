// Fourth pass: depth only, for the texels of the pass's range.
in vec2 uv;

void main() {
  keep_to_range(base_at(uv).a);
}
