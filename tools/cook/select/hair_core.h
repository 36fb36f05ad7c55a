#pragma once

#include "cook/select/select_hair.h"

#include <vector>

namespace coif::cook {

/// Triangles that hair which is chosen already is wrapped around: the core of a ponytail, braid or bun, which artists
/// model as a part of the head's mesh and texture by itself. Strips that move would tear off it. Such a part is one of
/// the texture's islands, or several that touch; hair lies close around nearly all of it; it is slimmer than the head;
/// and its end is far from what else there is, where ears, lids and lips lie close to the face and a scalp is as wide
/// as the head. A mesh of nothing else is worn in the hair. Per mesh and triangle, as HairChoice has them; empty for
/// meshes without, and for those that gave hair.
[[nodiscard]] HairChoice find_hair_cores(const importer::SourceModel& source, const HairChoice& choice,
                                         std::uint32_t head_node);

}  // namespace coif::cook
