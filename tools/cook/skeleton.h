#pragma once

#include <coif/asset_records.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace coif {

struct SkeletonBone {
  std::string name;
  std::uint32_t parent = kNone;
  BoneKind kind = BoneKind::kScalp;
  std::uint32_t chain = kNone;
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< Model space, metres; of a bone below a simulated one: its tail.
  Eigen::Vector3d tail = Eigen::Vector3d::Zero();   ///< The particle at rest; of a rigid bone its start.
  double place = 0;  ///< Of the tail along its chain, 0 root .. 1 farthest tip, by length.

  [[nodiscard]] double length() const { return (tail - start).norm(); }
};

/// The hair's bones in the order of the asset: head, scalp, chains.
struct Skeleton {
  std::vector<SkeletonBone> bones;
  std::vector<ChainRecord> chains;
  std::vector<std::uint32_t> bone_of_node;  ///< For each source node the bone that carries its vertices.
  Eigen::Quaterniond head_rotation = Eigen::Quaterniond::Identity();  ///< Model from the head bone's own axes.
  std::vector<std::string> warnings;

  [[nodiscard]] std::size_t simulated_count() const {
    std::size_t count = 0;
    for (const SkeletonBone& bone : bones) count += bone.kind == BoneKind::kSimulated ? 1 : 0;
    return count;
  }
};

}  // namespace coif
