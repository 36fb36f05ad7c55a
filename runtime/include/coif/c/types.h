#ifndef COIF_C_TYPES_H
#define COIF_C_TYPES_H
/* Statuses and plain data of the C interface; a part of coif.h, which is what hosts include. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* coif::Status, number by number. */
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

/* World from head space: metres; unit quaternion x, y, z, w; uniform scale, 0.05..20 (1: the asset's own size;
 * COIF_BAD_SCALE for any other, 0 too). */
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

/* A crowd of heads that wear one asset. Lives in memory that the caller gave, as long as that does; there is nothing to
 * destroy. */
typedef struct coif_hair coif_hair;

/* Of the library: as COIF_VERSION is of its headers. Static storage. */
const char* coif_version(void);
/* One sentence, static storage, never null. */
const char* coif_describe(coif_status status);
/* At the world's origin, as the asset was modelled. */
void coif_head_pose_init(coif_head_pose* pose);

#ifdef __cplusplus
}
#endif
#endif
