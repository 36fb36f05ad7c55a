#include "cli/body_model.h"

#include "cook/choose_hair.h"
#include "cook/name_pattern.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif {
namespace {

void remove_hair(const HairChoice& hair, SourceModel& model) {
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    std::vector<std::uint32_t>& triangles = model.meshes[m].triangles;
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (!hair.takes(m, i / 3)) kept.push_back(triangles[i]);
    }
    triangles = std::move(kept);
  }
}

}  // namespace

tl::expected<SourceModel, ToolError> keep_body(SourceModel model, const std::string& pattern, const Recipe& recipe) {
  std::vector<std::string> names;
  for (const SourceMesh& mesh : model.meshes) names.push_back(fmt::format("'{}'", mesh.name));
  if (pattern.empty()) {
    const auto hair = choose_hair(model, recipe);
    if (!hair) return tl::unexpected(hair.error());
    remove_hair(*hair, model);
  }
  std::erase_if(model.meshes, [&](const SourceMesh& mesh) {
    return mesh.triangles.empty() || !(pattern.empty() || matches(mesh.name, pattern));
  });
  if (!model.meshes.empty()) return model;
  return tl::unexpected(ToolError{
      ToolError::Kind::kBadInput,
      fmt::format("{}: no mesh is left for the body; give --body-mesh one of {}", model.path, fmt::join(names, ", "))});
}

}  // namespace coif
