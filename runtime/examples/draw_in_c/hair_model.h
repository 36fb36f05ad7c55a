/* Hair on the graphics card, made from what coif.h says of an asset: mesh, draw orders, textures, the shaders that it
 * needs. */
#ifndef HAIR_MODEL_H
#define HAIR_MODEL_H

#include <coif.h>

#include <GLES3/gl3.h>

enum { BLOCK_BYTES = 16384 };           /* of the palette's uniform block: every OpenGL ES 3 has as much */
enum { DRAW_BINDING, PALETTE_BINDING }; /* of uniform blocks */
enum { BASE, SHIFT_MASK, NORMAL_MAP, STRAND_MAP, ROLES }; /* textures, by coif_texture_role */

typedef struct model {
  coif_drawn_hair hair;
  coif_matrix_layout layout;
  GLuint vertex_array, draw_block, palette_block;
  GLuint textures[ROLES]; /* 0: the asset has none of this role */
  GLuint palette_texture; /* Of bones that are too many for a block; else 0. */
  GLuint color_program, depth_program;
} model;

/* The context is current; `folder` has the shaders. Null: it is loaded, and the asset's mesh and textures may go. Else
 * what is wrong. */
const char* model_load(model* made, const coif_asset* asset, const char* folder);

/* For the next draw: the uniform block, and the matrices of one head, whose palette has one for each bone. */
coif_status model_send_head(const model* drawn, const coif_draw_block* values, const coif_vec3* eye,
                            const coif_head_pose* head, const coif_mat34* palette);

#endif
