// Shows which way strands run instead of shading them.
void main() {
  float alpha = base_at(uv).a;
  // Before any discard, as it needs the neighbours' coordinates.
  vec3 color = direction_color(normalize(tangent), seen_normal(), normalize(eye.xyz - position), position, uv, place);
  keep_to_range(alpha);
  write_fragment(color, alpha);
}
