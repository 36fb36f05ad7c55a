// How a deep shadow map is made: the hair's layers are peeled off towards the light (Everitt 2001, "Interactive
// order-independent transparency"), then each texel's are compressed.

//// hair_peel.frag
// Alpha of the texel that is nearest to the light behind all those that were peeled before.
in vec2 uv;

uniform highp sampler2D hair_shadow_peeled;  // depth of the layer before
out vec4 alpha_of_layer;

const float kPeeledStep = 0.75 / 65535.0;  // the same texel again lies within half a step of the map's 16 bits

void main() {
  float alpha = base_at(uv).a;
  keep(alpha);
  if (gl_FragCoord.z <= texelFetch(hair_shadow_peeled, ivec2(gl_FragCoord.xy), 0).r + kPeeledStep) discard;
  alpha_of_layer = vec4(alpha);
}

//// hair_unpeeled.frag
// Adds the opacity, -log(1 - alpha), of all that lies behind the last layer that was peeled.
in vec2 uv;

uniform highp sampler2D hair_shadow_peeled;
out vec4 opacity;

const float kPeeledStep = 0.75 / 65535.0;
const float kMostAlpha = 0.99, kOpacityUnit = 4.0;  // bytes hold 0..4

void main() {
  float alpha = base_at(uv).a;
  keep(alpha);
  if (gl_FragCoord.z <= texelFetch(hair_shadow_peeled, ivec2(gl_FragCoord.xy), 0).r + kPeeledStep) discard;
  opacity = vec4(-log(1.0 - min(alpha, kMostAlpha)) / kOpacityUnit);
}

//// hair_steps.vert
// One triangle that covers the viewport.
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }

//// hair_steps.frag after hair_shadow_steps.glsl
// Compresses a texel's layers into the two steps whose squared error is least, over the hair itself and over what lies
// behind all of it. After a line that defines COIF_SHADOW_PEELS, 2..6.
uniform vec4 shadow_depth;
uniform vec4 shadow_map;
uniform vec4 peeled_corner;  // xy: the peeled part's corner in the map
uniform highp sampler2D hair_peeled_depth[COIF_SHADOW_PEELS];
uniform highp sampler2D hair_peeled_alpha[COIF_SHADOW_PEELS];
uniform highp sampler2D hair_unpeeled;

layout(location = 0) out highp uint packed_steps;

const int kMostLayers = COIF_SHADOW_PEELS + 1;
const float kReach = 2.0;         // texels behind the last of the hair, where nothing tells where its step should be
const float kBehindWeight = 2.0;  // of heads and bodies behind all of the hair, where errors are seen best; solid hair has 1
const float kUnpeeledWeight = 0.5;
const float kOpacityUnit = 4.0;
const float kLeastGain = 1e-6;    // from which a second step is worth it

// Per layer: light before it, how much of it there is to see, where it lies, metres.
float light[kMostLayers + 1], weight[kMostLayers + 1], place[kMostLayers + 1];
vec3 sums[kMostLayers + 2];  // over the layers before: of weights, of light, of its square
int count = 0;
float passed = 1.0;

void take(float z, float alpha, float solid) {
  if (z >= min(solid, 1.0)) return;  // there is none, or it lies behind what is solid
  light[count] = passed;
  weight[count] = alpha;
  place[count] = hair_shadow_metres(z, shadow_depth);
  passed *= 1.0 - alpha;
  ++count;
}

void take_all(ivec2 here, float solid) {
#define TAKE_LAYER(i) take(texelFetch(hair_peeled_depth[i], here, 0).r, texelFetch(hair_peeled_alpha[i], here, 0).r, solid)
  TAKE_LAYER(0);
  TAKE_LAYER(1);
#if COIF_SHADOW_PEELS > 2
  TAKE_LAYER(2);
#endif
#if COIF_SHADOW_PEELS > 3
  TAKE_LAYER(3);
#endif
#if COIF_SHADOW_PEELS > 4
  TAKE_LAYER(4);
#endif
#if COIF_SHADOW_PEELS > 5
  TAKE_LAYER(5);
#endif
}

// Unpeeled hair is assumed as far behind the last layer as the layers are apart.
void take_unpeeled(ivec2 here) {
  float opacity = texelFetch(hair_unpeeled, here, 0).r * kOpacityUnit;
  if (count < COIF_SHADOW_PEELS || opacity <= 0.0) return;
  light[count] = passed;
  weight[count] = kUnpeeledWeight;
  place[count] = place[count - 1] + (place[count - 1] - place[0]) / float(count - 1);
  passed *= exp(-opacity);
  ++count;
}

void sum_up() {
  light[count] = passed;
  weight[count] = kBehindWeight;
  sums[0] = vec3(0.0);
  for (int i = 0; i <= count; ++i) sums[i + 1] = sums[i] + weight[i] * vec3(1.0, light[i], light[i] * light[i]);
}

float mean_light(int first, int end) { return (sums[end].y - sums[first].y) / max(sums[end].x - sums[first].x, 1e-6); }

// Squared error of one share of light over these layers.
float error_of(float share, int first, int end) {
  vec3 s = sums[end] - sums[first];
  return s.z - 2.0 * share * s.y + share * share * s.x;
}

// The layers that the two steps are behind. One step does: they are the same.
ivec2 best_steps() {
  ivec2 best = ivec2(1);
  float least = 1e9;
  for (int a = 1; a <= count; ++a) {
    float before = error_of(1.0, 0, a);
    for (int b = a; b <= count; ++b) {
      float between = b > a ? error_of(mean_light(a, b), a, b) : 0.0;
      float error = before + between + error_of(mean_light(b, count + 1), b, count + 1);
      if (error >= least - kLeastGain) continue;
      least = error;
      best = ivec2(a, b);
    }
  }
  return best;
}

float map_depth(float metres) {
  return clamp((metres - shadow_depth.x) / (shadow_depth.y - metres * shadow_depth.z), 0.0, 1.0);
}

// Depth of the step behind layer `before` - 1, in the map's units, 0..1.
float place_of_step(int before) {
  float last = place[before - 1], reach = kReach * shadow_map.w;
  float metres = last + (before < count ? min(0.5 * (place[before] - last), reach) : reach);
  return map_depth(metres);
}

uint share_code(float share) { return uint(clamp(share, 0.0, 1.0) * kStepShares + 0.5); }

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy) - ivec2(peeled_corner.xy);
  take_all(here, texelFetch(hair_shadow_solid, ivec2(gl_FragCoord.xy), 0).r);
  take_unpeeled(here);
  if (count == 0) {
    packed_steps = 0xFFFFFFFFu;  // all light passes
    return;
  }
  sum_up();
  ivec2 steps = best_steps();
  // Not before the hair that it is of, or that would shade itself.
  float least = ceil(map_depth(place[steps.x - 1]) * kStepPlaces + 0.25);
  float first = min(max(floor(place_of_step(steps.x) * kStepPlaces + 0.5), least), kStepPlaces);
  float gap = max(place_of_step(steps.y) * kStepPlaces - first, 0.0);
  uint gap_code = uint(clamp(log2(gap + 1.0) * (kStepGaps / kStepDepthBits) + 0.5, 0.0, kStepGaps));
  uint between = share_code(mean_light(steps.x, max(steps.y, steps.x + 1)));
  uint behind = share_code(mean_light(steps.y, count + 1));
  if (steps.y == steps.x) between = behind;
  packed_steps = uint(first) << 19 | gap_code << 10 | between << 5 | behind;
}
