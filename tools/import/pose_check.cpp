#include "import/raw_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace coif {
namespace {

// Exporters write bind matrices as floats of their own making, and some move whole rigs a little.
constexpr double kLeastTurn = 2;       // degrees
constexpr double kLeastShift = 0.02;  // of the bound mesh's longest side

/// How far a bone stands from where it was bound, beside another.
struct Displacement {
  double degrees = 0;
  double shift = 0;  ///< Of the longest side.
};

double longest_side(const RawMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& position : mesh.positions) {
    if (position.allFinite()) box.extend(position);
  }
  return box.isEmpty() ? 0 : double(box.sizes().maxCoeff());
}

double turn_of(const Eigen::Matrix3d& linear) {
  const Eigen::Matrix3d rotation = Eigen::Affine3d(linear).rotation();
  return Eigen::AngleAxisd(rotation).angle() * 180 / std::numbers::pi;
}

/// Whether the bone carries any of the mesh.
std::vector<bool> carriers(const RawMesh& mesh) {
  std::vector<bool> out(mesh.bones.size(), false);
  for (const RawWeight& weight : mesh.weights) {
    if (weight.bone < out.size() && weight.weight > 0) out[weight.bone] = true;
  }
  return out;
}

}  // namespace

void warn_of_pose(std::span<const RawMesh> meshes, std::span<const SourceNode> nodes, std::vector<std::string>& warnings) {
  std::map<std::uint32_t, Displacement> posed;  // by node
  for (const RawMesh& mesh : meshes) {
    const std::vector<bool> carries = carriers(mesh);
    const double side = longest_side(mesh);
    const auto first = std::size_t(std::ranges::find(carries, true) - carries.begin());
    if (first == carries.size() || !(side > 0)) continue;
    const auto moved = [&](const RawBone& bone) { return nodes[bone.node].model_from_node * bone.bone_from_mesh; };
    const Eigen::Affine3d whole = moved(mesh.bones[first]);
    if (!(std::abs(whole.linear().determinant()) > 0)) continue;
    for (std::size_t b = 0; b < mesh.bones.size(); ++b) {
      const RawBone& bone = mesh.bones[b];
      if (!carries[b] || !(std::abs(bone.bone_from_mesh.linear().determinant()) > 0)) continue;
      const Eigen::Affine3d own = whole.inverse() * moved(bone);  // of the bone beside the first, in the mesh's space
      if (!own.matrix().allFinite()) continue;
      const Eigen::Vector3d root = bone.bone_from_mesh.inverse().translation();
      Displacement& far = posed[bone.node];
      far.degrees = std::max(far.degrees, turn_of(own.linear()));
      far.shift = std::max(far.shift, (own * root - root).norm() / side);
    }
  }
  std::erase_if(posed, [](const auto& entry) { return entry.second.degrees < kLeastTurn && entry.second.shift < kLeastShift; });
  if (posed.empty()) return;
  const auto farthest = std::ranges::max_element(posed, {}, [](const auto& entry) { return entry.second.degrees; });
  warnings.push_back(fmt::format(
      "{} of the skeleton stand{} otherwise than when the meshes were bound to them ('{}' by {:.0f} degrees): the file was saved in a "
      "pose, and that pose is taken for the hair's shape; put the armature into its rest position and export again where that is not meant",
      posed.size() == 1 ? "1 bone" : fmt::format("{} bones", posed.size()), posed.size() == 1 ? "s" : "", nodes[farthest->first].name,
      farthest->second.degrees));
}

}  // namespace coif
