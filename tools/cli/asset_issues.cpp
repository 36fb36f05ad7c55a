#include "cli/asset_issues.h"

#include "animation/constraint_error.h"

#include <fmt/format.h>

#include <cstddef>

namespace coif {
namespace {

using Issues = std::vector<Issue>;

Vec3 resting_particle(const BoneRecord& bone) {
  return {bone.joint[0] + bone.length * bone.rest_direction[0], bone.joint[1] + bone.length * bone.rest_direction[1],
          bone.joint[2] + bone.length * bone.rest_direction[2]};
}

/// Rigid bones have length 0 and rest at their joint.
std::vector<Vec3> resting_particles(const Asset& asset) {
  std::vector<Vec3> particles;
  for (const BoneRecord& bone : asset.bones()) particles.push_back(resting_particle(bone));
  return particles;
}

void find_absent_parts(const Asset& asset, Issues& issues) {
  if (asset.vertices().empty()) {
    issues.push_back({"A201", Severity::kWarning, "no mesh: it can be simulated but not drawn", ""});
  }
  if (asset.skeleton().simulated_count == 0) {
    issues.push_back(
        {"A202", Severity::kWarning, "no simulated bone: the hair is rigid; name the hair's bones in the recipe", ""});
  }
  if (asset.colliders().empty() && asset.skeleton().simulated_count > 0) {
    issues.push_back({"A203", Severity::kWarning, "no collider: hair will pass through the head", ""});
  }
  if (!asset.vertices().empty() && !asset.texture(TextureRole::kBaseColor)) {
    issues.push_back({"A204", Severity::kInfo, "no base colour texture: strips are drawn as solid cards", ""});
  }
}

void find_resting_penetration(const Asset& asset, const std::vector<Vec3>& particles, Issues& issues) {
  constexpr float kTolerance = 0.01f;  // of the head's radius
  const float depth = worst_penetration(asset, particles);
  if (depth > kTolerance) {
    issues.push_back({"A205", Severity::kInfo,
                      fmt::format("the rest pose is up to {:.0f} % of the head's radius inside the head: "
                                  "the simulation will push it out",
                                  100 * depth),
                      ""});
  }
}

void find_dark_vertices(const Asset& asset, Issues& issues) {
  std::size_t count = 0;
  for (const VertexRecord& vertex : asset.vertices()) {
    count += vertex.normal[0] == 0 && vertex.normal[1] == 0 && vertex.normal[2] == 0 ? 1 : 0;
  }
  if (count > 0) {
    issues.push_back(
        {"A206", Severity::kWarning, fmt::format("{} vertices without a normal are lit wrongly", count), "chunk VERT"});
  }
}

void find_unused_bones(const Asset& asset, Issues& issues) {
  if (asset.skin().empty()) return;
  std::vector<bool> used(asset.bones().size(), false);
  for (const SkinRecord& skin : asset.skin()) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (skin.weight[k] > 0) used[skin.bone[k]] = true;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    count += !used[i] && asset.bones()[i].kind == BoneKind::kSimulated ? 1 : 0;
  }
  if (count > 0) {
    issues.push_back({"A207", Severity::kInfo, fmt::format("no vertex follows {} of the simulated bones", count), ""});
  }
}

}  // namespace

std::vector<Issue> find_asset_issues(const Asset& asset) {
  Issues issues;
  const std::vector<Vec3> particles = resting_particles(asset);
  find_absent_parts(asset, issues);
  find_resting_penetration(asset, particles, issues);
  find_dark_vertices(asset, issues);
  find_unused_bones(asset, issues);
  return issues;
}

}  // namespace coif
