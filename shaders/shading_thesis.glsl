// Algorithm 3 of the thesis (5.3.2), the model of Scheuermann 2004 with small changes.
//
//   diffuse    saturate(mix(0.5, 1, N.L))
//   highlight  smoothstep(-1, 0, T.H) (1 - (T.H)^2)^(exponent / 2) color, H = normalize(V + L), T the tangent moved along
//              the normal by the material's shift and the texture's; the secondary one is masked by the texture
//
// Reads primary and secondary (rgb, exponent) and shift.xy of the block. Sums are multiplied with the strand's colour.

vec3 tint(Strand strand) { return strand.color; }

float strand_specular(vec3 t, vec3 view, vec3 towards, float exponent) {
  vec3 sum = view + towards;
  // A light straight behind the hair has no half vector; any finite one will do.
  vec3 half_vector = sum / max(length(sum), 1e-6);
  float t_dot_h = dot(t, half_vector);
  float sin_th = sqrt(max(1.0 - t_dot_h * t_dot_h, 0.0));
  return smoothstep(-1.0, 0.0, t_dot_h) * pow(sin_th, exponent);
}

// A highlight without colour is left out.
void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color) {
  sum.diffuse += clamp(mix(0.5, 1.0, dot(strand.normal, towards)), 0.0, 1.0) * color;
#ifdef COIF_PRIMARY
  vec3 t1 = shift_tangent(strand.tangent, strand.normal, shift.x + strand.shift);
  sum.primary += strand_specular(t1, strand.view, towards, primary.w) * primary.rgb * color;
#endif
#ifdef COIF_SECONDARY
  vec3 t2 = shift_tangent(strand.tangent, strand.normal, shift.y + strand.shift);
  sum.secondary += strand_specular(t2, strand.view, towards, secondary.w) * secondary.rgb * strand.mask * color;
#endif
}
