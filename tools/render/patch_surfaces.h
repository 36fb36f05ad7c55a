#pragma once

#include "render/solid_mesh.h"

#include <coif/asset.h>
#include <coif/math.h>

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Every patch of a level as a surface of its own, without its texture's holes, in colours that differ most between
/// patches that follow each other in the draw order: wrong joins and cuts are seen at a glance. Skinned with `palette`,
/// one matrix per bone; head space, metres.
[[nodiscard]] std::vector<SolidMesh> patch_surfaces(const Asset& asset, std::span<const Mat34> palette,
                                                    std::uint32_t lod);

/// Paints one of `patches` red and all others grey.
void mark_patch(std::size_t marked, std::span<SolidMesh> patches);

}  // namespace coif
