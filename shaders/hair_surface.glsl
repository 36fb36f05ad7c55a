// What a shader that writes colour knows of its point on the hair, and how it writes.
in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 uv;
in float place;

out vec4 fragment;

// A card is a sheet of strands without thickness. Seen from behind, what we see is its back, so light and highlight
// belong to the side that faces us.
vec3 seen_normal() {
  return normalize(gl_FrontFacing ? normal : -normal);
}

vec3 encode_srgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void write_fragment(vec3 linear, float alpha) {
  vec3 color = shift.z > 0.5 ? encode_srgb(linear) : linear;
  // Premultiplied last, after encoding: the blend unit then adds colour * alpha to what is there * (1 - alpha), and the
  // target's own alpha becomes coverage.
  float coverage = alpha_range.z > 0.5 ? 1.0 : alpha;
  fragment = vec4(color * coverage, coverage);
}
