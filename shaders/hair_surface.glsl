// What a shader that writes colour knows of its point on the hair.
in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 uv;
in float place;
in float openness;

// A card is a sheet of strands without thickness. Seen from behind, what we see is its back, so light and highlight
// belong to the side that faces us.
vec3 seen_normal() {
  return normalize(gl_FrontFacing ? normal : -normal);
}
