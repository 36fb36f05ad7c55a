#pragma once

#include "import/import.h"
#include "import/source_format.h"

namespace coif {

/// Parses the file in this process and converts it. Meant for a child process: assimp may crash, hang or eat memory.
/// Throws std::bad_alloc where memory runs out; other exceptions become errors.
[[nodiscard]] tl::expected<SourceModel, ToolError> read_with_assimp(const std::filesystem::path& path,
                                                                    const SourceSuffix& suffix,
                                                                    const ImportSettings& settings);

/// Name and version of the linked assimp.
void describe_importer(SourceModel& model);

}  // namespace coif
