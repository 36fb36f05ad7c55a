// What a colour becomes on its way into the framebuffer.
vec3 encode_srgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

vec3 encoded(vec3 linear) { return shift.z > 0.5 ? encode_srgb(linear) : linear; }
