// Skins a vertex with four bones, with one, or not at all, and puts it where its head is. Positions, normals and
// tangents come in head space at rest and leave in view space: the world's axes, its origin at the eye.
layout(location = 0) in vec3 rest_position;
layout(location = 1) in vec4 rest_normal;   // w: share of the ambient light that reaches it
layout(location = 2) in vec4 rest_tangent;  // w: place along the strand, 0 root, 1 tip
layout(location = 3) in vec2 texture_place;
layout(location = 4) in uvec4 bones;
layout(location = 5) in vec4 weights;

out vec3 position;
out vec3 normal;
out vec3 tangent;
out float place;
out vec2 uv;
out float openness;
#ifdef COIF_REST_PLACE
out vec3 rest_place;
#endif
#ifdef COIF_CORNER
flat out int corner;
#endif

// Two programs draw the same triangles; their depths must agree to the bit.
invariant gl_Position;

// Three rows of an affine matrix each: for every head its place in view space, and its bones if they are here.
layout(std140) uniform PaletteBlock {
  vec4 palette[COIF_PALETTE_ROWS];
};

int head_row() { return gl_InstanceID * int(ambient.w); }

#ifdef COIF_BONES_IN_TEXTURE
uniform sampler2D palette_texture;  // 256 bones to a row of texels

vec4 matrix_row(uint bone, int row) {
  int index = int(bone);
  return texelFetch(palette_texture, ivec2(index % 256 * 3 + row, index / 256), 0);
}
#elif defined(COIF_FOUR_BONES) || defined(COIF_ONE_BONE)
vec4 matrix_row(uint bone, int row) {
  return palette[head_row() + 3 + int(bone) * 3 + row];
}
#endif

#if defined(COIF_FOUR_BONES)
vec4 blended_row(int row) {
  return weights.x * matrix_row(bones.x, row) + weights.y * matrix_row(bones.y, row) +
         weights.z * matrix_row(bones.z, row) + weights.w * matrix_row(bones.w, row);
}
#elif defined(COIF_ONE_BONE)
vec4 blended_row(int row) { return matrix_row(bones.x, row); }
#else
vec4 blended_row(int row) { return vec4(row == 0, row == 1, row == 2, 0.0); }
#endif

// `v` times the matrix of three rows.
vec3 times(vec4 x, vec4 y, vec4 z, vec4 v) { return vec3(dot(x, v), dot(y, v), dot(z, v)); }

#ifdef COIF_MOTION
void send_motion();  // hair_motion.vert
#endif

void main() {
  vec4 x = blended_row(0);
  vec4 y = blended_row(1);
  vec4 z = blended_row(2);
  int head = head_row();
  vec4 head_x = palette[head], head_y = palette[head + 1], head_z = palette[head + 2];
  vec3 posed = times(x, y, z, vec4(rest_position, 1.0));
  position = times(head_x, head_y, head_z, vec4(posed, 1.0));
  normal = times(head_x, head_y, head_z, vec4(times(x, y, z, vec4(rest_normal.xyz, 0.0)), 0.0));
  tangent = times(head_x, head_y, head_z, vec4(times(x, y, z, vec4(rest_tangent.xyz, 0.0)), 0.0));
  place = rest_tangent.w;
  openness = rest_normal.w;
  uv = texture_place;
#ifdef COIF_REST_PLACE
  rest_place = rest_position;
#endif
#ifdef COIF_CORNER
  corner = gl_VertexID;
#endif
  gl_Position = clip_from_view * vec4(position, 1.0);
#ifdef COIF_MOTION
  send_motion();
#endif
}
