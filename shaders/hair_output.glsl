// Writes a colour to the framebuffer.
out vec4 fragment;

void write_fragment(vec3 linear, float coverage) {
  // Premultiplied last, after encoding: the blend unit then adds colour * alpha to what is there * (1 - alpha), and the
  // target's own alpha becomes coverage.
  fragment = vec4(encoded(linear) * coverage, coverage);
}
