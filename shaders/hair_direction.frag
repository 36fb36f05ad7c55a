// Shows the strands' direction: green at the root, red at the tip, and dark arrowheads that point to the tip.

const float kArrows = 10.0;       // from root to tip
const float kArrowWidth = 0.012;  // metres across the strip, within a factor of the square root of 2
const float kArrowShare = 0.65;   // of the way from one arrowhead's base to the next one's
const vec3 kRootColor = vec3(0.02, 0.75, 0.05);
const vec3 kTipColor = vec3(0.85, 0.02, 0.02);

// Change of `value` per unit of a step (x along the picture's columns, y along its rows).
float change_along(vec2 steps, float value) {
  return steps.x * dFdx(value) + steps.y * dFdy(value);
}

// The step in the picture, in pixels, that moves by the unit vector `way` on the surface (least squares).
vec2 steps_along(vec3 way, vec3 position) {
  vec3 px = dFdx(position);
  vec3 py = dFdy(position);
  float xx = dot(px, px), xy = dot(px, py), yy = dot(py, py);
  float determinant = xx * yy - xy * xy;
  if (determinant < 1e-4 * xx * yy || determinant <= 0.0) return vec2(0.0);  // seen along its edge
  float wx = dot(way, px), wy = dot(way, py);
  return vec2(yy * wx - xy * wy, xx * wy - xy * wx) / determinant;
}

// 0 on the arrowheads' middle line, 1 half way between two, along whichever texture axis runs across the strand.
// Textures hold several strips as a rule, so the width of a strip is unknown; a power of two of the texture's size
// keeps neighbouring triangles in step.
float across_arrow(vec3 t, vec3 n, vec3 position, vec2 uv) {
  vec2 along = steps_along(t, position);
  bool upright = abs(change_along(along, uv.x)) < abs(change_along(along, uv.y));
  float place_across = upright ? uv.x : uv.y;
  float per_metre = abs(change_along(steps_along(normalize(cross(n, t)), position), place_across));
  float repeats = exp2(round(-log2(max(per_metre * kArrowWidth, 1e-6))));
  return abs(2.0 * fract(place_across * repeats) - 1.0);
}

vec3 direction_color(vec3 t, vec3 n, vec3 view, vec3 position, vec2 uv, float place) {
  float ahead = fract(kArrows * place) / kArrowShare;  // 0 at an arrowhead's base, 1 at its point
  float depth = 0.9 * (1.0 - ahead) - across_arrow(t, n, position, uv);
  float arrow = clamp(depth / max(fwidth(depth), 1e-4) + 0.5, 0.0, 1.0);
  // Faces that turn away are a little darker: enough to see the strips' form, too little to be taken for direction.
  float form = mix(0.55, 1.0, abs(dot(n, view)));
  return mix(kRootColor, kTipColor, place) * mix(1.0, 0.12, arrow) * form;
}
// Shows which way strands run instead of shading them.
void main() {
  float alpha = base_at(uv).a;
  // Before any discard, as it needs the neighbours' coordinates.
  vec3 color = direction_color(normalize(tangent), seen_normal(), normalize(-position), position, uv, place);
  write_fragment(color, keep(alpha));
}
