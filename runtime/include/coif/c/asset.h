#ifndef COIF_C_ASSET_H
#define COIF_C_ASSET_H
/* A cooked asset, read in place; a part of coif.h, which hosts include. coif/asset.h and formats/SPECIFICATION.md say
 * what everything means; this header gives access to it without C++.
 *
 * Lists are pointers into the asset's own bytes, which must stay where they are; `count` may be null. If the asset is
 * not open or null, or lacks the chunk, the list is null and its count 0. */

#include <coif/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

#define COIF_NONE 0xFFFFFFFFu /* No such bone, chain or name. */
#define COIF_MAX_LODS 8
#define COIF_VIEW_CELLS 96

/* A view of an asset: plain data that may be copied, refers to the asset's bytes and has nothing to be destroyed. A
 * view of all zero bytes is not open. */
typedef struct coif_asset {
  uint64_t inside[128];
} coif_asset;

/* Head space has its origin at the head bone's joint in the rest pose and the model's axes: right-handed, +Y up,
 * metres. */
typedef struct coif_skeleton {
  uint32_t bone_count, simulated_count, chain_count;
  uint32_t flags;      /* COIF_FACES_BACKWARDS */
  float head_joint[3]; /* In the source model, metres. */
  /* From the head bone's own axes to the model's. A host whose head bone has the world pose (p, q) gives the head pose
   * (p, q * conjugate(head_rotation)); from its matrix, coif_head_pose_of_bone() computes that. */
  float head_rotation[4];
  float air_lag; /* 0..1: share of the head's velocity that the air around it does not take on. */
} coif_skeleton;
#define COIF_FACES_BACKWARDS 1u /* The face looks along -Z at rest; otherwise along +Z. */

typedef enum coif_bone_kind { COIF_BONE_HEAD = 0, COIF_BONE_SCALP = 1, COIF_BONE_SIMULATED = 2 } coif_bone_kind;

/* Parents come first: the head, then bones that are rigid with it, then simulated bones, chain by chain. At rest all
 * bones have the axes of head space. */
typedef struct coif_bone {
  uint32_t parent;         /* COIF_NONE: bone 0 */
  uint32_t kind;           /* coif_bone_kind */
  uint32_t chain;          /* COIF_NONE: rigid */
  uint32_t name;           /* coif_asset_bone_name() */
  float joint[3];          /* Start at rest, head space, metres. */
  float length;            /* To its particle, metres; 0: rigid */
  float rest_direction[3]; /* Unit, start to particle; 0: rigid */
  uint32_t colliders;      /* Bit i: its particle may touch collider i. */
} coif_bone;

typedef enum coif_limit_kind { COIF_UNLIMITED = 0, COIF_CONE = 1, COIF_HINGE = 2, COIF_SPHERICAL = 3 } coif_limit_kind;

/* Two bones whose particles stay together: LinkRecord in coif/asset_records.h. */
typedef struct coif_link {
  uint32_t bone;
  uint32_t to;
  float shortest; /* Between their particles, metres. */
  float longest;
} coif_link;

/* Limits a bone's direction: LimitRecord in coif/asset_records.h. */
typedef struct coif_limit {
  uint32_t kind;   /* coif_limit_kind */
  float angles[2]; /* Radians. */
  float reserved;
  float rotation[4]; /* From the limit's own axes to the parent's frame. */
} coif_limit;

/* A tree of simulated bones that hangs from the rigid bone `root`. */
typedef struct coif_chain {
  uint32_t first_bone, bone_count, root;
  uint32_t model; /* 0: bones do not hold back their parents, 1: they do. */
} coif_chain;

typedef enum coif_collider_shape {
  COIF_SPHERE = 0,
  COIF_ELLIPSOID = 1,
  COIF_CAPSULE = 2,
  COIF_PLANE = 3,
  COIF_TAPERED_CAPSULE = 4,
  COIF_BOX = 5 /* Never in an asset. */
} coif_collider_shape;

/* Head space, metres: ColliderRecord in coif/asset_records.h. */
typedef struct coif_collider {
  uint32_t shape; /* coif_collider_shape */
  uint32_t bone;  /* A rigid bone; of a body collider an index into coif_asset_body_bones(). */
  uint32_t flags; /* COIF_KEEPS_INSIDE */
  uint32_t reserved;
  float center[3], reserved_center;
  float radii[3], reserved_radii;
  float rotation[4]; /* Ellipsoids: to head space. */
  float axis[3];     /* Capsules: to the segment's other end. Plane: unit normal. */
  float reserved_axis;
} coif_collider;
#define COIF_KEEPS_INSIDE 1u

/* A bone of the body that wears the hair. Body colliders hang from it; the host knows where it is. */
typedef struct coif_body_bone {
  uint32_t name;     /* coif_asset_body_bone_name() */
  float joint[3];    /* Rest pose, head space, metres. */
  float rotation[4]; /* Rest pose: from the bone's own axes to head space. */
} coif_body_bone;

/* Rest pose, head space. The layout of the vertex attributes: shaders/README.md. */
typedef struct coif_vertex {
  float position[3];
  int16_t normal[4];  /* xyz: snorm16; w: share of the ambient light that reaches it */
  int16_t tangent[4]; /* xyz: snorm16, root to tip; w: place along the strand, 0 root, 32767 tip */
  float uv[2];        /* V = 0: the first row of texels */
} coif_vertex;

typedef struct coif_skin {
  uint16_t bone[4];
  uint8_t weight[4]; /* Add up to 255. */
} coif_skin;

/* A strip, or another connected piece of the source's mesh. */
typedef struct coif_patch {
  uint32_t first_index, index_count; /* Into coif_asset_indices(). */
  float head_distance;
  uint32_t bone; /* The one with the most weight. */
  uint32_t file_place;
} coif_patch;

typedef struct coif_lod {
  uint32_t first_patch, patch_count;
  float screen_size; /* Fits where the head's height covers at least this share of the viewport's height. */
  float error;       /* Largest distance from the finest level's surface, metres. */
} coif_lod;

typedef enum coif_shading {
  COIF_SHADING_THESIS = 0,
  COIF_SHADING_KAJIYA_KAY = 1,
  COIF_SHADING_MARSCHNER = 2,
  COIF_SHADING_VOLUME = 3
} coif_shading;

/* MaterialRecord in coif/appearance_records.h; colours are linear. */
typedef struct coif_material {
  float base_color[4], ambient[3], opaque_threshold;
  float primary_color[3], primary_exponent, secondary_color[3], secondary_exponent;
  float primary_shift, secondary_shift, discard_threshold;
  uint32_t flags;   /* COIF_DOUBLE_SIDED, COIF_FACES_TOGETHER, COIF_VOLUME_NORMALS */
  uint32_t shading; /* coif_shading */
  float tilt, roughness, scatter, light_cut;
  float glow, root_shade, variation;
} coif_material;
#define COIF_DOUBLE_SIDED 1u
#define COIF_FACES_TOGETHER 2u
#define COIF_VOLUME_NORMALS 4u

typedef enum coif_texture_role {
  COIF_BASE_COLOR = 0,
  COIF_SHIFT_MASK = 1,
  COIF_NORMAL_MAP = 2,
  COIF_STRAND_MAP = 3
} coif_texture_role;

typedef enum coif_texel_format {
  COIF_SRGB8_ALPHA8 = 0,
  COIF_RG8 = 1,
  COIF_RG11_EAC = 2,
  COIF_SRGB8_ALPHA8_ETC2 = 3
} coif_texel_format;

typedef struct coif_texture {
  uint32_t role;   /* coif_texture_role */
  uint32_t format; /* coif_texel_format */
  uint32_t width, height, mip_count, reserved;
  uint64_t offset, bytes;
} coif_texture;

/* Opens `size` bytes at a multiple of 64 and proves once that every later access is in range. COIF_ASSET_LACKS_DATA:
 * the asset is refused and the view is not open; the reason is written to `why` (may be null), ended by a zero byte,
 * cut at `capacity`. COIF_BAD_ARGUMENT: `asset` is null. */
coif_status coif_asset_open(coif_asset* asset, const void* bytes, size_t size, char* why, size_t capacity);
/* Compares vertices, indices and texels with their hashes, which opening does not: 0.1 ms per MB, on any thread.
 * Returns 1 where they are as they were cooked, else 0 with `why` as above. */
int coif_asset_verify_draw_data(const coif_asset* asset, char* why, size_t capacity);
/* Opens and verifies, for a host that keeps no view. Returns 1 for a sound asset, else 0 with `why` as above. */
int coif_check_asset(const void* asset, size_t bytes, char* why, size_t capacity);

const coif_skeleton* coif_asset_skeleton(const coif_asset* asset); /* Null where it is not open. */
const coif_bone* coif_asset_bones(const coif_asset* asset, uint32_t* count);
/* Valid as long as the asset; empty where the asset has no names or no such bone. */
const char* coif_asset_bone_name(const coif_asset* asset, uint32_t bone);
const coif_chain* coif_asset_chains(const coif_asset* asset, uint32_t* count);
const coif_limit* coif_asset_limits(const coif_asset* asset, uint32_t* count); /* One per bone, or none. */
const coif_link* coif_asset_links(const coif_asset* asset, uint32_t* count);   /* Between chains; by depth. */
const coif_collider* coif_asset_colliders(const coif_asset* asset, uint32_t* count);
const coif_body_bone* coif_asset_body_bones(const coif_asset* asset, uint32_t* count);
const char* coif_asset_body_bone_name(const coif_asset* asset, uint32_t body_bone); /* As coif_asset_bone_name(). */
const coif_collider* coif_asset_body_colliders(const coif_asset* asset, uint32_t* count);
/* The body colliders that each bone may touch, bit i: body collider i. One per bone, or none. */
const uint32_t* coif_asset_body_sets(const coif_asset* asset, uint32_t* count);
/* Sub-steps that the asset was tuned for at this dt (seconds); coif_step_settings.substeps = 0 uses them. */
uint32_t coif_asset_tuned_substeps(const coif_asset* asset, float dt);

const coif_vertex* coif_asset_vertices(const coif_asset* asset, uint32_t* count);
const coif_skin* coif_asset_skin(const coif_asset* asset, uint32_t* count);   /* One per vertex, or none: rigid hair. */
const uint32_t* coif_asset_indices(const coif_asset* asset, uint32_t* count); /* All levels'; keep their order. */
const coif_patch* coif_asset_patches(const coif_asset* asset, uint32_t* count); /* All levels'. */

/* Levels of detail, the finest first: 0 without a mesh. */
uint32_t coif_asset_lod_count(const coif_asset* asset);
const coif_patch* coif_asset_lod_patches(const coif_asset* asset, uint32_t lod, uint32_t* count);
const uint32_t* coif_asset_lod_indices(const coif_asset* asset, uint32_t lod, uint32_t* count);
const coif_lod* coif_asset_stored_lods(const coif_asset* asset, uint32_t* count); /* None where there is one level. */
/* For each bone the number of levels, from the finest on, in which it is simulated. */
const uint8_t* coif_asset_lod_bones(const coif_asset* asset, uint32_t* count);
/* Share of the viewport's height that `height` metres cover at `distance` metres, under a vertical field of view of
 * `fov` radians. */
float coif_screen_share(float height, float distance, float fov);
/* The level to draw for a head that covers such a share and was last drawn as `current`: coif/lod.h. `hysteresis`: 0.1
 * suits most games, 0 chooses afresh. */
uint32_t coif_asset_choose_lod(const coif_asset* asset, float share, uint32_t current, float hysteresis);

const coif_material* coif_asset_material(const coif_asset* asset); /* Null where absent. */
const coif_texture* coif_asset_textures(const coif_asset* asset, uint32_t* count);
const coif_texture* coif_asset_reliefs(const coif_asset* asset, uint32_t* count); /* Normal and strand maps. */
/* The texture of this role in either list; null where there is none. */
const coif_texture* coif_asset_texture(const coif_asset* asset, uint32_t role);
/* Texels of one mip, first row first. *bytes (may be null) is their size. Null for a texture that is not in this
 * asset's own lists, and for a mip that it does not have. */
const void* coif_asset_texels(const coif_asset* asset, const coif_texture* texture, uint32_t mip, size_t* bytes);

#ifdef __cplusplus
}
#endif
#endif
