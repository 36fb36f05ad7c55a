#include "hair_model.h"

#include "host.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { BONES_OF_ROW = 256 }; /* bones in a row of palette_texture, three texels each */

static const void* at_byte(size_t offset) { return (const void*)offset; }

/* Hair without skin is rigid: it lacks the last two attributes. */
static void describe_vertices(size_t skin_begin, int is_skinned) {
  const GLsizei stride = sizeof(coif_vertex), skin_stride = sizeof(coif_skin);
  GLuint attribute;
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, at_byte(offsetof(coif_vertex, position)));
  glVertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, stride, at_byte(offsetof(coif_vertex, normal)));
  glVertexAttribPointer(2, 4, GL_SHORT, GL_TRUE, stride, at_byte(offsetof(coif_vertex, tangent)));
  glVertexAttribPointer(3, 2, GL_FLOAT, GL_FALSE, stride, at_byte(offsetof(coif_vertex, uv)));
  glVertexAttribIPointer(4, 4, GL_UNSIGNED_SHORT, skin_stride, at_byte(skin_begin + offsetof(coif_skin, bone)));
  glVertexAttribPointer(5, 4, GL_UNSIGNED_BYTE, GL_TRUE, skin_stride,
                        at_byte(skin_begin + offsetof(coif_skin, weight)));
  for (attribute = 0; attribute < (is_skinned ? 6u : 4u); ++attribute) glEnableVertexAttribArray(attribute);
}

static int upload_mesh(model* drawn, const coif_asset* asset) {
  uint32_t vertex_count, skin_count;
  const coif_vertex* const vertices = coif_asset_vertices(asset, &vertex_count);
  const coif_skin* const skin = coif_asset_skin(asset, &skin_count);
  const size_t vertex_bytes = vertex_count * sizeof *vertices, skin_bytes = skin_count * sizeof *skin;
  const size_t index_bytes = (size_t)drawn->hair.order_count * drawn->hair.indices_of_order * drawn->hair.index_bytes;
  void* const indices = malloc(index_bytes);
  GLuint buffers[2];
  if (coif_write_draw_orders(asset, &drawn->hair, indices, index_bytes) != COIF_OK) { /* also if malloc failed */
    free(indices);
    return 0;
  }
  glGenVertexArrays(1, &drawn->vertex_array);
  glBindVertexArray(drawn->vertex_array);
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(vertex_bytes + skin_bytes), NULL, GL_STATIC_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)vertex_bytes, vertices);
  glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)vertex_bytes, (GLsizeiptr)skin_bytes, skin);
  describe_vertices(vertex_bytes, skin_count > 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)index_bytes, indices, GL_STATIC_DRAW);
  glBindVertexArray(0);
  free(indices);
  return 1;
}

static GLint wrap_of(const coif_asset* asset) {
  uint32_t count, i;
  const coif_vertex* const vertices = coif_asset_vertices(asset, &count);
  for (i = 0; i < count; ++i) {
    const float* const uv = vertices[i].uv;
    if (uv[0] < -0.001f || uv[0] > 1.001f || uv[1] < -0.001f || uv[1] > 1.001f) return GL_REPEAT;
  }
  return GL_CLAMP_TO_EDGE;
}

static GLuint upload_texture(const coif_asset* asset, uint32_t role, GLint wrap) {
  const coif_texture* const texture = coif_asset_texture(asset, role);
  GLuint name = 0;
  GLsizei width, height;
  uint32_t mip;
  if (texture == NULL) return 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, (GLint)texture->mip_count - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  width = (GLsizei)texture->width;
  height = (GLsizei)texture->height;
  for (mip = 0; mip < texture->mip_count; ++mip) {
    size_t bytes;
    const void* const texels = coif_asset_texels(asset, texture, mip, &bytes);
    const GLint level = (GLint)mip;
    if (texture->format == COIF_SRGB8_ALPHA8) {
      glTexImage2D(GL_TEXTURE_2D, level, GL_SRGB8_ALPHA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    } else if (texture->format == COIF_RG8) {
      glTexImage2D(GL_TEXTURE_2D, level, GL_RG8, width, height, 0, GL_RG, GL_UNSIGNED_BYTE, texels);
    } else {
      const GLenum format =
          texture->format == COIF_RG11_EAC ? GL_COMPRESSED_RG11_EAC : GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC;
      glCompressedTexImage2D(GL_TEXTURE_2D, level, format, width, height, 0, (GLsizei)bytes, texels);
    }
    width = width > 1 ? width / 2 : 1;
    height = height > 1 ? height / 2 : 1;
  }
  return name;
}

static void add_defines(host_source* source, const model* drawn) {
  static const char* const maps[ROLES] = {"#define COIF_BASE_TEXTURE\n", "#define COIF_SHIFT_MASK\n",
                                          "#define COIF_NORMAL_MAP\n", "#define COIF_STRAND_MAP\n"};
  int role;
  for (role = 0; role < ROLES; ++role) {
    if (drawn->textures[role] != 0) host_source_add(source, maps[role]);
  }
  if ((drawn->hair.material.flags & COIF_VOLUME_NORMALS) != 0) host_source_add(source, "#define COIF_VOLUME_NORMALS\n");
  host_source_add(source, "#define COIF_PRIMARY\n#define COIF_SECONDARY\n#define COIF_ALPHA_TEST\n");
}

static host_source vertex_source(const model* drawn, const char* folder) {
  host_source source = host_source_begin();
  host_source_add(&source, "#define COIF_PALETTE_ROWS 1024\n");
  if (drawn->palette_texture != 0) host_source_add(&source, "#define COIF_BONES_IN_TEXTURE\n");
  if (drawn->hair.skinning == COIF_ONE_BONE) host_source_add(&source, "#define COIF_ONE_BONE\n");
  if (drawn->hair.skinning == COIF_FOUR_BONES) host_source_add(&source, "#define COIF_FOUR_BONES\n");
  host_source_add_piece(&source, folder, "hair.glsl", "draw_block.glsl");
  host_source_add_piece(&source, folder, "hair.vert", NULL);
  return source;
}

static host_source fragment_source(const model* drawn, const char* folder, int is_shaded) {
  static const char* const models[] = {"shading_thesis.glsl", "shading_kajiya_kay.glsl", "shading_marschner.glsl",
                                       "shading_volume.glsl"};
  host_source source = host_source_begin();
  add_defines(&source, drawn);
  host_source_add_piece(&source, folder, "hair.glsl", "draw_block.glsl");
  host_source_add_piece(&source, folder, "hair.glsl", "hair_base.glsl");
  host_source_add_piece(&source, folder, "keep.glsl", "keep_range.glsl");
  if (!is_shaded) {
    host_source_add_piece(&source, folder, "hair.glsl", "hair_depth.frag");
    return source;
  }
  host_source_add_piece(&source, folder, "hair.glsl", "hair_encode.glsl");
  host_source_add_piece(&source, folder, "hair.glsl", "hair_output.glsl");
  host_source_add_piece(&source, folder, "hair.glsl", "hair_surface.glsl");
  if (drawn->textures[NORMAL_MAP] != 0 || drawn->textures[STRAND_MAP] != 0) {
    host_source_add_piece(&source, folder, "relief.glsl", NULL);
  }
  host_source_add_piece(&source, folder, "shading.glsl", "shading.glsl");
  host_source_add_piece(&source, folder, "shading.glsl", models[drawn->hair.material.shading]);
  host_source_add_piece(&source, folder, "hair.frag", NULL);
  return source;
}

static GLuint link_program(const model* drawn, const char* folder, int is_shaded) {
  static const char* const samplers[ROLES] = {"base_texture", "shift_mask_texture", "normal_texture", "strand_texture"};
  host_source vertex = vertex_source(drawn, folder), fragment = fragment_source(drawn, folder, is_shaded);
  const GLuint program = host_link(&vertex, &fragment);
  GLint unit;
  if (program == 0) return 0;
  glUseProgram(program);
  for (unit = 0; unit < ROLES; ++unit) glUniform1i(glGetUniformLocation(program, samplers[unit]), unit);
  glUniform1i(glGetUniformLocation(program, "palette_texture"), ROLES);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "PaletteBlock"), PALETTE_BINDING);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "DrawBlock"), DRAW_BINDING);
  return program;
}

static GLuint make_block(GLuint binding, size_t bytes) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
  glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
  return buffer;
}

static GLuint make_palette_texture(uint32_t bones) {
  const GLsizei height = (GLsizei)(bones + BONES_OF_ROW - 1) / BONES_OF_ROW;
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, 3 * BONES_OF_ROW, height);
  return name;
}

const char* model_load(model* made, const coif_asset* asset, const char* folder) {
  const GLint wrap = wrap_of(asset);
  uint32_t role;
  memset(made, 0, sizeof *made);
  if (coif_drawn_hair_of(asset, &made->hair) != COIF_OK) return "has no mesh";
  coif_matrix_layout_of(&made->hair, BLOCK_BYTES, &made->layout);
  if (!upload_mesh(made, asset)) return "no memory";
  if (made->layout.bones_in_texture) made->palette_texture = make_palette_texture(made->hair.bone_count);
  for (role = 0; role < ROLES; ++role) made->textures[role] = upload_texture(asset, role, wrap);
  made->color_program = link_program(made, folder, 1);
  made->depth_program = link_program(made, folder, 0);
  made->draw_block = make_block(DRAW_BINDING, sizeof(coif_draw_block));
  made->palette_block = make_block(PALETTE_BINDING, BLOCK_BYTES);
  return made->color_program != 0 && made->depth_program != 0 ? NULL : "the driver refuses the shaders";
}

/* A row of texels holds 256 bones; the last row holds the rest. */
static void send_palette(const model* drawn, const coif_mat34* palette) {
  uint32_t first;
  glActiveTexture(GL_TEXTURE0 + ROLES);
  glBindTexture(GL_TEXTURE_2D, drawn->palette_texture);
  for (first = 0; first < drawn->hair.bone_count; first += BONES_OF_ROW) {
    const uint32_t left = drawn->hair.bone_count - first, count = left < BONES_OF_ROW ? left : BONES_OF_ROW;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, (GLint)(first / BONES_OF_ROW), (GLsizei)(3 * count), 1, GL_RGBA, GL_FLOAT,
                    palette + first);
  }
}

coif_status model_send_head(const model* drawn, const coif_draw_block* values, const coif_vec3* eye,
                            const coif_head_pose* head, const coif_mat34* palette) {
  static unsigned char rows[BLOCK_BYTES];
  const size_t bytes = (size_t)drawn->layout.rows_of_head * 4 * sizeof(float);
  const coif_status status =
      coif_write_head(&drawn->hair, &drawn->layout, head, palette, drawn->hair.bone_count, eye, rows, bytes);
  if (status != COIF_OK) return status;
  glBindBuffer(GL_UNIFORM_BUFFER, drawn->draw_block);
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof *values, values);
  glBindBuffer(GL_UNIFORM_BUFFER, drawn->palette_block);
  glBufferSubData(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)bytes, rows);
  if (drawn->palette_texture != 0) send_palette(drawn, palette);
  return COIF_OK;
}
