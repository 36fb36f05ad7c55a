// Shades hair: sums Algorithm 3 over the lights, adds the ambient term, multiplies all with the base texture.
uniform sampler2D shift_mask_texture;  // red: shift, green: mask of the secondary highlight

in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 uv;
in float place;

out vec4 fragment;

const float kNearestLight = 1e-4;  // square metres: a point light in a strand is bright, not infinite

Accumulated sum_lights(vec3 n, vec2 shift_mask) {
  vec3 t = normalize(tangent);
  vec3 view = normalize(eye.xyz - position);
  Accumulated sum = Accumulated(vec3(0.0), vec3(0.0), vec3(0.0));
  int count = int(shift.w);
  for (int i = 0; i < count; ++i) {
    vec3 towards = light_position[i].xyz;
    vec3 color = light_color[i].rgb;
    if (light_position[i].w > 0.5) {
      towards -= position;
      float square = max(dot(towards, towards), kNearestLight);
      color /= square;
      towards *= inversesqrt(square);
    }
    add_light(sum, t, n, view, towards, color, shift_mask.x, shift_mask.y);
  }
  return sum;
}

vec3 encode_srgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void main() {
  // Both textures are read before any discard: mip selection needs the neighbours' coordinates.
  vec4 base = texture(base_texture, uv) * base_color;
  vec2 shift_mask = texture(shift_mask_texture, uv).rg;
  // A card is a sheet of strands without thickness. Seen from behind, what we see is its back, so light and highlight
  // belong to the side that faces us.
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 color = vec3(0.0);
  bool shows_direction = eye.w > 0.5;
  if (shows_direction) {  // for its derivatives also before any discard
    color = direction_color(normalize(tangent), n, normalize(eye.xyz - position), position, uv, place);
  }
  if (outside_alpha_range(base.a)) discard;

  if (!shows_direction) {
    Accumulated sum = sum_lights(n, shift_mask);
    color = base.rgb * (component.x * ambient.rgb + component.y * sum.diffuse + component.z * sum.primary +
                        component.w * sum.secondary);
  }
  if (shift.z > 0.5) color = encode_srgb(color);

  // Premultiplied last, after encoding: the blend unit then adds colour * alpha to what is there * (1 - alpha), and the
  // target's own alpha becomes coverage.
  float alpha = alpha_range.z > 0.5 ? 1.0 : base.a;
  fragment = vec4(color * alpha, alpha);
}
