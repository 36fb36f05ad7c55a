// Finds the depth of the furthest texel that is not yet peeled: the depth buffer keeps the greatest. After peel_place.glsl.
in vec2 uv;
out uint found_depth;

void main() {
  keep(base_at(uv).a);
  if (is_peeled()) discard;
  found_depth = place_depth();
}
