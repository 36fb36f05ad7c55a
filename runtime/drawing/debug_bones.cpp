#include "drawing/debug_pen.h"

namespace coif {
namespace {

using Kind = DebugLine::Kind;

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

}  // namespace coif
