#pragma once

// Chooses the meshes of a file that are shown, and their shape; warns about the rest.

#include "base/tool_error.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace coif::importer {

/// Warns that the file hides meshes, by the names of their nodes, and that they are left out.
void warn_of_hidden(std::span<const std::string> nodes, Diagnostics& warnings);

/// Warns of meshes, or nodes with one, that are left out as coarser levels of detail; does nothing if there are none.
/// `finest`: the ones that are kept, where the caller may choose; else empty.
void warn_of_coarser(std::span<const std::string> meshes, std::span<const std::string> finest, Diagnostics& warnings);

/// A warning that shape keys are part of the mesh's shape, each as "'Longer' at 0.5"; none where none is on.
void warn_of_shape_keys(const std::string& mesh, std::span<const std::string> on, Diagnostics& warnings);

/// Keeps the finest of meshes that are levels of detail of one thing, with a warning that names the others. They are
/// recognised by names of meshes, their nodes or those above: "Hair_LOD0", "Hair_LOD1" and "Hair" beside them;
/// "Hair_L0", "Hair_L1" where they lie in one place, each has clearly fewer triangles than the one before, and nothing
/// is called "Hair_R0". With `meshes` (patterns of names) it keeps the finest of the matching ones, and every mesh that
/// is named there without a wildcard; then there is no warning.
void keep_finest_levels(std::span<const std::string> meshes, SourceModel& model);

/// The end of every reader: keep_finest_levels(). Errors (kBadInput): no mesh was left, because the file hides all that
/// it has (`hides_all`) or because it has none.
[[nodiscard]] tl::expected<void, ToolError> keep_shown_meshes(const std::filesystem::path& path, bool hides_all,
                                                              std::span<const std::string> meshes, SourceModel& model);

}  // namespace coif::importer
