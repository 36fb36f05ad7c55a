#include "placed_colliders.h"
#include "rows.h"
#include "vector_math.h"

namespace coif {
namespace {

/// An angle of `widest` or more is no limit; its cosine and sine are then exact, not rounded.
void set_angle(float radians, float widest, float widest_cosine, std::uint32_t lane, Lanes& cosine, Lanes& sine) {
  const auto angle = plain::sine_cosine(double(radians));
  const bool is_none = radians >= widest;
  cosine.v[lane] = is_none ? widest_cosine : float(angle.cosine);
  sine.v[lane] = is_none ? 1.0f + widest_cosine : float(angle.sine);
}

}  // namespace

/// A hinge is a spherical limit whose second angle is 0. So is a cone of angle 0, since only locks stop both ways.
void set_limit(const LimitRecord& limit, std::uint32_t lane, LimitLanes& lanes) {
  const float first = limit.kind == LimitKind::kUnlimited ? kNoAngleLimit : limit.angles[0];
  const bool is_round = limit.kind <= LimitKind::kCone && first > 0.0f;
  lanes.is_cone.v[lane] = is_round ? 1.0f : 0.0f;
  set_angle(first, kNoAngleLimit, -1.0f, lane, lanes.first_cosine, lanes.first_sine);
  set_angle(limit.angles[1], kMostYaw, 0.0f, lane, lanes.second_cosine, lanes.second_sine);
  const OwnAxes axes = axes_of(renormalised(to_quat(limit.rotation)));
  set_lane(lanes.axes.x, lane, axes.x);
  set_lane(lanes.axes.y, lane, axes.y);
  set_lane(lanes.axes.z, lane, axes.z);
}

void set_limits(const Asset& asset, std::span<const Row> rows, std::span<RowBone> bones, std::span<LimitLanes> limits) {
  for (const Row& row : rows) {
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
        const LimitRecord& limit = asset.limits()[bone_in_lane(asset, row, i, lane)];
        set_limit(limit, lane, limits[row.first_bone + i]);
        if (limit.kind != LimitKind::kUnlimited) bones[row.first_bone + i].features |= kRowIsBounded;
      }
    }
  }
}

}  // namespace coif
