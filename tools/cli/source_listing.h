#pragma once

#include "import/source_model.h"

#include <string>

namespace coif {

/// The names that a recipe can speak of: meshes, materials, and nodes as a tree with the bones marked.
[[nodiscard]] std::string list_text(const SourceModel& model);
[[nodiscard]] std::string list_json(const SourceModel& model);

}  // namespace coif
