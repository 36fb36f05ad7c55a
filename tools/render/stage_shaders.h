#pragma once

namespace coif::render {

// Shaders of the hair's surroundings: background and opaque bodies, for stage_renderer.cpp.

inline constexpr char kBackdropVertex[] = R"glsl(#version 300 es
out vec2 spot;  // -1..1 in the picture
void main() {  // one triangle that covers the picture
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  spot = corner;
  gl_Position = vec4(corner, 0.0, 1.0);
})glsl";

inline constexpr char kBackdropFragment[] = R"glsl(#version 300 es
precision highp float;
uniform vec3 bottom;
uniform vec3 top;
uniform vec3 glow;
uniform vec2 veil;  // vignette, opacity
in vec2 spot;
out vec4 fragment;
void main() {
  vec3 color = mix(bottom, top, smoothstep(0.0, 1.0, 0.5 * spot.y + 0.5));
  float from_middle = dot(spot, spot);
  color += glow * exp(-1.8 * from_middle);
  color *= 1.0 - veil.x * smoothstep(0.0, 2.0, from_middle);
  fragment = vec4(color, 1.0) * veil.y;
}
)glsl";

inline constexpr char kBodyVertex[] = R"glsl(#version 300 es
uniform mat4 clip_from_world;
uniform mat4 world_from_head;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 head_normal;
layout(location = 2) in vec2 texture_place;
out vec2 uv;
out vec3 normal;
out vec3 place;
void main() {
  uv = texture_place;
  normal = mat3(world_from_head) * head_normal;
  vec4 world = world_from_head * vec4(position, 1.0);
  place = world.xyz;
  gl_Position = clip_from_world * world;
})glsl";

inline constexpr char kStagePreamble[] = "#version 300 es\nprecision highp float;\nprecision highp int;\n";

inline constexpr char kBodyWithoutShadow[] = "float key_light(vec3 place, vec3 n, float cosine) { return 1.0; }\n";

// The shadow is looked up a little above the surface, since light that grazes it would find it in shadow. A surface
// that turns away is in its own shadow, whose edge in the map has steps of texels, so light fades before that. The
// lookup covers a disc (Vogel 1979, "A better way to construct the sunflower head"): with a single one a lock of a
// fringe would draw its outline on the cheek.
inline constexpr char kBodyWithShadow[] = R"glsl(
uniform mat4 map_from_world;
uniform vec4 shadow_depth;
uniform vec4 shadow_map;
float key_light(vec3 place, vec3 n, float cosine) {
  const int kPlaces = 14;
  const float kReach = 0.007;  // metres: as soft as the shadow of a lamp at a portrait's distance is
  vec2 slope = hair_slope(map_from_world * vec4(place, 1.0));
  float lit = smoothstep(0.0, 0.3, cosine);
  if (lit <= 0.0) return 0.0;
  vec3 side = normalize(abs(n.y) < 0.9 ? cross(n, vec3(0.0, 1.0, 0.0)) : cross(n, vec3(1.0, 0.0, 0.0)));
  vec3 up = cross(side, n);
  float sum = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    // Higher the farther aside: the surface is no plane.
    float away = max(kReach, 2.5 * shadow_map.w) * sqrt((float(i) + 0.5) / float(kPlaces)), around = 2.399963 * float(i);
    vec3 from = place + n * (shadow_map.w + 0.35 * away) + away * (cos(around) * side + sin(around) * up);
    sum += hair_light(map_from_world * vec4(from, 1.0), slope, shadow_depth, shadow_map);
  }
  return lit * sum / float(kPlaces);
}
)glsl";

// Matte light, and the mirror part of a smooth surface: Blinn and Phong's highlight with Schlick's approximation of
// Fresnel's share.
inline constexpr char kBodyFragment[] = R"glsl(
uniform sampler2D base;
uniform vec3 color;
uniform vec2 surface;  // least alpha, roughness
uniform vec3 eye;
uniform vec3 light_direction[8];
uniform vec3 light_color[8];
uniform int light_count;
uniform vec4 look;  // ambient, wrap, bleed, gloss
in vec3 normal;
in vec3 place;
in vec2 uv;
out vec4 fragment;

float mirrored(vec3 n, vec3 view, vec3 towards, float roughness) {
  vec3 h = normalize(view + towards + 1e-4 * n);
  float exponent = 2.0 / max(roughness * roughness * roughness * roughness, 1e-3);
  float away = 1.0 - max(dot(h, view), 0.0);
  float reflected = 0.04 + 0.96 * away * away * away * away * away;
  return reflected * (exponent + 2.0) / 8.0 * pow(max(dot(n, h), 0.0), exponent) * max(dot(n, towards), 0.0);
}

void main() {
  vec4 texel = texture(base, uv);
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 view = normalize(eye - place);
  vec3 around = clamp(look.y + look.z * vec3(1.0, 0.35, 0.2), 0.0, 0.9);
  vec3 light = vec3(look.x), shine = vec3(0.0);
  float key = key_light(place, n, dot(n, light_direction[0]));
  for (int i = 0; i < light_count; ++i) {
    vec3 arriving = (i == 0 ? key : 1.0) * light_color[i];
    light += arriving * max((1.0 - around) * dot(n, light_direction[i]) + around, 0.0);
    if (look.w > 0.0) shine += arriving * mirrored(n, view, light_direction[i], surface.y);
  }
  if (texel.a < surface.x) discard;
  fragment = vec4(color * texel.rgb * light + look.w * shine, 1.0);
})glsl";

}  // namespace coif::render
