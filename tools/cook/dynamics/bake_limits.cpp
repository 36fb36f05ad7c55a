#include "cook/dynamics/bake_dynamics.h"

#include "base/geometry.h"
#include "base/words.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kNearlyAlong = 0.995;  ///< Cosine of 5.7 degrees: an axis this near to the bone bounds nothing.

LimitRecord limit_record(LimitKind kind, double first, double second, const Eigen::Quaterniond& rotation) {
  LimitRecord record{};
  record.kind = kind;
  record.angles[0] = std::min(float(first), kNoAngleLimit);
  record.angles[1] = std::min(float(second), kMostYaw);
  const Eigen::Quaternionf stored = rotation.cast<float>().normalized();
  std::copy_n(stored.coeffs().data(), 4, record.rotation);  // Eigen keeps x, y, z, w
  return record;
}

LimitRecord no_limit() { return limit_record(LimitKind::kUnlimited, 0, 0, Eigen::Quaterniond::Identity()); }

LimitKind kind_of(importer::SourceLimit::Kind kind) {
  switch (kind) {
    case importer::SourceLimit::Kind::kUnlimited: return LimitKind::kUnlimited;
    case importer::SourceLimit::Kind::kCone: return LimitKind::kCone;
    case importer::SourceLimit::Kind::kHinge: return LimitKind::kHinge;
    case importer::SourceLimit::Kind::kSpherical: return LimitKind::kSpherical;
  }
  return LimitKind::kUnlimited;
}

/// Y along the bone, X as near to the axis as that leaves.
Eigen::Quaterniond axes_about(const Vector3d& along, Vector3d axis) {
  axis.normalize();
  if (std::abs(axis.dot(along)) > kNearlyAlong) {
    axis = std::abs(along.z()) < kNearlyAlong ? Vector3d::UnitZ() : Vector3d::UnitX();
  }
  Eigen::Matrix3d axes;
  axes.col(0) = (axis - axis.dot(along) * along).normalized();
  axes.col(1) = along;
  axes.col(2) = axes.col(0).cross(along);
  return Eigen::Quaterniond(axes);
}

LimitRecord limit_of_recipe(const RecipeBoneLimit& said, const SkeletonBone& bone) {
  if (said.kind == "none") return no_limit();
  const Vector3d along = (bone.tail - bone.start).normalized();
  const Eigen::Quaterniond axes = axes_about(along, {said.axis[0], said.axis[1], said.axis[2]});
  const LimitKind kind = said.kind == "cone"    ? LimitKind::kCone
                         : said.kind == "hinge" ? LimitKind::kHinge
                                                : LimitKind::kSpherical;
  return limit_record(kind, said.angle * kDegree, said.yaw * kDegree, axes);
}

std::string moving_names(const Skeleton& skeleton) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> names;
  for (const SkeletonBone& bone : skeleton.bones) {
    if (bone.kind == BoneKind::kSimulated && names.size() <= kMost) names.push_back(bone.name);
  }
  if (names.size() > kMost) names.back() = "...";
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

tl::expected<std::vector<LimitRecord>, ToolError> bake_limits(const importer::SourceModel& source,
                                                              const Skeleton& skeleton, const RigRecipe& recipe,
                                                              Findings& findings) {
  std::vector<LimitRecord> limits(skeleton.bones.size(), no_limit());
  if (recipe.dynamics_source != DynamicsSource::kCurves) {
    const std::vector<BoneJoint> joints = joints_of_bones(source, skeleton);
    for (std::size_t b = 0; b < joints.size(); ++b) {
      if (!joints[b]) continue;
      const importer::SourceLimit& limit = joints[b].joint->limit;
      limits[b] = limit_record(kind_of(limit.kind), limit.angles[0], limit.angles[1], limit.rotation);
    }
  }
  for (std::size_t i = 0; i < recipe.limits.size() && skeleton.simulated_count() > 0; ++i) {
    bool any = false;
    for (std::size_t b = 0; b < limits.size(); ++b) {
      const SkeletonBone& bone = skeleton.bones[b];
      if (bone.kind != BoneKind::kSimulated || !matches_any(bone.name, recipe.limits[i].bones)) continue;
      limits[b] = limit_of_recipe(recipe.limits[i], bone);
      any = true;
    }
    if (any) continue;
    return tl::unexpected(
        ToolError{ToolError::Kind::kBadInput,
                  fmt::format("{}: \"dynamics.limits\" [{}]: no bone that moves is called {}; there are {}",
                              source.path, i, fmt::join(recipe.limits[i].bones, ", "), moving_names(skeleton))});
  }
  const auto count =
      std::ranges::count_if(limits, [](const LimitRecord& l) { return l.kind != LimitKind::kUnlimited; });
  if (count == 0) return std::vector<LimitRecord>{};
  findings.note(fmt::format("{} of {} simulated bones have a limit", count, skeleton.simulated_count()));
  return limits;
}

}  // namespace coif::cook
