#include "motion/head_path.h"

#include <cmath>
#include <cstddef>
#include <new>
#include <span>
#include <string>

namespace coif {
namespace {

constexpr double kRate = 60;  // Hz
constexpr int kSettleSteps = 120;

/// Memory that Hair::create() asks for.
class AlignedBlock {
 public:
  explicit AlignedBlock(const MemoryNeed& need)
      : need_(need), bytes_(static_cast<std::byte*>(::operator new (need.bytes, std::align_val_t{need.alignment}))) {}
  AlignedBlock(const AlignedBlock&) = delete;
  AlignedBlock& operator=(const AlignedBlock&) = delete;
  ~AlignedBlock() { ::operator delete (bytes_, std::align_val_t{need_.alignment}); }
  [[nodiscard]] std::span<std::byte> span() const { return {bytes_, need_.bytes}; }

 private:
  MemoryNeed need_;
  std::byte* bytes_;
};

tl::unexpected<ToolError> failed(Status status) {
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, std::string("the hair cannot be simulated: ") + describe(status)});
}

}  // namespace

tl::expected<HairPose, ToolError> simulate_pose(const Asset& asset, const HeadPath* motion, double seconds,
                                                StepSettings step) {
  const auto pose_at = [motion](double time) { return motion ? motion->pose(time) : HeadPose{}; };
  if (asset.dynamics().empty()) return HairPose{pose_at(seconds), std::vector<Mat34>(asset.bones().size())};

  step.dt = static_cast<float>(1 / kRate);
  Hair hair;
  const AlignedBlock memory(Hair::memory_need(asset, {}));
  if (const Status status = hair.create(asset, {}, memory.span()); status != Status::kOk) return failed(status);
  if (const Status status = hair.reset(0, pose_at(0)); status != Status::kOk) return failed(status);

  const int motion_steps = motion ? static_cast<int>(std::lround(seconds * kRate)) : 0;
  for (int i = 1 - kSettleSteps; i <= motion_steps; ++i) {
    const HeadPose pose = pose_at(i > 0 ? i / kRate : 0);
    if (const Status status = hair.set_head(0, pose); status != Status::kOk) return failed(status);
    if (const Status status = hair.step(step); status != Status::kOk) return failed(status);
  }
  const std::span<const Mat34> palette = hair.palette(0);
  return HairPose{pose_at(motion_steps / kRate), {palette.begin(), palette.end()}};
}

}  // namespace coif
