#ifndef COIF_H
#define COIF_H
/* The C interface of coif, for engines with a C interface and languages that call C. This header is all of it: heads
 * that wear one asset below, in coif/c/character.h and coif/c/air.h, heads of many assets in coif/c/world.h, poses of
 * heads from an engine's bones in coif/c/head_bone.h, the asset in coif/c/asset.h, what a renderer needs in
 * coif/c/drawing.h and coif/c/observing.h. Each function calls the function or method of that name in coif/hair.h,
 * coif/hair_world.h, coif/asset.h, coif/lod.h, coif/drawing.h or coif/skinning.h, where the rules are: nothing
 * allocates, throws, locks, reads a file or keeps anything global; after an error everything is as it was before.
 *
 * Plain data has the same layout as in C++. A description is filled with its defaults by the function beside it, so
 * that members which later versions add (minor versions before 1.0, major versions from then on) have values. */

#include <coif/c/air.h>
#include <coif/c/asset.h>
#include <coif/c/character.h>
#include <coif/c/drawing.h>
#include <coif/c/head_bone.h>
#include <coif/c/observing.h>
#include <coif/c/types.h>
#include <coif/c/world.h>
#include <coif/version.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What each solver does: coif/hair.h. */
typedef enum coif_solver {
  COIF_SOLVER_COIF = 0,
  COIF_SOLVER_THESIS = 1,
  COIF_SOLVER_PASSIVE = 2,
  COIF_SOLVER_CASCADE = 3,
  COIF_SOLVER_CHARACTER = 4
} coif_solver;

typedef struct coif_hair_desc {
  uint32_t instances;
  uint32_t solver; /* coif_solver */
  uint32_t longest_interval;
  /* The members up to feels_gusts are for COIF_SOLVER_CHARACTER, see coif/c/character.h; 0 for other solvers. */
  uint32_t moving_colliders;
  uint32_t follows_body, follows_poses; /* 0 or 1 */
  uint32_t has_own_air, feels_gusts;    /* 0 or 1; see coif/c/air.h */
  uint32_t dynamics_sets;               /* 1..8, with any solver */
  uint32_t keeps_links; /* 0 or 1: linked chains stay together; not with COIF_SOLVER_THESIS. Usually 0. */
} coif_hair_desc;

typedef struct coif_step_settings {
  float dt; /* seconds, any finite number from 0 on; long ones see coif/hair.h */
  uint32_t substeps;
  uint32_t iterations;
  coif_vec3 gravity;                  /* world axes, m/s^2; see true_gravity */
  coif_vec3 wind;                     /* world, m/s */
  float air_follow;                   /* 0..1, factor on how far the air follows the head in the asset */
  float stiffness, damping, friction; /* factors */
  float inertia;
  float teleport_distance, teleport_angle;
  float sleep_after, sleep_speed;
  uint32_t true_gravity; /* 0 or 1. 0: gravity follows each head's scale; 1: it is the same for all scales */
} coif_step_settings;

typedef struct coif_detail {
  uint32_t level;
  uint32_t interval;
  uint32_t simulated; /* 0 or 1 */
} coif_detail;

void coif_hair_desc_init(coif_hair_desc* desc);
void coif_step_settings_init(coif_step_settings* settings);

/* Bytes that coif_hair_create() needs, at a multiple of 64; 0 for an asset or a description that it refuses. */
size_t coif_hair_memory_need(const void* asset, size_t asset_bytes, const coif_hair_desc* desc);

/* `asset` and `memory` outlive the hair, and start at multiples of 64. *hair points into `memory`; null on an error.
 * COIF_ASSET_LACKS_DATA: coif_check_asset() says why. */
coif_status coif_hair_create(const void* asset, size_t asset_bytes, const coif_hair_desc* desc, void* memory,
                             size_t memory_bytes, coif_hair** hair);

uint32_t coif_hair_instance_count(const coif_hair* hair);
uint32_t coif_hair_bone_count(const coif_hair* hair);
/* Valid as long as the asset; empty where the asset has no names or no such bone. */
const char* coif_hair_bone_name(const coif_hair* hair, uint32_t bone);

/* The first pose of a head puts it there; from then on the hair feels every movement. */
coif_status coif_hair_set_head(coif_hair* hair, uint32_t instance, const coif_head_pose* pose);
/* Sets the poses of all instances at once, instance_count() of them; unchanged poses cost next to nothing.
 * COIF_SIZE_MISMATCH: nothing is set. COIF_BAD_POSE or COIF_BAD_SCALE: heads with a bad pose keep their last one, the
 * others are set. */
coif_status coif_hair_set_heads(coif_hair* hair, const coif_head_pose* poses, size_t count);
/* As coif_hair_set_head(), for a host that knows how fast the head moves when it arrives. */
coif_status coif_hair_set_moving_head(coif_hair* hair, uint32_t instance, const coif_head_pose* pose,
                                      const coif_head_velocity* velocity);
coif_status coif_hair_reset(coif_hair* hair, uint32_t instance, const coif_head_pose* pose);
coif_status coif_hair_teleport(coif_hair* hair, uint32_t instance, const coif_head_pose* pose);
coif_status coif_hair_set_detail(coif_hair* hair, uint32_t instance, const coif_detail* detail);
int coif_hair_is_asleep(const coif_hair* hair, uint32_t instance);

coif_status coif_hair_step(coif_hair* hair, const coif_step_settings* settings);
/* coif_hair_step() in parts, for the host's own scheduler: every job once, on any thread, between begin and finish. */
coif_status coif_hair_begin_step(coif_hair* hair, const coif_step_settings* settings);
uint32_t coif_hair_job_count(const coif_hair* hair);
void coif_hair_run_job(coif_hair* hair, uint32_t job);
void coif_hair_finish_step(coif_hair* hair);

/* For the start of a scene: the hair of these heads comes to rest in up to `seconds`; nothing else moves. */
coif_status coif_hair_settle(coif_hair* hair, const uint32_t* instances, uint32_t count, float seconds,
                             const coif_step_settings* settings);

/* The crowd's state as bytes, to return to later: see Hair::save() in coif/hair.h. `bytes` has exactly
 * coif_hair_saved_bytes() bytes. */
size_t coif_hair_saved_bytes(const coif_hair* hair);
coif_status coif_hair_save(const coif_hair* hair, void* bytes, size_t size);
coif_status coif_hair_restore(coif_hair* hair, const void* bytes, size_t size);

/* Skinning matrices, coif_hair_bone_count() of them: rest pose in head space to current pose in head space. Null for a
 * bad index. Their values change with step and reset. */
const coif_mat34* coif_hair_palette(const coif_hair* hair, uint32_t instance);
/* Fills exactly coif_hair_bone_count() ends. Head space, metres. */
coif_status coif_hair_bone_ends(const coif_hair* hair, uint32_t instance, coif_vec3* ends, uint32_t count);

#ifdef __cplusplus
}
#endif
#endif
