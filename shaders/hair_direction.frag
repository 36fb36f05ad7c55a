// Shows which way strands run instead of shading them.
void main() {
  float alpha = base_at(uv).a;
  // Before any discard, as it needs the neighbours' coordinates.
  vec3 color = direction_color(normalize(tangent), seen_normal(), normalize(-position), position, uv, place);
  write_fragment(color, keep(alpha));
}
