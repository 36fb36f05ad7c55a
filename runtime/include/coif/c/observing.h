#ifndef COIF_C_OBSERVING_H
#define COIF_C_OBSERVING_H
/* Where hair is and what it does, for hosts with renderers and skeletons of their own; a part of coif.h, which hosts
 * include. The rules are those of coif/bounds.h, coif/bone_transforms.h, coif/last_frame.h and coif/debug_lines.h. */

#include <coif/c/asset.h>
#include <coif/c/character.h>
#include <coif/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Box around everything that hangs on one bone at rest, head space, metres; `half` below 0: nothing hangs on it. */
typedef struct coif_bone_box {
  coif_vec3 center, half;
} coif_bone_box;
/* Head space, metres. */
typedef struct coif_bounds {
  coif_vec3 lowest, highest;
} coif_bounds;
/* World axes, metres; the ball holds the head's own box. */
typedef struct coif_world_bounds {
  double center[3];
  coif_vec3 half;
  float radius;
} coif_world_bounds;

/* Fills one box for each bone; call it once per asset. */
coif_status coif_find_bone_boxes(const coif_asset* asset, coif_bone_box* boxes, uint32_t count);
/* The box around a head's hair in its present pose. */
coif_status coif_bound_hair(const coif_bone_box* boxes, const coif_mat34* palette, uint32_t count, coif_bounds* bounds);
/* A null argument gives nothing at the origin. */
coif_world_bounds coif_bounds_in_world(const coif_bounds* bounds, const coif_head_pose* head);

/* A bone relative to its parent: p' = translation + rotation p; bone 0 relative to the head. */
typedef struct coif_bone_transform {
  coif_vec3 translation;
  coif_quat rotation;
} coif_bone_transform;
coif_status coif_bone_transforms(const coif_asset* asset, const coif_mat34* palette, coif_bone_transform* transforms,
                                 uint32_t count);

/* Copies all heads' matrices, to keep them while the next step changes them. */
coif_status coif_hair_keep_palettes(const coif_hair* hair, coif_mat34* kept, size_t count);

typedef enum coif_line_kind {
  COIF_LINE_BONE = 0,
  COIF_LINE_RIGID_BONE = 1,
  COIF_LINE_COLLIDER = 2,
  COIF_LINE_LIMIT = 3,
  COIF_LINE_CONTACT = 4
} coif_line_kind;
typedef struct coif_debug_line {
  double from[3], to[3]; /* world, metres */
  uint8_t kind;          /* coif_line_kind */
  uint32_t index;        /* of the bone, or of the collider */
} coif_debug_line;
typedef void (*coif_draw_line)(const coif_debug_line* line, void* user);

/* The kinds of line that coif_draw_debug_lines() draws, joined with |. Colliders are the asset's own. */
typedef enum coif_line_choice {
  COIF_DRAW_BONES = 1,
  COIF_DRAW_COLLIDERS = 2,
  COIF_DRAW_LIMITS = 4,
  COIF_DRAW_CONTACTS = 8
} coif_line_choice;
/* Calls `draw` for each line of one head, kind by kind. */
coif_status coif_draw_debug_lines(const coif_asset* asset, const coif_head_pose* head, const coif_mat34* palette,
                                  uint32_t palette_count, uint32_t what, coif_draw_line draw, void* user);

#ifdef __cplusplus
}
#endif
#endif
