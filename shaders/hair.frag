// Shades hair: sums the material's shading model over the lights and adds the ambient term.

#ifdef COIF_SHIFT_MASK
uniform sampler2D shift_mask_texture;  // red: shift, green: mask of the secondary highlight

vec2 shift_mask_at(vec2 uv) { return texture(shift_mask_texture, uv).rg; }
#else
vec2 shift_mask_at(vec2 uv) { return vec2(0.5, 1.0); }
#endif

const float kLockDepth = 0.004;    // metres of a head at scale 1: what lies closer would shade its own lock in stripes
const float kNearestLight = 1e-4;  // square metres: a point light in a strand is bright, not infinite

#ifndef COIF_MANY_FIBERS
vec3 shaded_place(Strand strand) { return outside(kLockDepth, strand); }
vec3 reach_without_map(Strand strand, float openness) { return vec3(1.0); }
vec3 sky_reflected(Strand strand, float openness) { return openness * strand.color; }
vec3 passing(Strand strand, float share) { return vec3(share); }
#endif

#ifdef COIF_SHADOW
vec4 shadow_place;
vec2 shadow_slope;
#endif

// The light from everywhere that a white matte surface with the normal n sends out.
vec3 light_from_everywhere(vec3 n) {
  if (sky[0].w == 0.0) return ambient.rgb;
  vec3 light = sky[0].rgb + n.y * sky[1].rgb + n.z * sky[2].rgb + n.x * sky[3].rgb + n.x * n.y * sky[4].rgb +
               n.y * n.z * sky[5].rgb + (3.0 * n.z * n.z - 1.0) * sky[6].rgb + n.x * n.z * sky[7].rgb +
               (n.x * n.x - n.y * n.y) * sky[8].rgb;
  return ambient.rgb + max(light, vec3(0.0));
}

// What arrives of a light: by the shadow map, if it is the light's, or else by how open the place is.
vec3 light_reaching(Strand strand, int i) {
#ifdef COIF_SHADOW
  if (i == int(shadow_map.w)) {
    vec2 shares = hair_light_shares(shadow_place, shadow_slope, shadow_depth, shadow_map);
    return shares.x * passing(strand, shares.y);
  }
#endif
  return reach_without_map(strand, openness);
}

#ifdef COIF_STRAND_TERMS
const float kDarkRoot = 0.4;  // share of its length from which on a strand has its whole colour

// The strand's colour here: darker at the root, and with a lightness of its own. The texture's shift distinguishes
// neighbouring strands.
vec3 own_color(vec3 color, float shift) {
  float root = 1.0 - strands.y * (1.0 - smoothstep(0.0, kDarkRoot, place));
  return color * root * (1.0 + 2.0 * strands.z * shift);
}

// Light that many strands pass on from behind them towards the eye: around the cone that the papers call TT, wide,
// since each of them turns it a little, and from where the surface is seen from its edge, or a light would shine
// through the head.
float through_hair(Strand strand, vec3 towards) {
  float behind = max(-dot(strand.view, towards), 0.0);
  float off_cone = dot(strand.tangent, towards) + dot(strand.tangent, strand.view);
  return behind * pow2(behind) * exp(-4.0 * pow2(off_cone)) * clamp(1.0 + 2.0 * dot(strand.normal, towards), 0.0, 1.0);
}
#endif

Strand strand_of(vec3 color, vec2 shift_mask) {
  vec3 t = normalize(tangent), n = seen_normal();
#if defined(COIF_NORMAL_MAP) || defined(COIF_STRAND_MAP)
  follow_relief(t, n);
#endif
  return Strand(t, n, normalize(-position), color, shift_mask.x - 0.5, shift_mask.y);
}

Reflected sum_lights(Strand strand, out vec3 glow) {
  Reflected sum = Reflected(vec3(0.0), vec3(0.0), vec3(0.0));
  glow = vec3(0.0);
  int count = int(shift.w);
  for (int i = 0; i < count; ++i) {
    vec3 towards = light_position[i].xyz;
    vec3 color = light_color[i].rgb;
    if (light_position[i].w > 0.5) {
      towards -= position;
      float square = max(dot(towards, towards), kNearestLight);
      color /= square;
      towards *= inversesqrt(square);
      float cone = (-dot(towards, light_spot[i].xyz) - light_spot[i].w) * light_color[i].w;
      color *= pow2(clamp(cone, 0.0, 1.0));
    }
    color *= light_reaching(strand, i);
    add_light(sum, strand, towards, color);
#ifdef COIF_STRAND_TERMS
    glow += strands.x * through_hair(strand, towards) * color;
#endif
  }
  return sum;
}

void main() {
  // Before any discard: choosing mips, the slope and the relief's axes need the neighbours' coordinates.
  vec4 base = base_at(uv);
  vec2 shift_mask = shift_mask_at(uv);
#ifdef COIF_STRAND_TERMS
  base.rgb = own_color(base.rgb, shift_mask.x - 0.5);
#endif
  Strand strand = strand_of(base.rgb, shift_mask);
#ifdef COIF_SHADOW
  shadow_place = shadow_from_view * vec4(shaded_place(strand), 1.0);
  shadow_slope = hair_slope(shadow_place);
#endif
  float coverage = keep(base.a);
  vec3 glow;
  Reflected sum = sum_lights(strand, glow);
  vec3 light = component.y * sum.diffuse + component.z * sum.primary + component.w * sum.secondary;
  light = light * tint(strand) + component.y * glow * base.rgb;
  write_fragment(component.x * light_from_everywhere(strand.normal) * sky_reflected(strand, openness) + light, coverage);
}
