#include "base/words.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/select/select_hair.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace coif::cook {
namespace {

using importer::SourceMesh, importer::SourceModel;

/// An error with the first pattern without a match and the names that exist.
tl::expected<void, ToolError> check_patterns(const SourceModel& source, const char* key,
                                             const std::vector<std::string>& patterns,
                                             const std::set<std::string>& names) {
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(names, [&](const std::string& name) { return matches(name, pattern); })) continue;
    return file_failure(ToolError::Kind::kBadInput, source.path,
                        "recipe key \"hair.{}\": nothing is called '{}'; there are: {}", key, pattern,
                        fmt::join(names, ", "));
  }
  return {};
}

}  // namespace

tl::expected<void, ToolError> check_hair_names(const SourceModel& source, const HairRecipe& recipe) {
  std::set<std::string> meshes, materials, nodes;
  for (const SourceMesh& mesh : source.meshes) {
    meshes.insert(mesh.name);
    materials.insert(material_name(source, mesh));
  }
  for (const importer::SourceNode& node : source.nodes) nodes.insert(node.name);
  if (auto ok = check_patterns(source, "meshes", recipe.hair_meshes, meshes); !ok) return ok;
  if (auto ok = check_patterns(source, "materials", recipe.hair_materials, materials); !ok) return ok;
  return check_patterns(source, "bones", recipe.hair_bones, nodes);
}

}  // namespace coif::cook
