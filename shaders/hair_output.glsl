// Writes a colour to the framebuffer.
out vec4 fragment;

vec3 encode_srgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void write_fragment(vec3 linear, float coverage) {
  vec3 color = shift.z > 0.5 ? encode_srgb(linear) : linear;
  // Premultiplied last, after encoding: the blend unit then adds colour * alpha to what is there * (1 - alpha), and the
  // target's own alpha becomes coverage.
  fragment = vec4(color * coverage, coverage);
}
