#ifndef COIF_C_CHARACTER_H
#define COIF_C_CHARACTER_H
/* Colliders, body and poses of a character that wears hair; a part of coif.h, which hosts include. The rules are those
 * of the methods of coif::Hair of that name (coif/hair.h, coif/character.h). Structs are filled with their defaults by
 * the function beside them. */

#include <coif/c/asset.h>
#include <coif/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Rotation, unit. */
typedef struct coif_quat {
  float x, y, z, w;
} coif_quat;

/* World space, metres, at the end of the coming step. */
typedef struct coif_moving_collider {
  double center[3];
  coif_quat rotation;     /* world from the collider's own axes; the next two members are in these axes */
  coif_vec3 axis;         /* capsules: to the segment's other end; plane: normal */
  coif_vec3 half_extents; /* box; ellipsoid: semi-axes */
  float radius;
  float end_radius;
  uint32_t shape;             /* coif_collider_shape, of coif/c/asset.h */
  uint32_t is_velocity_known; /* 0 or 1: how fast `center` moves when it arrives */
  coif_head_velocity velocity;
} coif_moving_collider;
void coif_moving_collider_init(coif_moving_collider* collider);

/* World from the bone's own axes. */
typedef struct coif_body_pose {
  double position[3];
  coif_quat rotation;
} coif_body_pose;

/* These functions need COIF_SOLVER_CHARACTER and the named member of coif_hair_desc, else COIF_NOT_ASKED.
 * COIF_BAD_ARGUMENT for a null list with a count. */

/* At most coif_hair_desc.moving_colliders; an empty list is always allowed. */
coif_status coif_hair_set_colliders(coif_hair* hair, uint32_t instance, const coif_moving_collider* colliders,
                                    uint32_t count);
/* Needs coif_hair_desc.follows_body. One pose for each body bone of the asset, in their order. */
coif_status coif_hair_set_body(coif_hair* hair, uint32_t instance, const coif_body_pose* bones, uint32_t count);
/* Needs coif_hair_desc.follows_poses. A rotation for each bone, and a weight for each chain or one for all. Neither of
 * them: back to the rest pose. */
coif_status coif_hair_set_pose(coif_hair* hair, uint32_t instance, const coif_quat* rotations, uint32_t rotation_count,
                               const float* weights, uint32_t weight_count);

#ifdef __cplusplus
}
#endif
#endif
