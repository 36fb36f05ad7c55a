#include "rows.h"
#include "vector_math.h"

namespace coif {
namespace {

void set_angle(float radians, float widest, std::uint32_t lane, Lanes& cosine, Lanes& sine) {
  const bool is_quarter = widest < kNoAngleLimit;
  const auto of = plain::sine_cosine(double(radians));
  // The widest is none, and shall be none exactly.
  cosine.v[lane] = radians < widest ? float(of.cosine) : is_quarter ? 0.0f : -1.0f;
  sine.v[lane] = radians < widest ? float(of.sine) : is_quarter ? 1.0f : 0.0f;
}

/// A hinge is a spherical limit whose second angle is 0, and so is a cone that leaves nothing: only locks stop both ways.
void set_limit(const LimitRecord& limit, std::uint32_t lane, LimitLanes& lanes) {
  const bool is_limited = limit.kind != LimitKind::kUnlimited;
  const float first = is_limited ? limit.angles[0] : kNoAngleLimit;
  const float second = limit.kind == LimitKind::kSpherical ? limit.angles[1] : 0.0f;
  const bool is_round = !is_limited || limit.kind == LimitKind::kCone;
  lanes.is_cone.v[lane] = is_round && first > 0.0f ? 1.0f : 0.0f;
  set_angle(first, kNoAngleLimit, lane, lanes.first_cosine, lanes.first_sine);
  set_angle(second, kMostYaw, lane, lanes.second_cosine, lanes.second_sine);
  const float* const q = limit.rotation;
  const Quat axes = is_limited ? renormalised({q[0], q[1], q[2], q[3]}) : Quat{};
  set_lane(lanes.axes.x, lane, rotate(axes, Vec3{1, 0, 0}));
  set_lane(lanes.axes.y, lane, rotate(axes, Vec3{0, 1, 0}));
  set_lane(lanes.axes.z, lane, rotate(axes, Vec3{0, 0, 1}));
}

}  // namespace

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
