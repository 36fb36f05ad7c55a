/* Hair on the graphics card, made with coif.h from an asset: mesh, draw orders, textures and shaders. */
#ifndef HAIR_MODEL_H
#define HAIR_MODEL_H

#include <coif.h>

#include <GLES3/gl3.h>

enum { BLOCK_BYTES = 16384 };           /* size of the palette's uniform block; every OpenGL ES 3 allows it */
enum { DRAW_BINDING, PALETTE_BINDING }; /* uniform blocks */
enum { BASE, SHIFT_MASK, NORMAL_MAP, STRAND_MAP, ROLES }; /* textures, by coif_texture_role */

typedef struct model {
  coif_drawn_hair hair;
  coif_matrix_layout layout;
  GLuint vertex_array, draw_block, palette_block;
  GLuint textures[ROLES]; /* 0: the asset has none of this role */
  GLuint palette_texture; /* For more bones than a block holds; else 0. */
  GLuint color_program, depth_program;
} model;

/* The context has to be current; `folder` has the shaders. Returns null once the model is loaded, after which the
 * asset's mesh and textures may go; else says what is wrong. */
const char* model_load(model* made, const coif_asset* asset, const char* folder);

/* Sends what the next draw needs: the uniform block and one head's matrices. `palette` has one for each bone. */
coif_status model_send_head(const model* drawn, const coif_draw_block* values, const coif_vec3* eye,
                            const coif_head_pose* head, const coif_mat34* palette);

#endif
