// Normals and strand directions from maps: COIF_NORMAL_MAP, COIF_STRAND_MAP. Without both the piece is
// left out. Ridges of strands are ridges from both sides: a card is a sheet of strands without thickness.

#ifdef COIF_NORMAL_MAP
uniform sampler2D normal_texture;  // red, green: the unit normal along u and v below
#endif
#ifdef COIF_STRAND_MAP
uniform sampler2D strand_texture;  // red, green: cosine and sine of twice the strand's angle from u to v, times the certainty
#endif

const float kSteepest = 0.1;  // cosine: a normal stays this far from the surface, or a strand would have no direction

// Eight bits have no 0 between -1 and 1: 128 of 255 stands for it.
vec2 two_sided(vec2 channels) { return (channels * 255.0 - 128.0) / 127.0; }

// Unit vectors on the surface with the normal n, at right angles: where U grows, and where V does. Taken from the
// neighbouring pixels, so that no vertex has to hold them and mirrored or turned textures need nothing; nought where
// the texture stands still.
void texture_axes(vec3 n, out vec3 u, out vec3 v) {
  vec3 px = dFdx(position), py = dFdy(position);
  vec2 tx = dFdx(uv), ty = dFdy(uv);
  float side = tx.x * ty.y < ty.x * tx.y ? -1.0 : 1.0;
  u = side * (px * ty.y - py * tx.y);
  v = side * (py * tx.x - px * ty.x);
  u -= n * dot(n, u);
  u *= inversesqrt(max(dot(u, u), 1e-30));
  vec3 across = cross(n, u);
  v = dot(across, v) < 0.0 ? -across : across;
}

// The unit vector in a plane, of two that are each other's reverse, for cosine and sine of twice its angle.
vec2 half_angle(vec2 twice) {
  vec2 square = max(0.5 + vec2(0.5, -0.5) * twice.x, 0.0);
  return vec2(sqrt(square.x), twice.y < 0.0 ? -sqrt(square.y) : sqrt(square.y));
}

// Turns tangent and normal as the maps say, and the tangent back onto the surface. Before any discard.
void follow_relief(inout vec3 t, inout vec3 n) {
  vec3 u, v;
  texture_axes(n, u, v);
#ifdef COIF_STRAND_MAP
  vec2 twice = two_sided(texture(strand_texture, uv).rg);
  float sure = min(length(twice), 1.0);
  vec2 along = half_angle(twice / max(sure, 1e-3));
  vec3 strand = along.x * u + along.y * v;
  t = mix(t, dot(strand, t) < 0.0 ? -strand : strand, sure);
#endif
#ifdef COIF_NORMAL_MAP
  vec2 lean = two_sided(texture(normal_texture, uv).rg);
  float up = sqrt(max(1.0 - dot(lean, lean), kSteepest * kSteepest));
  n = normalize(lean.x * u + lean.y * v + up * n);
#endif
  t = normalize(t - n * dot(t, n));
}
