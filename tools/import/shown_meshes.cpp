#include "import/shown_meshes.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif::importer {
namespace {

constexpr std::size_t kShownNames = 6;

std::string list_of_names(std::span<const std::string> names) {
  return fmt::format("'{}'{}", fmt::join(names.first(std::min(names.size(), kShownNames)), "', '"),
                     names.size() > kShownNames ? " ..." : "");
}

}  // namespace

void warn_of_hidden(std::span<const std::string> nodes, Diagnostics& warnings) {
  if (nodes.empty()) return;
  warn(warnings, source_code::kHidden,
       "{} left out, since the file hides {}: {}; show {} and export again where {} hair",
       counted(nodes.size(), "mesh", "meshes"), nodes.size() == 1 ? "it" : "them", list_of_names(nodes),
       nodes.size() == 1 ? "it" : "them", nodes.size() == 1 ? "it is" : "they are");
}

void warn_of_coarser(std::span<const std::string> meshes, std::span<const std::string> finest, Diagnostics& warnings) {
  if (meshes.empty()) return;
  warn(warnings, source_code::kCoarser,
       "{} left out as coarser levels of detail of {}: {}; the cook makes levels of its own{}",
       counted(meshes.size(), "mesh", "meshes"),
       finest.empty() ? "what is there in a finer one" : list_of_names(finest), list_of_names(meshes),
       finest.empty() ? "" : "; name another in the recipe's \"hair.meshes\" where that is meant");
}

void warn_of_shape_keys(const std::string& mesh, std::span<const std::string> on, Diagnostics& warnings) {
  if (on.empty()) return;
  warn(warnings, source_code::kShapeKeys,
       "mesh '{}': shape keys are on ({}) and are part of the hair's shape; turn them off and export again "
       "where that is not meant",
       mesh, fmt::join(on, ", "));
}

tl::expected<void, ToolError> keep_shown_meshes(const std::filesystem::path& path, bool hides_all,
                                                std::span<const std::string> meshes, SourceModel& model) {
  using Kind = ToolError::Kind;
  if (model.meshes.empty() && hides_all)
    return file_failure(Kind::kBadInput, path, "hides all of its meshes; show the hair and export again");
  if (model.meshes.empty()) {
    return file_failure(Kind::kBadInput, path,
                        "no usable triangles; convert curves and hair particles to polygon strips before the export");
  }
  keep_finest_levels(meshes, model);
  return {};
}

}  // namespace coif::importer
