/* A renderer for hair, written in C with coif.h alone. It takes the mesh, textures, material and draw orders from the
 * asset, and puts the shaders of shaders/ together as the README there says. It draws one head at rest from an angle in
 * degrees, as `coif render FILE.coif --view YAW,PITCH --size 512x384 --shadows none` does.
 *
 *   draw_in_c FILE.coif SHADER_FOLDER OUT.ppm YAW PITCH [bald]        bald: draws everything but the hair
 */
#include "../asset_file.h"
#include "hair_model.h"
#include "host.h"
#include "studio.h"

#include <coif.h>

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 512, HEIGHT = 384, FINER = 2 }; /* pixels of the picture; FINER samples of each, each way */

static int fail(const char* what, const char* why) {
  fprintf(stderr, "draw_in_c: %s: %s\n", what, why);
  return EXIT_FAILURE;
}

/* One row of the table in shaders/README.md: draws texels whose alpha is from range[0] to range[1], and those from
 * range[2] on as solid ones. */
typedef struct pass {
  GLuint program;
  float range[3];
  GLenum culled; /* GL_NONE: both faces are drawn. */
  int is_blended, writes_depth;
} pass;

static void draw_pass(const model* drawn, const pass* row, uint32_t lod, uint32_t order) {
  const coif_drawn_hair* const hair = &drawn->hair;
  const size_t first = (size_t)order * hair->indices_of_order + hair->lods[lod].first;
  const GLenum type = hair->index_bytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  const GLboolean writes_color = row->program == drawn->color_program;
  const float alpha[2] = {hair->alpha.lowest * hair->material.base_color[3],
                          hair->alpha.highest * hair->material.base_color[3]};
  if (row->range[0] >= row->range[1] || alpha[1] < row->range[0] || alpha[0] >= row->range[1]) return;
  glUseProgram(row->program);
  glUniform3fv(glGetUniformLocation(row->program, "alpha_range"), 1, row->range);
  row->is_blended ? glEnable(GL_BLEND) : glDisable(GL_BLEND);
  row->culled != GL_NONE ? glEnable(GL_CULL_FACE) : glDisable(GL_CULL_FACE);
  if (row->culled != GL_NONE) glCullFace(row->culled);
  glDepthMask(row->writes_depth ? GL_TRUE : GL_FALSE);
  glColorMask(writes_color, writes_color, writes_color, writes_color);
  glDrawElements(GL_TRIANGLES, (GLsizei)hair->lods[lod].count, type, (const void*)(first * hair->index_bytes));
}

static void draw_passes(const model* drawn, uint32_t lod, uint32_t order) {
  const coif_material* const m = &drawn->hair.material;
  const float t = m->opaque_threshold, d = m->discard_threshold;
  const int both = (m->flags & COIF_DOUBLE_SIDED) != 0, together = both && (m->flags & COIF_FACES_TOGETHER) != 0;
  const GLenum unseen = both ? GL_NONE : GL_BACK;
  const pass solid = {drawn->color_program, {t, FLT_MAX, t}, unseen, 0, 1};
  const pass far_sides = {drawn->color_program, {d, t, FLT_MAX}, GL_FRONT, 1, 0};
  const pass near_sides = {drawn->color_program, {d, t, FLT_MAX}, together ? GL_NONE : GL_BACK, 1, 0};
  const pass depth = {drawn->depth_program, {d > 0.5f ? d : 0.5f, t, 0}, unseen, 0, 1};
  GLuint unit;
  glBindVertexArray(drawn->vertex_array);
  for (unit = 0; unit < ROLES; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, drawn->textures[unit]);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glFrontFace(GL_CCW);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_pass(drawn, &solid, lod, order);
  if (both && !together) draw_pass(drawn, &far_sides, lod, order);
  draw_pass(drawn, &near_sides, lod, order);
  draw_pass(drawn, &depth, lod, order);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(0);
}

static coif_status draw_head(const model* drawn, const coif_draw_view* view, const coif_hair* hair,
                             const coif_head_pose* head) {
  coif_draw_block values;
  uint32_t order;
  coif_status status = coif_fill_draw_block(view, &drawn->hair.material, drawn->layout.rows_of_head, &values);
  if (status != COIF_OK) return status;
  if (!coif_is_in_view(&drawn->hair, head, &view->eye, values.clip_from_view, &order)) return COIF_OK;
  status = model_send_head(drawn, &values, &view->eye, head, coif_hair_palette(hair, 0));
  if (status != COIF_OK) return status;
  draw_passes(drawn, 0, order);
  printf("draw order %u of %u, %u bones\n", (unsigned)order + 1, (unsigned)drawn->hair.order_count,
         (unsigned)drawn->hair.bone_count);
  return COIF_OK;
}

/* Lets the hair of one head come to rest for two seconds. */
static coif_status make_hair(const block* file, const coif_head_pose* head, block* memory, coif_hair** hair) {
  coif_hair_desc desc;
  coif_step_settings settings;
  coif_status status;
  int frame;
  coif_hair_desc_init(&desc);
  coif_step_settings_init(&settings);
  *memory = allocate(coif_hair_memory_need(file->bytes, file->size, &desc));
  status = coif_hair_create(file->bytes, file->size, &desc, memory->bytes, memory->size, hair);
  if (status == COIF_OK) status = coif_hair_reset(*hair, 0, head);
  for (frame = 0; frame < 120 && status == COIF_OK; ++frame) status = coif_hair_step(*hair, &settings);
  return status;
}

static int write_picture(const host_target* target, const char* path) {
  float* const samples = host_target_read(target);
  unsigned char* const rgb = malloc(3 * WIDTH * HEIGHT);
  int is_written = 0;
  if (samples != NULL && rgb != NULL) {
    studio_develop(samples, WIDTH, HEIGHT, FINER, rgb);
    is_written = host_write_ppm(path, rgb, WIDTH, HEIGHT);
  }
  free(samples);
  free(rgb);
  return is_written;
}

static int run(const block* file, char** arguments, int is_bald) {
  char why[160];
  const char* trouble;
  coif_asset asset;
  coif_head_pose head;
  coif_hair* hair;
  coif_status status;
  block memory;
  host_target target;
  studio place;
  model drawn;
  if (coif_asset_open(&asset, file->bytes, file->size, why, sizeof why) != COIF_OK) return fail(arguments[1], why);
  if (!coif_asset_verify_draw_data(&asset, why, sizeof why)) return fail(arguments[1], why);
  if (!host_open()) return fail("OpenGL ES", "no driver");
  if (!host_target_create(&target, WIDTH * FINER, HEIGHT * FINER))
    return fail("OpenGL ES", "no half floats to draw to");
  if (!studio_create(&place, &asset, atof(arguments[4]), atof(arguments[5]), (double)WIDTH / HEIGHT)) {
    return fail(arguments[1], "there is nothing to see, or the driver refuses");
  }
  if ((trouble = model_load(&drawn, &asset, arguments[2])) != NULL) return fail(arguments[1], trouble);
  coif_head_pose_init(&head);
  status = make_hair(file, &head, &memory, &hair);
  studio_draw(&place, &asset);
  if (status == COIF_OK && !is_bald) status = draw_head(&drawn, &place.view, hair, &head);
  free(memory.from_malloc);
  if (status != COIF_OK) return fail(arguments[1], coif_describe(status));
  if (glGetError() != GL_NO_ERROR) return fail("OpenGL ES", "refused a call");
  if (!write_picture(&target, arguments[3])) return fail(arguments[3], "cannot be written");
  host_close();
  return EXIT_SUCCESS;
}

int main(int argument_count, char** arguments) {
  const int is_bald = argument_count == 7 && strcmp(arguments[6], "bald") == 0;
  block file;
  int result;
  if (argument_count != 6 + is_bald) return fail("usage", "draw_in_c FILE.coif SHADER_FOLDER OUT.ppm YAW PITCH [bald]");
  file = read_file(arguments[1]);
  result = file.size > 0 ? run(&file, arguments, is_bald) : fail(arguments[1], "cannot read, or empty");
  free(file.from_malloc);
  return result;
}
