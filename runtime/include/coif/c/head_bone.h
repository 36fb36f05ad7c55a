#ifndef COIF_C_HEAD_BONE_H
#define COIF_C_HEAD_BONE_H
/* From the matrix of an engine's head bone to the pose of a head; a part of coif.h, which hosts include. The rules,
 * units and axes are those of coif/head_bone.h. */

#include <coif/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Affine matrix of a bone for column vectors, three rows of four: p' = rows * (p, 1). */
typedef struct coif_bone_matrix {
  double m[3][4];
} coif_bone_matrix;

/* What stays the same while a head bone moves. */
typedef struct coif_head_bone {
  coif_bone_matrix rest;  /* Model at rest from the bone's axes, with the rig's scale. */
  double origin[3];       /* Head space from the bone at rest: metres, the model's axes. */
  double metres_per_unit; /* 1: the world is in metres; 0.01: centimetres. */
  double largest_stretch; /* How uneven the head's axes may be: 0.01 is one per cent or a hundredth of a radian. */
} coif_head_bone;

/* A bone with the axes of head space at rest, in a world of metres. */
void coif_head_bone_init(coif_head_bone* head_bone);
/* A bone's matrix from 16 numbers, column after column, or row after row for row vectors; and from the first 12 numbers
 * of a matrix for column vectors that is stored row after row. Nothing happens if an argument is null. */
void coif_bone_matrix_of_columns(coif_bone_matrix* matrix, const float columns[16]);
void coif_bone_matrix_of_rows(coif_bone_matrix* matrix, const float rows[12]);

/* The pose of a head that follows the bone, whose world matrix is `bone` now. COIF_BAD_ARGUMENT: a number of
 * `head_bone`, or an argument is null. COIF_BAD_POSE: `bone` is not finite, or sheared or stretched. COIF_BAD_SCALE:
 * the head's scale is outside of 0.05..20. After an error `pose` is as it was. */
coif_status coif_head_pose_of_bone(const coif_bone_matrix* bone, const coif_head_bone* head_bone, coif_head_pose* pose);
/* 1 if the head is a mirror image of the one at rest; its pose then puts unmirrored hair on it, with top and face where
 * they are. Else 0, also for null. */
int coif_bone_is_mirrored(const coif_bone_matrix* bone, const coif_head_bone* head_bone);
/* For engines that have inverse bind matrices. COIF_BAD_ARGUMENT, with `inverse` as it was, where there is none. */
coif_status coif_invert_bone_matrix(const coif_bone_matrix* matrix, coif_bone_matrix* inverse);

#ifdef __cplusplus
}
#endif
#endif
