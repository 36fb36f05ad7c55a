#include "motion/hair_company.h"

#include "base/hair_runtime.h"

namespace coif::motion {

HairDesc HairCompany::description(const Asset& asset, const Solver* usual) const {
  HairDesc desc;
  desc.solver = usual;
  const bool in_gusts = gusts.amplitude > 0;
  const bool is_worn = colliders || pose || in_gusts;
  if (is_worn && usual == &kCoifSolver) desc.solver = &kCharacterSolver;
  desc.links = links_of(asset, *desc.solver);
  if (colliders) desc.moving_colliders = kMaxMovingColliders;
  desc.follows_poses = bool(pose);
  desc.feels_gusts = in_gusts;
  return desc;
}

Status HairCompany::tell(Hair& hair, double seconds) const {
  if (colliders) {
    const auto now = colliders(seconds);
    if (const Status status = hair.set_colliders(0, now); status != Status::kOk) return status;
  }
  if (gusts.amplitude > 0) {
    if (const Status status = hair.set_gusts(gusts); status != Status::kOk) return status;
  }
  if (!pose) return Status::kOk;
  return hair.set_pose(0, pose(seconds), {&pose_weight, 1});
}

}  // namespace coif::motion
