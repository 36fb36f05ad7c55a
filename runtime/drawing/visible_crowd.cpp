#include "drawing/head_pose.h"

#include <coif/drawing.h>

#include <cmath>
#include <cstring>

namespace coif {
namespace {

/// View from head space.
struct HeadMatrix {
  float rows[3][4];
};

/// The pose must be valid. Computed in double, because a head may be far from the world's origin.
HeadMatrix head_matrix(const HeadPose& pose, const Vec3& eye) {
  const HeadTurn turn = turn_of(pose);
  const double from_eye[3] = {pose.position[0] - eye.x, pose.position[1] - eye.y, pose.position[2] - eye.z};
  HeadMatrix head;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) head.rows[i][k] = static_cast<float>(turn.rows[i][k]);
    head.rows[i][3] = static_cast<float>(from_eye[i]);
  }
  return head;
}

}  // namespace

Status check_instance(const DrawnHair& hair, const HairInstance& instance) {
  const bool may_lack = hair.skinning == Skinning::kRigid && instance.palette.empty();
  if (instance.palette.size() != hair.bone_count && !may_lack) return Status::kSizeMismatch;
  if (instance.lod >= hair.lod_count) return Status::kBadArgument;
  return check_pose(instance.head);
}

MatrixLayout matrix_layout_of(const DrawnHair& hair, std::uint32_t block_bytes, std::uint32_t frames) {
  MatrixLayout layout;
  layout.frames = frames;
  const bool is_skinned = hair.skinning != Skinning::kRigid;
  const std::size_t bytes = frames * (1 + std::size_t{hair.bone_count}) * sizeof(Mat34);
  layout.bones_in_texture = is_skinned && bytes > block_bytes;
  if (is_skinned && !layout.bones_in_texture) layout.rows_of_head += MatrixLayout::kMatrixRows * hair.bone_count;
  layout.rows_of_head *= frames;
  if (!layout.bones_in_texture) {
    layout.heads_of_batch = block_bytes / (layout.rows_of_head * MatrixLayout::kRowBytes);
  }
  return layout;
}

void write_head(const MatrixLayout& layout, const HairInstance& instance, const Vec3& eye, std::byte* to) {
  const HeadMatrix head = head_matrix(instance.head, eye);
  std::memcpy(to, &head, sizeof head);
  if (layout.rows_of_frame() > MatrixLayout::kMatrixRows) {
    std::memcpy(to + sizeof head, instance.palette.data(), instance.palette.size_bytes());
  }
}

// A point is in view where -w <= x, y, z <= w. So the six planes are sums and differences of the matrix's rows.
VisibleCrowd::VisibleCrowd(const DrawnHair& hair, std::span<const HairInstance> instances, const Vec3& eye,
                           const float (&clip)[16])
    : hair_(hair), instances_(instances), eye_(eye) {
  for (int i = 0; i < 6; ++i) {
    const int row = i / 2;
    const float sign = i % 2 == 0 ? 1.0f : -1.0f;
    float* const plane = planes_[i];
    for (int column = 0; column < 4; ++column) plane[column] = clip[4 * column + 3] + sign * clip[4 * column + row];
    const float length = std::sqrt(plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2]);
    if (!(length > 0.0f)) continue;
    for (int column = 0; column < 4; ++column) plane[column] /= length;
  }
  for (const HairInstance& instance : instances) {
    if (!is_seen(instance)) continue;
    const Group group = group_of(instance);
    orders_of_lod_[group.lod] |= 1u << group.order;
  }
}

/// False only where the whole ball that the hair stays in is out of view.
bool VisibleCrowd::is_seen(const HairInstance& instance) const {
  const HeadMatrix head = head_matrix(instance.head, eye_);
  float center[3];
  for (int i = 0; i < 3; ++i) {
    center[i] = head.rows[i][3];
    for (int k = 0; k < 3; ++k) center[i] += head.rows[i][k] * hair_.reach.center[k];
  }
  for (const float(&plane)[4] : planes_) {
    const float inside = plane[0] * center[0] + plane[1] * center[1] + plane[2] * center[2] + plane[3];
    if (inside < -hair_.reach.radius * instance.head.scale) return false;
  }
  return true;
}

VisibleCrowd::Group VisibleCrowd::group_of(const HairInstance& instance) const {
  if (hair_.order_count < 2) return {instance.lod, 0};
  const HeadMatrix head = head_matrix(instance.head, eye_);
  float towards_eye[3] = {};  // head space, of any length
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) towards_eye[i] -= head.rows[k][i] * head.rows[k][3];
  }
  return {instance.lod, hair_.order_of_view[view_cell(towards_eye)]};
}

std::size_t VisibleCrowd::find(const Group& group, std::size_t first) const {
  std::size_t i = first;
  while (i < instances_.size() && !(is_seen(instances_[i]) && group_of(instances_[i]) == group)) ++i;
  return i;
}

std::uint32_t VisibleCrowd::count(const Group& group, std::size_t first, std::uint32_t most) const {
  std::uint32_t heads = 0;
  for (std::size_t i = first; heads < most; ++i, ++heads) {
    i = find(group, i);
    if (i == instances_.size()) break;
  }
  return heads;
}

}  // namespace coif
