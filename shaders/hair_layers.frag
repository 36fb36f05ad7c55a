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
