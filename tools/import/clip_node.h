#pragma once

#include "import/clip_track.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <array>
#include <optional>

namespace coif {

/// A node's place in its parent, at rest and while it is animated.
class ClipNode {
 public:
  /// Null unless the node's numbers are finite.
  static std::optional<ClipNode> from(const nlohmann::json& node);

  /// False where this property moves already, or the node is given as a matrix, which nothing can animate.
  bool animate(NodeProperty property, ClipTrack track);
  [[nodiscard]] const std::optional<ClipTrack>& track(NodeProperty property) const;

  [[nodiscard]] Eigen::Affine3d at_rest() const { return rest_; }
  [[nodiscard]] Eigen::Affine3d at(double seconds) const;

 private:
  Eigen::Affine3d rest_ = Eigen::Affine3d::Identity();
  bool has_matrix_ = false;
  Eigen::Vector3d translation_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale_ = Eigen::Vector3d::Ones();
  std::array<std::optional<ClipTrack>, 3> tracks_;
};

}  // namespace coif
