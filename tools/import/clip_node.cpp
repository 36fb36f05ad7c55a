#include "import/clip_node.h"

#include "import/json_values.h"

#include <utility>

namespace coif {
namespace {

using Eigen::Affine3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;

/// False where there is a list that is not `count` finite numbers; without one, `numbers` stays as it is.
bool read_list(const json& list, double* numbers, std::size_t count) {
  if (list.is_null()) return true;
  if (!list.is_array() || list.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = number_of(list[i]);
    if (!number) return false;
    numbers[i] = *number;
  }
  return true;
}

Affine3d placed(const Vector3d& translation, const Quaterniond& rotation, const Vector3d& scale) {
  return Eigen::Translation3d(translation) * rotation * Eigen::Scaling(scale);
}

}  // namespace

std::optional<ClipNode> ClipNode::from(const json& node) {
  ClipNode out;
  const json& matrix = member(node, "matrix");
  out.has_matrix_ = !matrix.is_null();
  Eigen::Matrix4d columns = Eigen::Matrix4d::Identity();
  const bool is_read = read_list(matrix, columns.data(), 16) &&
                       read_list(member(node, "translation"), out.translation_.data(), 3) &&
                       read_list(member(node, "rotation"), out.rotation_.coeffs().data(), 4) &&
                       read_list(member(node, "scale"), out.scale_.data(), 3);
  if (!is_read || !(out.rotation_.norm() > 1.0e-3)) return std::nullopt;
  out.rotation_.normalize();
  out.rest_ = out.has_matrix_ ? Affine3d(columns) : placed(out.translation_, out.rotation_, out.scale_);
  return out;
}

bool ClipNode::animate(NodeProperty property, ClipTrack track) {
  auto& slot = tracks_[std::size_t(property)];
  if (has_matrix_ || slot) return false;
  slot = std::move(track);
  return true;
}

const std::optional<ClipTrack>& ClipNode::track(NodeProperty property) const { return tracks_[std::size_t(property)]; }

Affine3d ClipNode::at(double seconds) const {
  const auto &moves = track(NodeProperty::kTranslation), &turns = track(NodeProperty::kRotation),
             &grows = track(NodeProperty::kScale);
  if (!moves && !turns && !grows) return rest_;
  return placed(moves ? moves->vector_at(seconds) : translation_, turns ? turns->rotation_at(seconds) : rotation_,
                grows ? grows->vector_at(seconds) : scale_);
}

}  // namespace coif
