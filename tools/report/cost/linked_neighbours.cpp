#include "report/cost/measure_cost.h"

#include "lab/rig.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

namespace coif::report {
namespace {

using Eigen::Vector3f;

constexpr float kStretch = 0.1f, kShrink = 0.5f;
constexpr float kLeastGap = 1e-4f;  // metres: nearer particles have no direction between them

Vector3f end_of(const BoneRecord& bone) { return Vector3f(bone.joint) + bone.length * Vector3f(bone.rest_direction); }

std::vector<std::uint32_t> depths_of(const Asset& asset) {
  std::vector<std::uint32_t> depths;
  for (const BoneRecord& bone : asset.bones()) {
    const bool is_first = bone.parent == kNone || asset.bones()[bone.parent].kind != BoneKind::kSimulated;
    depths.push_back(is_first ? 0 : depths[bone.parent] + 1);
  }
  return depths;
}

/// The nearest chain before this one, by where their first bones end.
std::uint32_t nearest_before(const Asset& asset, std::uint32_t chain) {
  std::uint32_t nearest = kNone;
  float least = std::numeric_limits<float>::infinity();
  for (std::uint32_t other = 0; other < chain; ++other) {
    const Vector3f way = end_of(asset.bones()[asset.chains()[chain].first_bone]) -
                         end_of(asset.bones()[asset.chains()[other].first_bone]);
    if (!(way.norm() < least)) continue;
    least = way.norm();
    nearest = other;
  }
  return nearest;
}

}  // namespace

AssetContents with_neighbours_linked(const Asset& asset) {
  AssetContents contents = lab::moving_part(asset);
  contents.colliders.assign(asset.colliders().begin(), asset.colliders().end());
  contents.limits.assign(asset.limits().begin(), asset.limits().end());
  const std::vector<std::uint32_t> depths = depths_of(asset);
  for (std::uint32_t chain = 1; chain < asset.chains().size(); ++chain) {
    const ChainRecord& own = asset.chains()[chain];
    const ChainRecord& other = asset.chains()[nearest_before(asset, chain)];
    for (std::uint32_t bone = own.first_bone; bone < own.first_bone + own.bone_count; ++bone) {
      for (std::uint32_t to = other.first_bone; to < other.first_bone + other.bone_count; ++to) {
        if (depths[bone] != depths[to]) continue;
        const float gap = (end_of(asset.bones()[bone]) - end_of(asset.bones()[to])).norm();
        if (gap > kLeastGap) contents.links.push_back({bone, to, gap * (1 - kShrink), gap * (1 + kStretch)});
        break;
      }
    }
  }
  std::ranges::stable_sort(contents.links, {}, [&](const LinkRecord& link) { return depths[link.bone]; });
  return contents;
}

}  // namespace coif::report
