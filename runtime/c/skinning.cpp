// Skinning on the processor in C. A file of its own, so that only programs that skin here link it.
#include "asset_view.h"

#include <coif/skinning.h>

static_assert(sizeof(coif_mat34) == sizeof(coif::Mat34));
COIF_SAME(coif_skinned_vertex, position, coif::SkinnedVertex, position);
COIF_SAME(coif_skinned_vertex, normal, coif::SkinnedVertex, normal);
COIF_SAME(coif_skinned_vertex, tangent, coif::SkinnedVertex, tangent);

extern "C" coif_status coif_skin_vertices(const coif_asset* asset, const coif_mat34* palette, uint32_t palette_count,
                                          uint32_t first, coif_skinned_vertex* out, uint32_t count) {
  if (out == nullptr && count > 0) return COIF_SIZE_MISMATCH;
  const std::span<const coif::Mat34> matrices(reinterpret_cast<const coif::Mat34*>(palette),
                                              palette == nullptr ? 0 : palette_count);
  const std::span<coif::SkinnedVertex> skinned(reinterpret_cast<coif::SkinnedVertex*>(out), count);
  return coif::c::code(coif::skin_vertices(coif::c::view_of(asset), matrices, first, skinned));
}
