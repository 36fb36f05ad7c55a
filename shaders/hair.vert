// Skins a vertex with four bones, with one, or not at all. Positions, normals and tangents come in head space at rest
// and leave in head space.
layout(location = 0) in vec3 rest_position;
layout(location = 1) in vec3 rest_normal;
layout(location = 2) in vec4 rest_tangent;  // w: place along the strand, 0 root, 1 tip
layout(location = 3) in vec2 texture_place;
layout(location = 4) in uvec4 bones;
layout(location = 5) in vec4 weights;

out vec3 position;
out vec3 normal;
out vec3 tangent;
out float place;
out vec2 uv;

// Two programs draw the same triangles; their depths must agree to the bit.
invariant gl_Position;

// Three rows of an affine matrix for each bone.
#ifdef COIF_BONES_IN_TEXTURE
uniform sampler2D palette_texture;  // 256 bones to a row of texels

vec4 matrix_row(uint bone, int row) {
  int index = int(bone);
  return texelFetch(palette_texture, ivec2(index % 256 * 3 + row, index / 256), 0);
}
#elif defined(COIF_FOUR_BONES) || defined(COIF_ONE_BONE)
layout(std140) uniform PaletteBlock {
  vec4 palette[256 * 3];
};

vec4 matrix_row(uint bone, int row) {
  return palette[int(bone) * 3 + row];
}
#endif

#if defined(COIF_FOUR_BONES)
vec4 blended_row(int row) {
  return weights.x * matrix_row(bones.x, row) + weights.y * matrix_row(bones.y, row) +
         weights.z * matrix_row(bones.z, row) + weights.w * matrix_row(bones.w, row);
}
#elif defined(COIF_ONE_BONE)
vec4 blended_row(int row) { return matrix_row(bones.x, row); }
#endif

void main() {
#if defined(COIF_FOUR_BONES) || defined(COIF_ONE_BONE)
  vec4 x = blended_row(0);
  vec4 y = blended_row(1);
  vec4 z = blended_row(2);
  vec4 rest = vec4(rest_position, 1.0);
  position = vec3(dot(x, rest), dot(y, rest), dot(z, rest));
  normal = vec3(dot(x.xyz, rest_normal), dot(y.xyz, rest_normal), dot(z.xyz, rest_normal));
  tangent = vec3(dot(x.xyz, rest_tangent.xyz), dot(y.xyz, rest_tangent.xyz), dot(z.xyz, rest_tangent.xyz));
#else
  position = rest_position;
  normal = rest_normal;
  tangent = rest_tangent.xyz;
#endif
  place = rest_tangent.w;
  uv = texture_place;
  gl_Position = clip_from_head * vec4(position, 1.0);
}
