// Algorithm 3 of the thesis (5.3.2). Vectors are unit and in one space; `light` and `view` point away from the hair.

struct Accumulated {
  vec3 diffuse;
  vec3 primary;
  vec3 secondary;
};

vec3 shift_tangent(vec3 t, vec3 n, float amount) {
  return normalize(t + amount * n);
}

float strand_specular(vec3 t, vec3 view, vec3 light, float exponent) {
  vec3 sum = view + light;
  // A light straight behind the hair has no half vector; any finite one will do.
  vec3 half_vector = sum / max(length(sum), 1e-6);
  float t_dot_h = dot(t, half_vector);
  float sin_th = sqrt(max(1.0 - t_dot_h * t_dot_h, 0.0));
  return smoothstep(-1.0, 0.0, t_dot_h) * pow(sin_th, exponent);
}

// `texture_shift` and `mask` are the texture's values, 0..1. A highlight without colour is left out.
void add_light(inout Accumulated sum, vec3 t, vec3 n, vec3 view, vec3 light, vec3 color, float texture_shift,
               float mask) {
  sum.diffuse += clamp(mix(0.5, 1.0, dot(n, light)), 0.0, 1.0) * color;
  float s = texture_shift - 0.5;
#ifdef COIF_PRIMARY
  vec3 t1 = shift_tangent(t, n, shift.x + s);
  sum.primary += strand_specular(t1, view, light, primary.w) * primary.rgb * color;
#endif
#ifdef COIF_SECONDARY
  vec3 t2 = shift_tangent(t, n, shift.y + s);
  sum.secondary += strand_specular(t2, view, light, secondary.w) * secondary.rgb * mask * color;
#endif
}
