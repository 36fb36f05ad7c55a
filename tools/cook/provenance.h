#pragma once

#include "cook/recipe.h"
#include "import/source_model.h"

#include <coif/asset_records.h>

#include <cstdint>

namespace coif {

/// What a cook by this version of the tool says of its origin. `source_hash`: XXH64 of the source file's bytes.
[[nodiscard]] ProvenanceRecord make_provenance(const SourceModel& source, const Recipe& recipe,
                                               std::uint64_t source_hash);

}  // namespace coif
