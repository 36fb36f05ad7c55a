#pragma once

#include "cook/hair_mesh.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif {

/// Where the head bone is in the rest pose, model space.
struct HeadBone {
  std::uint32_t node = kNoIndex;  ///< Of the source; kNoIndex where the hair follows no node.
  std::string name = "head";
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();               ///< Metres.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< Model from the bone's own axes.
};

/// "Head", "mixamorig:Head", "J_Bip_C_Head", "Bip01 Head"; not its end marker or what is worn on it.
[[nodiscard]] bool is_called_head(const std::string& name);

/// Total skin weight of the hair on each node of the source.
using NodeWeights = std::vector<double>;

[[nodiscard]] NodeWeights hair_weights(const SourceModel& source, const HairMesh& hair);

/// The head bone: the node called `pattern`; without one the head that the file itself declares; without that the node
/// called head that carries, with all nodes below it, most of the hair's weight; failing that the lowest node above all
/// of the hair, unless it only is the node of a mesh far from it. Without any its joint is the middle of the hair. Error
/// (kBadInput): nothing is called `pattern`.
tl::expected<HeadBone, ToolError> find_head_bone(const SourceModel& source, const HairMesh& hair,
                                                 const std::string& pattern);

/// Weight on a node and everything below it.
[[nodiscard]] NodeWeights weights_below(const SourceModel& source, const NodeWeights& weights);

}  // namespace coif
