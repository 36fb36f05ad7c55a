// The share of a light that reaches a point, by a depth map (HairShadow with kPlainShadow). For a host's own fragment shader
// too: HairShadow::code() is this file, uniforms() gives the arguments.
//
//   place  map_from_origin * vec4(point, 1.0)
//   depth  x, y, z: metres from the light are (x + y * z01) / (1 + z * z01) where the map holds z01; w: bias, metres
//   map    x: texels each way; y: thickness of the first layer, metres; z: opacity of 1.0 in a texel; w: a texel's width, metres

uniform highp sampler2DShadow hair_shadow_solid;  // compares, and filters 2 x 2 texels, itself

float hair_light(vec4 place, vec4 depth, vec4 map) {
  if (place.w <= 0.0) return 1.0;  // behind the light
  vec3 p = place.xyz / place.w;
  if (min(p.x, p.y) < 0.0 || max(p.x, p.y) > 1.0) return 1.0;
  // Behind the map's far end the last thing that it has still casts its shadow.
  float z = min(p.z, 1.0);
  float metres = (depth.x + depth.y * z) / (1.0 + depth.z * z) - depth.w;
  p.z = clamp((metres - depth.x) / (depth.y - depth.z * metres), 0.0, 1.0);
  vec2 side = vec2(0.5 / map.x, -0.5 / map.x);  // with the hardware's 2 x 2 that is 3 x 3 texels
  return 0.25 * (texture(hair_shadow_solid, p + vec3(side.xx, 0.0)) + texture(hair_shadow_solid, p + vec3(side.xy, 0.0)) +
                 texture(hair_shadow_solid, p + vec3(side.yx, 0.0)) + texture(hair_shadow_solid, p + vec3(side.yy, 0.0)));
}
