#pragma once

#include "base/tool_error.h"
#include "cook/recipe/recipe.h"
#include "import/import.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <filesystem>

namespace coif {

/// The model that a cook begins with: an artist's strips as import_model() has them, and cards in place of strands, of a .hair or .tfx
/// and of an .obj or glTF that has lines and no triangle. Errors: those of import_model(), read_groom() and model_of_cards(). Blocks;
/// costs a fork, so call it before starting threads where you can.
[[nodiscard]] tl::expected<SourceModel, ToolError> read_hair_source(const std::filesystem::path& path, const Recipe& recipe,
                                                                    const ImportSettings& settings, unsigned threads);

}  // namespace coif
