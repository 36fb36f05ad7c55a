#include "import/raw_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::importer {
namespace {

// Exporters write bind matrices as floats of their own making, and some move whole rigs a little.
constexpr double kLeastTurn = 2;      // degrees
constexpr double kLeastShift = 0.02;  // Share of the longest side of the bound mesh.

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

void measure_pose(const RawMesh& mesh, std::span<const SourceNode> nodes, SourceMesh& out) {
  const std::vector<bool> carries = carriers(mesh);
  const double side = longest_side(mesh);
  const auto first = std::size_t(std::ranges::find(carries, true) - carries.begin());
  if (first == carries.size() || !(side > 0)) return;
  const auto moved = [&](const RawBone& bone) { return nodes[bone.node].model_from_node * bone.bone_from_mesh; };
  const Eigen::Affine3d whole = moved(mesh.bones[first]);
  if (!(std::abs(whole.linear().determinant()) > 0)) return;
  for (std::size_t b = 0; b < mesh.bones.size(); ++b) {
    const RawBone& bone = mesh.bones[b];
    if (!carries[b] || !(std::abs(bone.bone_from_mesh.linear().determinant()) > 0)) continue;
    const Eigen::Affine3d own =
        whole.inverse() * moved(bone);  // The bone's motion relative to the first one, in the mesh's space.
    if (!own.matrix().allFinite()) continue;
    const Eigen::Vector3d root = bone.bone_from_mesh.inverse().translation();
    const double degrees = turn_of(own.linear()), shift = (own * root - root).norm() / side;
    const bool is_posed = degrees > kLeastTurn || shift > kLeastShift;
    if (!is_posed || (out.posed_node != kNoIndex && !(degrees > double(out.posed_degrees)))) continue;
    out.posed_node = bone.node;
    out.posed_degrees = float(degrees);
  }
}

}  // namespace coif::importer
