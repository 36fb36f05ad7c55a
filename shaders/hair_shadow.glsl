// Shadows on hair and on things that a host draws. hair_peel.glsl has the shaders that make deep shadow maps.

//// hair_shadow_solid.glsl
// Shared by all shadow maps: a map of depths, which alone is a plain shadow map. A host's own fragment shader may use
// it, too: HairShadow::code() is this piece and those after it, uniforms() gives the arguments.
//
//   place  map_from_origin * vec4(point, 1.0)
//   slope  hair_slope(place)
//   depth  x, y, z: metres from the light are (x + y * z01) / (1 + z * z01) where the map holds z01; w: bias, metres
//   map    x: texels each way; y: thickness of the first layer, metres; z: opacity of 1.0 in a texel; w: a texel's
//          width, metres

uniform highp sampler2D hair_shadow_solid;  // where the light first meets something

float hair_shadow_metres(float z, vec4 depth) { return (depth.x + depth.y * z) / (1.0 + depth.z * z); }

// How the map's depth changes across it, on the surface through `place`: each texel is compared with the surface
// itself, not with one of its points, so that none shades itself (Isidoro 2006, "Shadow mapping: GPU-based tips and
// techniques"). Call it where the neighbours' values are known: before any discard, and outside of branches that not
// all take.
vec2 hair_slope(vec4 place) {
  const float kSteepest = 64.0;  // 89 degrees from facing the light: beyond, neighbours in the picture tell nothing
  vec3 p = place.xyz / place.w;
  vec3 x = dFdx(p), y = dFdy(p);
  float area = x.x * y.y - x.y * y.x;
  vec2 slope = vec2(y.y * x.z - x.y * y.z, x.x * y.z - y.x * x.z);
  // Seen along its edge, or with neighbours that do not tell: as if it faced the light.
  if (!(abs(area) > 0.0) || any(isnan(slope / area))) return vec2(0.0);
  return clamp(slope / area, -kSteepest, kSteepest);
}

// Light that solid things let pass, by percentage-closer filtering (Reeves et al. 1987) over a box two texels wide. The
// shader compares by hand: the hardware has one depth for all the texels it filters, but the surface has another at
// each.
float hair_solid_pass(vec3 p, vec2 slope, vec4 depth, vec4 map) {
  vec2 place = p.xy * map.x;
  ivec2 middle = ivec2(floor(place)), last = ivec2(map.x) - 1;
  vec2 share = fract(place);
  vec3 across = 0.5 * vec3(1.0 - share.x, 1.0, share.x), upwards = 0.5 * vec3(1.0 - share.y, 1.0, share.y);
  vec2 step_z = slope / map.x;  // from texel to texel
  float z = p.z + dot(0.5 - share, step_z);
  float passes = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 aside = ivec2(i % 3, i / 3) - 1;
    float there = texelFetch(hair_shadow_solid, clamp(middle + aside, ivec2(0), last), 0).r;
    float here = min(z + dot(vec2(aside), step_z), 1.0);  // as deep as an empty texel: the map ends there
    float behind = hair_shadow_metres(here, depth) - depth.w - hair_shadow_metres(there, depth);
    passes += behind > 0.0 ? 0.0 : across[aside.x + 1] * upwards[aside.y + 1];
  }
  return passes;
}

//// hair_shadow_plain.glsl after hair_shadow_solid.glsl
// The share of a light that reaches a point, by a depth map (HairShadow with kPlainShadow).

// What solid things let pass, and soft hair, of which this map has none.
vec2 hair_light_shares(vec4 place, vec2 slope, vec4 depth, vec4 map) {
  if (place.w <= 0.0) return vec2(1.0);  // behind the light
  vec3 p = place.xyz / place.w;
  if (min(p.x, p.y) < 0.0 || max(p.x, p.y) > 1.0) return vec2(1.0);
  p.z = min(p.z, 1.0);  // behind the map's far end the last thing that it has still casts its shadow
  return vec2(hair_solid_pass(p, slope, depth, map), 1.0);
}

float hair_light(vec4 place, vec2 slope, vec4 depth, vec4 map) {
  return hair_light_shares(place, slope, depth, map).x;
}

//// hair_shadow_layered.glsl after hair_shadow_solid.glsl
// What the maps share that store how light fades on its way into the hair. Solid things are in a map of their own.

// Share of the light on one texel of the map that passes; `z`: the surface's depth there, in the map's units.
float hair_texel_pass(ivec2 texel, float z, vec4 depth, vec4 map);

// The share that passes the hair, filtered by hand: each texel has depths of its own.
float hair_pass(vec3 p, vec2 slope, vec4 depth, vec4 map) {
  vec2 place = p.xy * map.x - 0.5;
  vec2 share = fract(place);
  vec2 step_z = slope / map.x;  // from texel to texel
  float z = p.z - dot(share, step_z);
  ivec2 last = ivec2(map.x) - 1;
  ivec2 low = clamp(ivec2(floor(place)), ivec2(0), last), high = min(low + 1, last);
  float below = mix(hair_texel_pass(low, z, depth, map),
                    hair_texel_pass(ivec2(high.x, low.y), z + step_z.x, depth, map), share.x);
  float above = mix(hair_texel_pass(ivec2(low.x, high.y), z + step_z.y, depth, map),
                    hair_texel_pass(high, z + step_z.x + step_z.y, depth, map), share.x);
  return mix(below, above, share.y);
}

// What solid things let pass, and soft hair.
vec2 hair_light_shares(vec4 place, vec2 slope, vec4 depth, vec4 map) {
  if (place.w <= 0.0) return vec2(1.0);  // behind the light
  vec3 p = place.xyz / place.w;
  if (min(p.x, p.y) < 0.0 || max(p.x, p.y) > 1.0) return vec2(1.0);
  p.z = min(p.z, 1.0);  // behind the map's far end the last thing that it has still casts its shadow
  return vec2(hair_solid_pass(p, slope, depth, map), hair_pass(p, slope, depth, map));
}

float hair_light(vec4 place, vec2 slope, vec4 depth, vec4 map) {
  vec2 shares = hair_light_shares(place, slope, depth, map);
  return shares.x * shares.y;
}

//// hair_shadow_deep.glsl after hair_shadow_layered.glsl
// The share of a light that reaches a point, by deep opacity maps (Yuksel and Keyser 2008; HairShadow with
// kDeepOpacityShadow), after a line that defines COIF_SHADOW_LAYERS as 4 or 8. Solid hair is in the map of
// solid things, where its edge in depth is sharp; layers hold what light passes.

uniform highp sampler2D hair_shadow_front;        // where the light first meets hair that it passes
uniform highp sampler2D hair_shadow_layers;       // opacity, -log(1 - alpha), of the hair in each layer
#if COIF_SHADOW_LAYERS == 8
uniform highp sampler2D hair_shadow_far_layers;
#endif

// Layers grow from the light inwards, since most light is lost near the surface. In units of the first one.
#if COIF_SHADOW_LAYERS == 8
const vec4 kLayerBegin = vec4(0.0, 1.0, 2.5, 4.75);
const vec4 kLayerThickness = vec4(1.0, 1.5, 2.25, 3.375);
const vec4 kFarLayerBegin = vec4(8.125, 13.1875, 20.78125, 32.171875);
const vec4 kFarLayerThickness = vec4(5.0625, 7.59375, 11.390625, 17.0859375);
#else
const vec4 kLayerBegin = vec4(0.0, 1.0, 3.0, 7.0);
const vec4 kLayerThickness = vec4(1.0, 2.0, 4.0, 8.0);
#endif

float hair_texel_pass(ivec2 texel, float z, vec4 depth, vec4 map) {
  float front = texelFetch(hair_shadow_front, texel, 0).r;
  float metres = hair_shadow_metres(z, depth) - depth.w - hair_shadow_metres(front, depth);
  float into = metres / map.y;
  // All of the layers that the point is behind, and its share of the one that it is in.
  vec4 passed = clamp((into - kLayerBegin) / kLayerThickness, 0.0, 1.0);
  float opacity = dot(passed, texelFetch(hair_shadow_layers, texel, 0));
#if COIF_SHADOW_LAYERS == 8
  passed = clamp((into - kFarLayerBegin) / kFarLayerThickness, 0.0, 1.0);
  opacity += dot(passed, texelFetch(hair_shadow_far_layers, texel, 0));
#endif
  return exp(-map.z * opacity);
}

//// hair_shadow_steps.glsl after hair_shadow_layered.glsl
// The share of a light that reaches a point, by deep shadow maps (Lokovic and Veach 2000; HairShadow with kDeepShadow).
// How much light passes a texel's hair is a function of depth; the map has the two steps that come nearest to it. A
// step lies half way between the hair that takes the light and the hair behind it, so neither needs a bias (Woo 1992,
// "The shadow depth map revisited").

// 13 bits: depth of the first step; 9: how far behind it the second one is; 5 and 5: what passes the first, and both.
uniform highp usampler2D hair_shadow_steps;

const float kStepPlaces = 8191.0, kStepGaps = 511.0, kStepShares = 31.0, kStepDepthBits = 13.0;

float hair_texel_pass(ivec2 texel, float z, vec4 depth, vec4 map) {
  uint bits = texelFetch(hair_shadow_steps, texel, 0).r;
  float behind = z * kStepPlaces - float(bits >> 19);
  if (behind <= 0.0) return 1.0;
  float gap = exp2(float((bits >> 10) & 511u) * (kStepDepthBits / kStepGaps)) - 1.0;
  return float(behind <= gap ? (bits >> 5) & 31u : bits & 31u) / kStepShares;
}

//// hair_shadow_slices.glsl after hair_shadow_layered.glsl
// The share of a light that reaches a point, by opacity shadow maps (Kim and Neumann 2001; HairShadow with
// kOpacityShadow), after a line that defines COIF_SHADOW_SLICES as 4, 8 or 12: planes across the light, equally far
// apart over all of the map's depth, each with the opacity, -log(1 - alpha), of all soft hair before it. Solid hair is
// in the map of solid things.

uniform highp sampler2D hair_shadow_slices;
#if COIF_SHADOW_SLICES > 4
uniform highp sampler2D hair_shadow_middle_slices;
#endif
#if COIF_SHADOW_SLICES > 8
uniform highp sampler2D hair_shadow_far_slices;
#endif

// How far a point has come from plane `first` towards each of the next four, `place` in units of the planes' distance:
// with weights that are linear between two planes and 0 at all others.
vec4 slice_weights(float place, float first) { return max(1.0 - abs(place - first - vec4(0.0, 1.0, 2.0, 3.0)), 0.0); }

float hair_texel_pass(ivec2 texel, float z, vec4 depth, vec4 map) {
  // The first plane lies one distance behind the map's near end, where no hair is before any.
  float metres = hair_shadow_metres(z, depth) - depth.w - hair_shadow_metres(0.0, depth);
  float place = min(metres / map.y, float(COIF_SHADOW_SLICES));
  float opacity = dot(slice_weights(place, 1.0), texelFetch(hair_shadow_slices, texel, 0));
#if COIF_SHADOW_SLICES > 4
  opacity += dot(slice_weights(place, 5.0), texelFetch(hair_shadow_middle_slices, texel, 0));
#endif
#if COIF_SHADOW_SLICES > 8
  opacity += dot(slice_weights(place, 9.0), texelFetch(hair_shadow_far_slices, texel, 0));
#endif
  return exp(-map.z * opacity);
}

//// hair_slices.frag
// Adds a texel's opacity to all planes of the opacity shadow map that it lies before. After hair_shadow_slices.glsl.
in vec2 uv;

layout(location = 0) out vec4 slices;
#if COIF_SHADOW_SLICES > 4
layout(location = 1) out vec4 middle_slices;
#endif
#if COIF_SHADOW_SLICES > 8
layout(location = 2) out vec4 far_slices;
#endif

const float kMostAlpha = 0.99;  // solid hair is not infinitely so: a hundredth of the light passes

void main() {
  float alpha = base_at(uv).a;
  keep(alpha);
  float opacity = -log(1.0 - min(alpha, kMostAlpha)) / shadow_map.z;
  float metres = hair_shadow_metres(gl_FragCoord.z, shadow_depth) - hair_shadow_metres(0.0, shadow_depth);
  vec4 before = vec4(min(metres / shadow_map.y, float(COIF_SHADOW_SLICES)));
  slices = opacity * vec4(lessThanEqual(before, vec4(1.0, 2.0, 3.0, 4.0)));
#if COIF_SHADOW_SLICES > 4
  middle_slices = opacity * vec4(lessThanEqual(before, vec4(5.0, 6.0, 7.0, 8.0)));
#endif
#if COIF_SHADOW_SLICES > 8
  far_slices = opacity * vec4(lessThanEqual(before, vec4(9.0, 10.0, 11.0, 12.0)));
#endif
}

//// hair_layers.frag
// Adds a texel's opacity to the layer of the deep opacity map that it lies in. After hair_shadow_deep.glsl.
in vec2 uv;

layout(location = 0) out vec4 layers;
#if COIF_SHADOW_LAYERS == 8
layout(location = 1) out vec4 far_layers;
#endif

const float kMostAlpha = 0.99;  // solid hair is not infinitely so: a hundredth of the light passes
const float kNoEnd = 1e9;

void main() {
  float alpha = base_at(uv).a;
  keep(alpha);
  float opacity = -log(1.0 - min(alpha, kMostAlpha)) / shadow_map.z;
  float front = texelFetch(hair_shadow_front, ivec2(gl_FragCoord.xy), 0).r;
  float metres = hair_shadow_metres(gl_FragCoord.z, shadow_depth) - hair_shadow_metres(front, shadow_depth);
  vec4 into = vec4(max(metres / shadow_map.y, 0.0));
  vec4 end = kLayerBegin + kLayerThickness;
#if COIF_SHADOW_LAYERS == 8
  vec4 far_end = kFarLayerBegin + kFarLayerThickness;
  far_end.w = kNoEnd;
  far_layers = opacity * vec4(greaterThanEqual(into, kFarLayerBegin)) * vec4(lessThan(into, far_end));
#else
  end.w = kNoEnd;
#endif
  layers = opacity * vec4(greaterThanEqual(into, kLayerBegin)) * vec4(lessThan(into, end));
}
