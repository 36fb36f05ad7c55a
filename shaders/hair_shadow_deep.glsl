// The share of a light that reaches a point, by deep opacity maps (Yuksel and Keyser 2008; HairShadow with
// kDeepOpacityShadow). For a host's own fragment shader too: HairShadow::code() is this file after a line that defines
// COIF_SHADOW_LAYERS as 4 or 8, uniforms() gives the arguments.
//
//   place  map_from_origin * vec4(point, 1.0)
//   depth  x, y, z: metres from the light are (x + y * z01) / (1 + z * z01) where the map holds z01; w: bias, metres
//   map    x: texels each way; y: thickness of the first layer, metres; z: opacity of 1.0 in a texel; w: a texel's width, metres

uniform highp sampler2DShadow hair_shadow_solid;  // what the host drew; compares, and filters 2 x 2 texels, itself
uniform highp sampler2D hair_shadow_front;        // where the light first meets hair
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

float hair_shadow_metres(float z, vec4 depth) { return (depth.x + depth.y * z) / (1.0 + depth.z * z); }

// Of the light that comes down on one texel; `metres` from the light.
float hair_layers_pass(ivec2 texel, float metres, vec4 depth, vec4 map) {
  float front = hair_shadow_metres(texelFetch(hair_shadow_front, texel, 0).r, depth);
  float into = (metres - front) / map.y;
  // All of the layers that the point is behind, and its share of the one that it is in.
  vec4 passed = clamp((into - kLayerBegin) / kLayerThickness, 0.0, 1.0);
  float opacity = dot(passed, texelFetch(hair_shadow_layers, texel, 0));
#if COIF_SHADOW_LAYERS == 8
  passed = clamp((into - kFarLayerBegin) / kFarLayerThickness, 0.0, 1.0);
  opacity += dot(passed, texelFetch(hair_shadow_far_layers, texel, 0));
#endif
  return exp(-map.z * opacity);
}

// The share that passes the hair, filtered by hand: each texel's layers begin at a depth of their own.
float hair_pass(vec2 p, float metres, vec4 depth, vec4 map) {
  vec2 place = p * map.x - 0.5;
  vec2 share = fract(place);
  ivec2 first = ivec2(floor(place));
  ivec2 last = ivec2(map.x) - 1;
  ivec2 low = clamp(first, ivec2(0), last), high = clamp(first + 1, ivec2(0), last);
  float below = mix(hair_layers_pass(low, metres, depth, map), hair_layers_pass(ivec2(high.x, low.y), metres, depth, map),
                    share.x);
  float above = mix(hair_layers_pass(ivec2(low.x, high.y), metres, depth, map), hair_layers_pass(high, metres, depth, map),
                    share.x);
  return mix(below, above, share.y);
}

float hair_light(vec4 place, vec4 depth, vec4 map) {
  if (place.w <= 0.0) return 1.0;  // behind the light
  vec3 p = place.xyz / place.w;
  if (min(p.x, p.y) < 0.0 || max(p.x, p.y) > 1.0) return 1.0;
  // Behind the map's far end the last thing that it has still casts its shadow.
  float metres = hair_shadow_metres(min(p.z, 1.0), depth) - depth.w;
  float z = clamp((metres - depth.x) / (depth.y - depth.z * metres), 0.0, 1.0);
  vec2 side = vec2(0.5 / map.x, -0.5 / map.x);  // with the hardware's 2 x 2 that is 3 x 3 texels
  float solid = 0.25 * (texture(hair_shadow_solid, vec3(p.xy + side.xx, z)) + texture(hair_shadow_solid, vec3(p.xy + side.xy, z)) +
                        texture(hair_shadow_solid, vec3(p.xy + side.yx, z)) + texture(hair_shadow_solid, vec3(p.xy + side.yy, z)));
  return solid * hair_pass(p.xy, metres, depth, map);
}
