#include "validate/source_issues.h"

#include "cook/extract_patches.h"
#include "cook/select_hair.h"
#include "cook/weld.h"
#include "validate/hair_size.h"
#include "validate/strip_size.h"

#include <fmt/format.h>

namespace coif {
namespace {

using Issues = std::vector<Issue>;

std::string mesh_place(const SourceModel& source, std::uint32_t mesh) {
  return fmt::format("mesh '{}'", source.meshes[mesh].name);
}

void check_meshes(const SourceModel& source, const SelectedHair& hair, const Recipe& recipe, Issues& issues) {
  bool rigid = true;
  for (const std::uint32_t mesh : hair.meshes) {
    rigid = rigid && source.meshes[mesh].influences.empty();
    if (!source.meshes[mesh].uvs.empty()) continue;
    issues.push_back(
        make_issue("S203", "no texture coordinates; unwrap the strips along their length", mesh_place(source, mesh)));
  }
  if (!rigid || !source.springs.empty() || recipe.chain_source == "none") return;
  issues.push_back(make_issue("S204", "the hair follows no bone; chains will be fitted to it"));
}

void check_size(const HairMesh& mesh, Issues& issues) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& at : mesh.positions) box.extend(at);
  if (is_hair_sized(largest_side(box))) return;
  issues.push_back(make_issue(
      "S205",
      fmt::format("the hair is {:.3g} m large; hair has 0.05 .. 3 m: set \"source.metres_per_unit\" in the recipe",
                  largest_side(box))));
}

void check_strips(const HairMesh& mesh, const Recipe& recipe, Issues& issues) {
  const auto places = weld_places(mesh.positions, recipe.patch_weld_distance);
  const ExtractedPatches extracted = extract_patches(mesh, places, recipe.patch_connectivity);
  const std::size_t patches = extracted.patches.count;
  if (!is_shattered(mesh.triangle_count(), patches)) return;
  issues.push_back(make_issue("S206", fmt::format("{} triangles fall into {} patches by {}", mesh.triangle_count(),
                                                  patches, extracted.chosen)));
}

}  // namespace

Issue import_issue(const ToolError& error) {
  return make_issue(error.kind == ToolError::Kind::kUnsupported ? "S102" : "S101", error.message);
}

std::vector<Issue> find_source_issues(const SourceModel& source, const Recipe& recipe) {
  Issues issues;
  for (const std::string& warning : source.warnings) issues.push_back(make_issue("S201", warning));
  const auto hair = select_hair(source, recipe);
  if (!hair) {
    issues.push_back(make_issue("S104", hair.error().message));
    return issues;
  }
  for (const std::string& warning : hair->warnings) issues.push_back(make_issue("S202", warning));
  check_meshes(source, *hair, recipe, issues);
  check_size(hair->mesh, issues);
  check_strips(hair->mesh, recipe, issues);
  return issues;
}

}  // namespace coif
