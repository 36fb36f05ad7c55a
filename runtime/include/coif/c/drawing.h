#ifndef COIF_C_DRAWING_H
#define COIF_C_DRAWING_H
/* What a renderer of hair computes before it calls its graphics interface, whichever that is; a part of coif.h, which
 * hosts include. Rules and reasons are in coif/drawing.h, what to draw with it in shaders/README.md.
 * runtime/examples/draw_in_c is a renderer that uses this header alone. */

#include <coif/c/asset.h>

#ifdef __cplusplus
extern "C" {
#endif

#define COIF_MAX_LIGHTS 8
#define COIF_SKY_HARMONICS 9

typedef struct coif_index_range {
  uint32_t first, count;
} coif_index_range;

/* A ball that hair never leaves, head space, metres. */
typedef struct coif_reach {
  float center[3];
  float radius;
} coif_reach;

/* The range of the base texture's alpha, 0..1, before the material's base colour. */
typedef struct coif_alpha_range {
  float lowest, highest;
} coif_alpha_range;

typedef enum coif_skinning { COIF_RIGID = 0, COIF_ONE_BONE = 1, COIF_FOUR_BONES = 2 } coif_skinning;

/* Everything that drawing needs of an asset once its buffers and textures are on the GPU; the asset may go then. */
typedef struct coif_drawn_hair {
  coif_index_range lods[COIF_MAX_LODS]; /* In the stored order. */
  uint32_t lod_count;
  uint32_t order_count;      /* Draw orders: copies of all levels' indices, one after the other. */
  uint32_t indices_of_order; /* Level l of order k begins at index k * indices_of_order + lods[l].first. */
  uint32_t index_bytes;      /* 2 where that is enough, else 4 */
  uint8_t order_of_view[COIF_VIEW_CELLS];
  coif_reach reach;
  coif_alpha_range alpha;
  uint32_t bone_count;
  uint32_t skinning;      /* coif_skinning */
  coif_material material; /* The asset's own, or a brown one where it has none. */
} coif_drawn_hair;

/* COIF_ASSET_LACKS_DATA without a mesh. Reads every vertex: call it once, when the hair is loaded. */
coif_status coif_drawn_hair_of(const coif_asset* asset, coif_drawn_hair* hair);
/* Writes the indices of all draw orders as they are uploaded: exactly order_count * indices_of_order * index_bytes
 * bytes, else COIF_SIZE_MISMATCH. `hair` must be of this asset, else COIF_BAD_ARGUMENT. */
coif_status coif_write_draw_orders(const coif_asset* asset, const coif_drawn_hair* hair, void* out, size_t bytes);

/* The best order for a head seen from one side: `direction` is from the head to the eye in head space, of any length.
 * Returns 0, the stored order, where there is no other. */
uint32_t coif_choose_order(const coif_drawn_hair* hair, const float direction[3]);
/* The cell, below COIF_VIEW_CELLS, of a direction; and the direction of a cell's middle (COIF_BAD_INDEX for a cell
 * that does not exist). */
uint32_t coif_view_cell(const float direction[3]);
coif_status coif_view_cell_direction(uint32_t cell, float direction[3]);
/* The stored tables: triangles by their number, order after order, without order 0; and the order of each cell. */
const uint32_t* coif_asset_orders(const coif_asset* asset, uint32_t* count);
const uint8_t* coif_asset_order_views(const coif_asset* asset, uint32_t* count);

/* Returns 1 where this head may be in view; *order (may be null) is then the order to draw it in. Returns 0 where it
 * is not, or where an argument is null or a pose is bad. `eye`: world, metres. `clip_from_view` as in coif_draw_block.
 */
int coif_is_in_view(const coif_drawn_hair* hair, const coif_head_pose* head, const coif_vec3* eye,
                    const float clip_from_view[16], uint32_t* order);

typedef enum coif_light_kind { COIF_DIRECTIONAL = 0, COIF_POINT = 1, COIF_SPOT = 2 } coif_light_kind;

typedef struct coif_light {
  uint32_t kind;       /* coif_light_kind */
  coif_vec3 from;      /* Directional: direction towards the light, any length. Else its position: world, metres. */
  coif_vec3 color;     /* Linear radiance of a white matte surface that faces it; point and spot: at one metre. */
  coif_vec3 spot_axis; /* The direction in which it shines, of any length. */
  float inner_cosine, outer_cosine;
} coif_light;

/* Parts of the shading: coif::Component. */
typedef enum coif_component {
  COIF_ALL = 0,
  COIF_AMBIENT = 1,
  COIF_DIFFUSE = 2,
  COIF_SPECULAR = 3,
  COIF_PRIMARY_HIGHLIGHT = 4,
  COIF_SECONDARY_HIGHLIGHT = 5,
  COIF_STRAND_DIRECTION = 6
} coif_component;

typedef struct coif_draw_view {
  float clip_from_world[16]; /* Column-major, OpenGL clip space; must not mirror. */
  coif_vec3 eye;             /* World, metres. */
  const coif_light* lights;
  uint32_t light_count;         /* At most COIF_MAX_LIGHTS. */
  const coif_vec3* sky;         /* COIF_SKY_HARMONICS, as coif::SkyLight has them, or null: no sky. */
  uint32_t component;           /* coif_component */
  uint32_t framebuffer_is_srgb; /* 1: the target encodes sRGB itself, or is linear. 0: the shader encodes. */
} coif_draw_view;

/* The uniform block DrawBlock of the shaders, std140, byte for byte. View space: the world's axes, its origin at the
 * eye. */
typedef struct coif_draw_block {
  float clip_from_view[16];
  float base_color[4], ambient[4], primary[4], secondary[4], shift[4], component[4], fiber[4], strands[4];
  float light_position[COIF_MAX_LIGHTS][4], light_color[COIF_MAX_LIGHTS][4], light_spot[COIF_MAX_LIGHTS][4];
  float sky[COIF_SKY_HARMONICS][4];
  float shadow_from_view[16], shadow_depth[4], shadow_map[4]; /* For the host's own shaders that look up a shadow. */
} coif_draw_block;

void coif_light_init(coif_light* light);
void coif_draw_view_init(coif_draw_view* view);
/* COIF_BAD_ARGUMENT for values that are not finite or out of their range; *block is unchanged then. */
coif_status coif_fill_draw_block(const coif_draw_view* view, const coif_material* material, uint32_t rows_of_head,
                                 coif_draw_block* block);

/* How the matrices of many heads lie in uniform blocks: PaletteBlock of the shaders. */
typedef struct coif_matrix_layout {
  uint32_t rows_of_head;     /* Rows of four floats: the head's own matrix, then those of its bones. */
  uint32_t heads_of_batch;   /* The most heads that one block holds. */
  uint32_t bones_in_texture; /* 1: the bones do not fit into a block, which then has the head's matrix alone. */
} coif_matrix_layout;

/* `block_bytes`: bytes of a uniform block, at least 16384, else COIF_BAD_ARGUMENT. */
coif_status coif_matrix_layout_of(const coif_drawn_hair* hair, uint32_t block_bytes, coif_matrix_layout* layout);
/* Writes rows_of_head rows, first the head's own matrix relative to `eye`. COIF_SIZE_MISMATCH unless `bytes` is
 * exactly the rows' size and `palette`, from coif_hair_palette(), has one matrix per bone (rigid hair may have none).
 */
coif_status coif_write_head(const coif_drawn_hair* hair, const coif_matrix_layout* layout, const coif_head_pose* head,
                            const coif_mat34* palette, uint32_t palette_count, const coif_vec3* eye, void* out,
                            size_t bytes);

/* Sorts bones in each frame, in place of the asset's own orders: for hair that moves far from its rest pose. Any
 * number of heads of one asset may share one, in one thread at a time; coif/triangle_order.h has the rules. Lives in
 * the caller's memory. */
typedef struct coif_bone_order coif_bone_order;

/* Bytes that coif_bone_order_create() needs, at a multiple of 64; 0 for an asset without mesh, bones or skin. */
size_t coif_bone_order_memory_need(const coif_asset* asset);
/* *order points into `memory`; null on an error. */
coif_status coif_bone_order_create(const coif_asset* asset, void* memory, size_t bytes, coif_bone_order** order);
/* Writes the indices of this level, far bones first: exactly lods[lod].count * index_bytes bytes, else
 * COIF_SIZE_MISMATCH. */
coif_status coif_bone_order_write(coif_bone_order* order, const coif_drawn_hair* hair, const coif_head_pose* head,
                                  const coif_mat34* palette, uint32_t palette_count, uint32_t lod, const coif_vec3* eye,
                                  void* out, size_t bytes);

/* The parts of a vertex that move: head space, metres; normal and tangent are not normalised. */
typedef struct coif_skinned_vertex {
  coif_vec3 position, normal, tangent;
} coif_skinned_vertex;

/* Skinning on the processor: vertices `first` to `first + count` of the asset. coif/skinning.h has costs and statuses.
 */
coif_status coif_skin_vertices(const coif_asset* asset, const coif_mat34* palette, uint32_t palette_count,
                               uint32_t first, coif_skinned_vertex* out, uint32_t count);

#ifdef __cplusplus
}
#endif
#endif
