#include "drawing/head_pose.h"

#include <coif/bounds.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coif {
namespace {

// Share of the numbers that add up to a coordinate: renderers sum them in other orders and with other precision.
constexpr float kBoundRounding = 1e-6f;

/// A box that grows, by axis.
struct Extent {
  float low[3] = {INFINITY, INFINITY, INFINITY};
  float high[3] = {-INFINITY, -INFINITY, -INFINITY};

  void add(int axis, float from, float to) {
    if (from < low[axis]) low[axis] = from;
    if (to > high[axis]) high[axis] = to;
  }
};

// While boxes are filled, `center` and `half` hold the lowest and highest place.
void grow(BoneBox& box, const float (&p)[3]) {
  float* const low = &box.center.x;
  float* const high = &box.half.x;
  for (int i = 0; i < 3; ++i) {
    if (p[i] < low[i]) low[i] = p[i];
    if (p[i] > high[i]) high[i] = p[i];
  }
}

void settle(BoneBox& box) {
  if (box.center.x > box.half.x) {
    box = {};
    return;
  }
  float* const center = &box.center.x;
  float* const half = &box.half.x;
  for (int i = 0; i < 3; ++i) {
    const float low = center[i], high = half[i], middle = 0.5f * (low + high);
    center[i] = middle;
    half[i] = middle - low > high - middle ? middle - low : high - middle;
  }
}

void add_moved(const BoneBox& box, const Mat34& matrix, Extent& all) {
  const float center[3] = {box.center.x, box.center.y, box.center.z}, half[3] = {box.half.x, box.half.y, box.half.z};
  for (int i = 0; i < 3; ++i) {
    const float(&row)[4] = matrix.m[i];
    float middle = row[3], reach = 0, size = std::fabs(row[3]);
    for (int k = 0; k < 3; ++k) {
      const float turned = row[k] * center[k], wide = std::fabs(row[k]) * half[k];
      middle += turned;
      reach += wide;
      size += std::fabs(turned) + wide;
    }
    reach += kBoundRounding * size;
    all.add(i, middle - reach, middle + reach);
  }
}

}  // namespace

Status find_bone_boxes(const Asset& asset, std::span<BoneBox> boxes) {
  if (!asset.is_open() || asset.vertices().empty()) return Status::kAssetLacksData;
  if (boxes.size() != asset.bones().size()) return Status::kSizeMismatch;
  for (BoneBox& box : boxes) box = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (std::size_t v = 0; v < asset.vertices().size(); ++v) {
    const float(&position)[3] = asset.vertices()[v].position;
    if (asset.skin().empty()) {
      grow(boxes[0], position);
      continue;
    }
    const SkinRecord& skin = asset.skin()[v];
    for (int k = 0; k < 4; ++k) {
      if (skin.weight[k] != 0) grow(boxes[skin.bone[k]], position);
    }
  }
  for (BoneBox& box : boxes) settle(box);
  return Status::kOk;
}

Status bound_hair(std::span<const BoneBox> boxes, std::span<const Mat34> palette, HairBounds& bounds) {
  if (palette.size() != boxes.size()) return Status::kSizeMismatch;
  Extent all;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (boxes[b].half.x >= 0.0f) add_moved(boxes[b], palette[b], all);
  }
  if (!(all.low[0] <= all.high[0])) return Status::kAssetLacksData;
  bounds = {{all.low[0], all.low[1], all.low[2]}, {all.high[0], all.high[1], all.high[2]}};
  return Status::kOk;
}

WorldBounds bounds_in_world(const HairBounds& bounds, const HeadPose& head) {
  const HeadTurn turn = turn_of(head);
  const float low[3] = {bounds.lowest.x, bounds.lowest.y, bounds.lowest.z};
  const float high[3] = {bounds.highest.x, bounds.highest.y, bounds.highest.z};
  constexpr double kLarger = 1 + double(kBoundRounding);  // Covers the rounding of the halves to float.
  WorldBounds world;
  double half[3] = {}, square = 0;
  for (int k = 0; k < 3; ++k) {
    const double side = 0.5 * (double(high[k]) - double(low[k]));
    square += side * side;
    for (int i = 0; i < 3; ++i) {
      world.center[i] += turn.rows[i][k] * 0.5 * (double(low[k]) + double(high[k]));
      half[i] += std::fabs(turn.rows[i][k]) * side;
    }
  }
  for (int i = 0; i < 3; ++i) world.center[i] += head.position[i];
  const auto enlarged = [](double value) { return static_cast<float>(value * kLarger); };
  world.half = {enlarged(half[0]), enlarged(half[1]), enlarged(half[2])};
  world.radius = enlarged(double(head.scale) * std::sqrt(square));
  return world;
}

}  // namespace coif
