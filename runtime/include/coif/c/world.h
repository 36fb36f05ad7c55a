#ifndef COIF_C_WORLD_H
#define COIF_C_WORLD_H
/* Heads with hair of many assets, which come and go while a game runs and are stepped together; a part of coif.h, which
 * hosts include. Each function follows the rules of the method of coif::HairWorld of that name (coif/hair_world.h), and
 * statuses are those of coif::Status. A head has the same bits as in a coif_hair that is told the same. Games that name
 * none of these functions do not link them.
 *
 * Null pointers and handles that name nothing give a status and change nothing: COIF_NOT_CREATED for a null world,
 * COIF_BAD_INDEX for the handle of a head or an asset that is not (or no longer) in the world. */

#include <coif/c/air.h>
#include <coif/c/character.h>
#include <coif/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

struct coif_step_settings;
struct coif_detail;

/* Heads of many assets. Lives in the caller's memory and has nothing to be destroyed. */
typedef struct coif_world coif_world;

/* Names an asset in a world until it is removed; all zero bytes name none. Handles are passed by value: two numbers
 * that C#, Rust and other languages copy as they are. WebAssembly's calling convention passes the address of a copy. */
typedef struct coif_world_asset {
  uint32_t index;
  uint32_t generation; /* Tells a removed asset from a later one at the same index. */
} coif_world_asset;

/* Names a head, as coif_world_asset. */
typedef struct coif_world_head {
  uint32_t index;
  uint32_t generation;
} coif_world_head;

typedef struct coif_world_desc {
  uint32_t assets;          /* Most assets at one time, 1..4096. */
  uint32_t heads;           /* Most heads at one time, of all assets together, 1..1,000,000. */
  size_t hair_bytes;        /* For the data of assets and heads, up to SIZE_MAX / 4; see coif_world_bytes_for(). */
  uint32_t solver;          /* coif_solver of coif.h; moves all heads. */
  uint32_t instruction_set; /* 0: the widest that the processor has. Others: coif/instruction_set.h. */
  uint32_t longest_interval;
  /* The members up to feels_gusts are for COIF_SOLVER_CHARACTER, as in coif_hair_desc; 0 for other solvers. */
  uint32_t moving_colliders;
  uint32_t follows_body, follows_poses; /* 0 or 1 */
  uint32_t has_own_air, feels_gusts;    /* 0 or 1 */
  uint32_t dynamics_sets;               /* 1..8, with any solver */
  uint32_t keeps_links;                 /* 0 or 1: linked chains stay together; not with COIF_SOLVER_THESIS. */
} coif_world_desc;
void coif_world_desc_init(coif_world_desc* desc);

/* Bytes that coif_world_create() needs, at a multiple of 64; 0 for a description that it refuses. */
size_t coif_world_memory_need(const coif_world_desc* desc);
/* The part of coif_world_desc.hair_bytes that this asset takes with so many heads when nothing is shared with other
 * assets. `crowd` as in coif_world_add_asset(). 0 for an asset or a description that is refused. */
size_t coif_world_bytes_for(const void* asset, size_t asset_bytes, uint32_t heads, const coif_world_desc* desc,
                            uint32_t crowd);
/* Creates an empty world. `memory` outlives it and starts at a multiple of 64. *world points into `memory`; null on an
 * error. */
coif_status coif_world_create(const coif_world_desc* desc, void* memory, size_t memory_bytes, coif_world** world);

/* These four may be called between any two steps. On an error the handle that they would write stays as it is. */

/* `asset` starts at a multiple of 64 and stays until the asset is removed. It is opened here, at the cost of
 * coif_asset_open(); a coif_asset of the same bytes is not needed. `crowd`: about how many heads will wear it at a
 * time, or 0 for few; it changes speed and memory alone. COIF_ASSET_LACKS_DATA: coif_check_asset() says why. */
coif_status coif_world_add_asset(coif_world* world, const void* asset, size_t asset_bytes, uint32_t crowd,
                                 coif_world_asset* added);
/* COIF_BAD_ARGUMENT while the asset has heads. */
coif_status coif_world_remove_asset(coif_world* world, coif_world_asset asset);
/* Adds a head at `pose`, with its hair in the rest pose there, at rest. */
coif_status coif_world_add_head(coif_world* world, coif_world_asset asset, const coif_head_pose* pose,
                                coif_world_head* added);
coif_status coif_world_remove_head(coif_world* world, coif_world_head head);
int coif_world_has_asset(const coif_world* world, coif_world_asset asset); /* 0 or 1 */
int coif_world_has_head(const coif_world* world, coif_world_head head);

/* Every pose after the one in coif_world_add_head() is movement that the hair feels. */
coif_status coif_world_set_head(coif_world* world, coif_world_head head, const coif_head_pose* pose);
coif_status coif_world_set_moving_head(coif_world* world, coif_world_head head, const coif_head_pose* pose,
                                       const coif_head_velocity* velocity);
coif_status coif_world_reset(coif_world* world, coif_world_head head, const coif_head_pose* pose);
coif_status coif_world_teleport(coif_world* world, coif_world_head head, const coif_head_pose* pose);
coif_status coif_world_set_detail(coif_world* world, coif_world_head head, const struct coif_detail* detail);
int coif_world_is_asleep(const coif_world* world, coif_world_head head);

coif_status coif_world_step(coif_world* world, const struct coif_step_settings* settings);
/* coif_world_step() in parts, for the host's own scheduler: every job once, on any thread, between begin and finish. */
coif_status coif_world_begin_step(coif_world* world, const struct coif_step_settings* settings);
uint32_t coif_world_job_count(const coif_world* world);
void coif_world_run_job(coif_world* world, uint32_t job);
void coif_world_finish_step(coif_world* world);
/* For the start of a scene: the hair of these heads comes to rest in up to `seconds`; nothing else moves. */
coif_status coif_world_settle(coif_world* world, const coif_world_head* heads, uint32_t count, float seconds,
                              const struct coif_step_settings* settings);

/* On a character; see coif/c/character.h. */
coif_status coif_world_set_colliders(coif_world* world, coif_world_head head, const coif_moving_collider* colliders,
                                     uint32_t count);
coif_status coif_world_set_body(coif_world* world, coif_world_head head, const coif_body_pose* bones, uint32_t count);
coif_status coif_world_set_pose(coif_world* world, coif_world_head head, const coif_quat* rotations,
                                uint32_t rotation_count, const float* weights, uint32_t weight_count);

/* Air, dynamics and pushes; see coif/c/air.h. */
coif_status coif_world_set_air(coif_world* world, coif_world_head head, const coif_head_air* air);
coif_status coif_world_set_gusts(coif_world* world, const coif_gusts* gusts);
double coif_world_gusts_way(const coif_world* world);
coif_status coif_world_set_dynamics(coif_world* world, uint32_t set, float stiffness, float damping, float friction);
coif_status coif_world_choose_dynamics(coif_world* world, coif_world_head head, uint32_t set);
coif_status coif_world_push(coif_world* world, coif_world_head head, const coif_impulse* impulse);

/* The whole world's state as bytes, to return to later. `bytes` has exactly coif_world_saved_bytes() bytes. */
size_t coif_world_saved_bytes(const coif_world* world);
coif_status coif_world_save(const coif_world* world, void* bytes, size_t size);
coif_status coif_world_restore(coif_world* world, const void* bytes, size_t size);

/* Bones of the asset that this head wears; 0 for a head that is not in the world. */
uint32_t coif_world_bone_count(const coif_world* world, coif_world_head head);
/* Skinning matrices, coif_world_bone_count() of them: rest pose in head space to current pose in head space. Null for a
 * head that is not in the world. Their values change with step and reset, the address never. */
const coif_mat34* coif_world_palette(const coif_world* world, coif_world_head head);
/* Fills exactly coif_world_bone_count() ends. Head space, metres. */
coif_status coif_world_bone_ends(const coif_world* world, coif_world_head head, coif_vec3* ends, uint32_t count);

#ifdef __cplusplus
}
#endif
#endif
