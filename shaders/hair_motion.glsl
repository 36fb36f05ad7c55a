// How far hair has moved in the picture since the last frame, for temporal anti-aliasing and motion blur.

//// hair_motion.vert
// Comes after hair.vert, with COIF_MOTION: the vertex's place in clip space, in this frame and in the last one. A
// head has twice as many rows in PaletteBlock, this frame's first. If bones are in a texture, the last frame's are in
// its second half.
out vec4 place_now;
out vec4 place_before;

int row_before() { return head_row() + int(ambient.w) / 2; }

#ifdef COIF_BONES_IN_TEXTURE
vec4 matrix_row_before(uint bone, int row) {
  int index = int(bone), first = textureSize(palette_texture, 0).y / 2;
  return texelFetch(palette_texture, ivec2(index % 256 * 3 + row, first + index / 256), 0);
}
#elif defined(COIF_FOUR_BONES) || defined(COIF_ONE_BONE)
vec4 matrix_row_before(uint bone, int row) {
  return palette[row_before() + 3 + int(bone) * 3 + row];
}
#endif

#if defined(COIF_FOUR_BONES)
vec4 blended_row_before(int row) {
  return weights.x * matrix_row_before(bones.x, row) + weights.y * matrix_row_before(bones.y, row) +
         weights.z * matrix_row_before(bones.z, row) + weights.w * matrix_row_before(bones.w, row);
}
#elif defined(COIF_ONE_BONE)
vec4 blended_row_before(int row) { return matrix_row_before(bones.x, row); }
#else
vec4 blended_row_before(int row) { return vec4(row == 0, row == 1, row == 2, 0.0); }
#endif

void send_motion() {
  vec4 rest = vec4(rest_position, 1.0);
  vec3 posed = times(blended_row_before(0), blended_row_before(1), blended_row_before(2), rest);
  int head = row_before();
  vec3 before = times(palette[head], palette[head + 1], palette[head + 2], vec4(posed, 1.0));
  place_now = gl_Position;
  place_before = previous_clip_from_view * vec4(before, 1.0);
}

//// hair_motion.frag
// The hair's way in the picture since the last frame, in shares of the viewport, to the right and upwards, for the
// texels that the pass keeps.
in vec2 uv;
in vec4 place_now;
in vec4 place_before;
layout(location = 0) out vec2 motion;

void main() {
  keep(base_at(uv).a);
  // Hair that was behind the eye has no place in the last picture.
  const vec2 kFromOutside = vec2(2.0);
  bool was_in_front = place_before.w > 0.0;
  vec2 before = place_before.xy / (was_in_front ? place_before.w : 1.0);
  motion = was_in_front ? 0.5 * (place_now.xy / place_now.w - before) : kFromOutside;
}
