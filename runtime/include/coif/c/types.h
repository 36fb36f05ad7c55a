#ifndef COIF_C_TYPES_H
#define COIF_C_TYPES_H
/* Statuses and plain data of the C interface; a part of coif.h, which is what hosts include. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The same numbers as coif::Status. */
typedef enum coif_status {
  COIF_OK = 0,
  COIF_BAD_TIME_STEP,
  COIF_BAD_POSE,
  COIF_BAD_ARGUMENT,
  COIF_BAD_INDEX,
  COIF_MEMORY_TOO_SMALL,
  COIF_NOT_CREATED,
  COIF_ASSET_LACKS_DATA,
  COIF_SIZE_MISMATCH,
  COIF_DRIVER,
  COIF_FOREIGN_STATE,
  COIF_DAMAGED_STATE,
  COIF_NOT_ASKED,
  COIF_BAD_SCALE
} coif_status;

typedef struct coif_vec3 {
  float x, y, z;
} coif_vec3;

/* Affine transform, three rows of four: p' = rows * (p, 1). */
typedef struct coif_mat34 {
  float m[3][4];
} coif_mat34;

/* World from head space: metres; unit quaternion x, y, z, w; uniform scale, 0.05..20, else COIF_BAD_SCALE (0 too).
 * Scale 1 is the asset's own size. */
typedef struct coif_head_pose {
  double position[3];
  float rotation[4];
  float scale;
  float reserved; /* 0 */
} coif_head_pose;

/* World axes, m/s and rad/s. */
typedef struct coif_head_velocity {
  float linear[3];
  float angular[3];
} coif_head_velocity;

/* A crowd of heads that wear one asset. Lives in the caller's memory and has nothing to be destroyed. */
typedef struct coif_hair coif_hair;

/* The version of the linked library, where COIF_VERSION is that of the headers. Static storage. */
const char* coif_version(void);
/* One sentence, static storage, never null. */
const char* coif_describe(coif_status status);
/* A head at the world's origin, at the asset's own size. */
void coif_head_pose_init(coif_head_pose* pose);

#ifdef __cplusplus
}
#endif
#endif
