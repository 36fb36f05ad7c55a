#include "report/hair_crowd.h"

#include "motion/head_path.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace coif {
namespace {

constexpr std::string_view kPublished = "thesis";
constexpr std::string_view kSolvers[] = {"coif", kPublished};

constexpr Motion kMotion = Motion::kRun;
constexpr std::size_t kFramesThere = 240;  // of the motion; then they play backwards, so that nothing ever jumps
constexpr unsigned kMostFramesToSleep = 3600;
constexpr std::size_t kFramesApart = 7;  // between neighbours, so that no two heads do the same

std::vector<HeadPose> running_poses() {
  const auto path = path_of(kMotion);
  std::vector<HeadPose> poses;
  for (std::size_t i = 0; i < kFramesThere; ++i) poses.push_back(path->pose(double(i) / kCrowdRate));
  for (std::size_t i = kFramesThere - 1; i-- > 1;) poses.push_back(poses[i]);
  return poses;
}

HairDesc desc_of(const CrowdSettings& settings) {
  return {.instances = settings.heads,
          .solver = settings.solver == kPublished ? &kThesisSolver : &kCoifSolver,
          .instruction_set = settings.instruction_set,
          .longest_interval = settings.detail.interval};
}

tl::unexpected<ToolError> refused(ToolError::Kind kind, const std::string& why) {
  return tl::unexpected(ToolError{kind, "the hair cannot be simulated: " + why});
}

}  // namespace

std::span<const std::string_view> crowd_solvers() { return kSolvers; }

HairCrowd::HairCrowd(const CrowdSettings& settings)
    : settings_(settings), poses_(settings.heads_move ? running_poses() : std::vector<HeadPose>(1)) {
  const bool published = settings.solver == kPublished;
  step_.dt = float(1 / kCrowdRate);
  step_.substeps = settings.substeps;
  if (published) step_.iterations = std::max(settings.substeps, 1u);
  if (!settings.sleeps) step_.sleep_after = std::numeric_limits<float>::infinity();
}

std::uint64_t HairCrowd::memory_bytes(const Asset& asset, const CrowdSettings& settings) {
  return Hair::memory_need(asset, desc_of(settings)).bytes;
}

tl::expected<HairCrowd, ToolError> HairCrowd::create(const Asset& asset, const CrowdSettings& settings) {
  const HairDesc desc = desc_of(settings);
  const MemoryNeed need = Hair::memory_need(asset, desc);
  if (need.bytes == 0) return refused(ToolError::Kind::kUsage, describe(Status::kBadArgument));
  HairCrowd crowd(settings);
  crowd.memory_ = allocate(need);
  if (!crowd.memory_) {
    return refused(ToolError::Kind::kUnsupported, "no memory for " + std::to_string(settings.heads) + " heads");
  }
  const Status created = crowd.hair_.create(asset, desc, {crowd.memory_.get(), need.bytes});
  if (created != Status::kOk) return refused(ToolError::Kind::kBadInput, describe(created));
  const Status placed = crowd.place_heads();
  if (placed != Status::kOk) return refused(ToolError::Kind::kUsage, describe(placed));
  if (!crowd.step()) return refused(ToolError::Kind::kUsage, describe(Status::kBadArgument));
  for (unsigned frame = 0; frame < kMostFramesToSleep && !crowd.is_at_rest(); ++frame) (void)crowd.step();
  return crowd;
}

Status HairCrowd::place_heads() {
  for (std::uint32_t i = 0; i < settings_.heads; ++i) {
    if (const Status set = hair_.set_detail(i, settings_.detail); set != Status::kOk) return set;
    const Status reset = hair_.reset(i, poses_[i * kFramesApart % poses_.size()]);
    if (reset != Status::kOk) return reset;
  }
  return Status::kOk;
}

bool HairCrowd::is_at_rest() const {
  if (settings_.heads_move || !settings_.sleeps) return true;
  for (std::uint32_t i = 0; i < settings_.heads; ++i) {
    if (!hair_.is_asleep(i)) return false;
  }
  return true;
}

bool HairCrowd::hand_over_poses() {
  ++frame_;
  for (std::uint32_t i = 0; i < settings_.heads; ++i) {
    const HeadPose& pose = poses_[(frame_ + i * kFramesApart) % poses_.size()];
    if (hair_.set_head(i, pose) != Status::kOk) return false;
  }
  return true;
}

bool HairCrowd::step() {
  if (settings_.frame_time_varies) {
    // Steps of an odd length through a cycle of odd length: no two frames that follow each other are alike.
    const double share = double(frame_ * 37 % 101) / 100;
    step_.dt = float((0.9 + 0.2 * share) / kCrowdRate);
  }
  return hand_over_poses() && hair_.step(step_) == Status::kOk;
}

}  // namespace coif
