#include "validate/asset_checks.h"
#include "validate/hair_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace coif {
namespace {

using Eigen::Vector3f;

constexpr int kMostWeight = 128;  // of 255
constexpr float kFarAway = 0.6f;  // of the hair's size

bool moves(const Asset& asset, const SkinRecord& skin) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (skin.weight[k] > 0 && asset.bones()[skin.bone[k]].kind == BoneKind::kSimulated) return true;
  }
  return false;
}

/// The simulated bone with most of the vertex's weight; null where there is none.
const BoneRecord* mover_of(const Asset& asset, const SkinRecord& skin) {
  for (std::size_t k = 0; k < 4; ++k) {
    const BoneRecord& bone = asset.bones()[skin.bone[k]];
    if (skin.weight[k] >= kMostWeight && bone.kind == BoneKind::kSimulated) return &bone;
  }
  return nullptr;
}

/// From a place to the segment that the bone is at rest, metres. Rest directions are in the parent's frame, which at rest
/// has the axes of head space.
float distance(const Vector3f& at, const BoneRecord& bone) {
  const Vector3f from = at - Vector3f(bone.joint);
  const Vector3f direction(bone.rest_direction);
  return (from - direction * std::clamp(from.dot(direction), 0.0f, bone.length)).norm();
}

void find_strays(const Asset& asset, Issues& issues) {
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(Vector3f(vertex.position));
  const float far_away = kFarAway * largest_side(box);
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchRecord& patch = asset.patches()[i];
    for (const std::uint32_t vertex : asset.indices().subspan(patch.first_index, patch.index_count)) {
      const BoneRecord* bone = mover_of(asset, asset.skin()[vertex]);
      if (bone == nullptr) continue;
      const float off = distance(Vector3f(asset.vertices()[vertex].position), *bone);
      if (off <= far_away) continue;
      const std::string mover = bone_place(asset, std::size_t(bone - asset.bones().data()));
      issues.push_back(patch_issue("A262", fmt::format("a vertex follows {}, {:.2g} m away", mover, off), i));
      break;
    }
  }
}

}  // namespace

void check_skin(const Asset& asset, Issues& issues) {
  if (asset.vertices().empty() || asset.skeleton().simulated_count == 0) return;
  if (std::ranges::none_of(asset.skin(), [&](const SkinRecord& skin) { return moves(asset, skin); })) {
    issues.push_back(make_issue("A261", "no vertex follows a simulated bone: what is drawn does not move"));
    return;
  }
  find_strays(asset, issues);
}

}  // namespace coif
