#pragma once

#include "cook/recipe/findings.h"
#include "import/source_model.h"

#include <cstdint>
#include <span>

namespace coif::cook {

/// Warns (C115) of two meshes of the hair that lie on each other, one of them with clearly fewer triangles, as levels
/// of detail of one thing do whatever they are called. `hair`: numbers of the meshes that are hair.
void warn_of_stacked_meshes(const importer::SourceModel& source, std::span<const std::uint32_t> hair,
                            Findings& findings);

}  // namespace coif::cook
