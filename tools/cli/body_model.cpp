#include "cli/body_model.h"

#include "cook/name_pattern.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif {
namespace {

bool is_hair(const SourceModel& model, const SourceMesh& mesh, const Recipe& recipe) {
  const std::string& node = model.nodes[mesh.node].name;
  const std::string material = mesh.material < model.materials.size() ? model.materials[mesh.material].name : "";
  if (!recipe.hair_meshes.empty() || !recipe.hair_materials.empty()) {
    return matches_any(mesh.name, recipe.hair_meshes) || matches_any(node, recipe.hair_meshes) ||
           matches_any(material, recipe.hair_materials);
  }
  return matches(mesh.name, "*hair*") || matches(node, "*hair*") || matches(material, "*hair*");
}

}  // namespace

tl::expected<SourceModel, ToolError> keep_body(SourceModel model, const std::string& pattern, const Recipe& recipe) {
  std::vector<std::string> names;
  for (const SourceMesh& mesh : model.meshes) names.push_back(fmt::format("'{}'", mesh.name));
  std::erase_if(model.meshes, [&](const SourceMesh& mesh) {
    return pattern.empty() ? is_hair(model, mesh, recipe) : !matches(mesh.name, pattern);
  });
  if (!model.meshes.empty()) return model;
  return tl::unexpected(ToolError{
      ToolError::Kind::kBadInput,
      fmt::format("{}: no mesh is left for the body; give --body-mesh one of {}", model.path, fmt::join(names, ", "))});
}

}  // namespace coif
