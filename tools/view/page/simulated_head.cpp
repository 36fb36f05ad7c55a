#include "view/page/simulated_head.h"

#include <new>

namespace coif::view {
namespace {

constexpr float kSettlingSeconds = 2;

}  // namespace

Status SimulatedHead::create(const Asset& asset, const Solver& solver, bool in_gusts) {
  rest_.clear();
  in_gusts_ = in_gusts && &solver == &kCoifSolver;
  if (asset.dynamics().empty()) {
    rest_.resize(asset.bones().size());
    return Status::kOk;
  }
  HairDesc desc;
  desc.solver = in_gusts_ ? &kCharacterSolver : &solver;
  desc.links = links_of(asset, *desc.solver);
  desc.feels_gusts = in_gusts_;
  const MemoryNeed need = Hair::memory_need(asset, desc);
  hair_ = Hair();
  memory_ = allocate(need);
  if (!memory_) return Status::kMemoryTooSmall;
  return hair_.create(asset, desc, {memory_.get(), need.bytes});
}

Status SimulatedHead::settle(const HeadPose& pose, const StepSettings& step) {
  if (!rest_.empty()) return Status::kOk;
  const Status status = hair_.reset(0, pose);
  return status == Status::kOk ? hair_.settle(0, kSettlingSeconds, step) : status;
}

Status SimulatedHead::step(const HeadPose& pose, Way way, const StepSettings& step, const Gusts& gusts) {
  if (!rest_.empty()) return Status::kOk;
  Status status = way == Way::kMoves ? hair_.set_head(0, pose) : hair_.teleport(0, pose);
  if (status == Status::kOk && in_gusts_) status = hair_.set_gusts(gusts);
  if (status == Status::kOk) status = hair_.step(step);
  return status;
}

std::span<const Mat34> SimulatedHead::palette() const {
  return rest_.empty() ? hair_.palette(0) : std::span<const Mat34>(rest_);
}

Status SimulatedHead::set_level(std::uint32_t level) {
  return rest_.empty() ? hair_.set_detail(0, {.level = level}) : Status::kOk;
}

}  // namespace coif::view
