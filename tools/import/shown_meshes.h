#pragma once

// Which meshes of a file are shown, in what shape, and what is said of the rest.

#include "base/tool_error.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// Where the file hides meshes, by the names of their nodes: a warning that they are left out.
void warn_of_hidden(std::span<const std::string> nodes, std::vector<Warning>& warnings);

/// A warning that names meshes, or nodes with one, that are left out as coarser levels of detail; none where there are none.
void warn_of_coarser(std::span<const std::string> meshes, std::vector<Warning>& warnings);

/// A warning that shape keys are part of the mesh's shape, each as "'Longer' at 0.5"; none where none is on.
void warn_of_shape_keys(const std::string& mesh, std::span<const std::string> on, std::vector<Warning>& warnings);

/// The end of every reader. Of meshes that are levels of detail of one thing ("Hair_LOD0", "Hair_LOD1", or "Hair" beside them: nodes, those above
/// them or meshes of one beginning) keeps the finest, with a warning that names the others. Errors (kBadInput): no mesh was left, because the file
/// hides all that it has (`hides_all`) or because it has none.
[[nodiscard]] tl::expected<void, ToolError> keep_shown_meshes(const std::filesystem::path& path, bool hides_all,
                                                              SourceModel& model);

}  // namespace coif
