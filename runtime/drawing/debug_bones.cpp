#include "drawing/debug_pen.h"

namespace coif {
namespace {

using Kind = DebugLine::Kind;

void draw_cone(const debug::Pen& pen, std::uint32_t index, const BoneRecord& bone, float limit, const Mat34& parent,
               const Vec3& start) {
  const Vec3 rest{bone.rest_direction[0], bone.rest_direction[1], bone.rest_direction[2]};
  const Vec3 axis = debug::unit(debug::turned(parent, rest));
  const debug::Across side = debug::across(axis);
  const Vec3 middle = debug::plus(start, debug::times(axis, bone.length * std::cos(limit)));
  const float radius = bone.length * std::sin(limit);
  const Vec3 u = debug::times(side.u, radius), v = debug::times(side.v, radius);
  pen.arc(Kind::kLimit, index, middle, u, v);
  for (const Vec3& rim : {u, v, debug::times(u, -1), debug::times(v, -1)}) {
    pen.line(Kind::kLimit, index, start, debug::plus(middle, rim));
  }
}

}  // namespace

Status draw_bone_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines) {
  if (const Status status = debug::check(asset, instance, lines); status != Status::kOk) return status;
  const debug::Pen pen(instance.head, lines);
  for (std::uint32_t b = 1; b < asset.bones().size(); ++b) {
    const BoneRecord& bone = asset.bones()[b];
    const debug::PosedBone own = debug::posed(bone, instance.palette[b]);
    if (bone.kind == BoneKind::kSimulated) {
      pen.line(Kind::kBone, b, own.start, own.end);
    } else {
      const debug::PosedBone above = debug::posed(asset.bones()[bone.parent], instance.palette[bone.parent]);
      pen.line(Kind::kRigidBone, b, above.start, own.start);
    }
  }
  return Status::kOk;
}

// A kind of limit beside the cone is a case more here.
Status draw_limit_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines) {
  if (const Status status = debug::check(asset, instance, lines); status != Status::kOk) return status;
  if (asset.dynamics().empty()) return Status::kOk;  // nothing moves
  const debug::Pen pen(instance.head, lines);
  for (std::uint32_t b = 1; b < asset.bones().size(); ++b) {
    const BoneRecord& bone = asset.bones()[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const float limit = asset.dynamics()[b].angle_limit;
    if (limit >= kNoAngleLimit) continue;
    draw_cone(pen, b, bone, limit, instance.palette[bone.parent], debug::posed(bone, instance.palette[b]).start);
  }
  return Status::kOk;
}

}  // namespace coif
