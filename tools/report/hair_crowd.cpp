#include "report/hair_crowd.h"

#include "motion/head_path.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace coif {
namespace {

constexpr std::string_view kSolvers[] = {"coif", "thesis"};

constexpr Motion kMotion = Motion::kRun;
constexpr std::size_t kFramesThere = 240;  // of the motion; then they play backwards, so that nothing ever jumps
constexpr std::size_t kFramesApart = 7;    // between neighbours, so that no two heads do the same

std::vector<HeadPose> running_poses() {
  const auto path = path_of(kMotion);
  std::vector<HeadPose> poses;
  for (std::size_t i = 0; i < kFramesThere; ++i) poses.push_back(path->pose(double(i) / kCrowdRate));
  for (std::size_t i = kFramesThere - 1; i-- > 1;) poses.push_back(poses[i]);
  return poses;
}

tl::unexpected<ToolError> refused(ToolError::Kind kind, const std::string& why) {
  return tl::unexpected(ToolError{kind, "the hair cannot be simulated: " + why});
}

}  // namespace

std::span<const std::string_view> crowd_solvers() { return kSolvers; }

std::uint32_t tuned_substeps(const Asset& asset) {
  if (asset.tuning() == nullptr) return 1;
  // As the runtime rounds: a frame that is longer by rounding is not worth another part.
  const double parts = std::ceil(double(asset.tuning()->substep_rate) / kCrowdRate - 1e-3);
  return parts < 1 ? 1 : parts < kMaxSubsteps ? std::uint32_t(parts) : kMaxSubsteps;
}

void HairCrowd::FreeMemory::operator()(std::byte* bytes) const { std::free(bytes); }

HairCrowd::HairCrowd(const CrowdSettings& settings)
    : settings_(settings), poses_(settings.heads_move ? running_poses() : std::vector<HeadPose>(1)) {
  const bool published = settings.solver == "thesis";
  step_.dt = float(1 / kCrowdRate);
  (published ? step_.iterations : step_.substeps) = settings.substeps;
}

std::uint64_t HairCrowd::memory_bytes(const Asset& asset, std::uint32_t heads) {
  return Hair::memory_need(asset, {.instances = heads}).bytes;
}

tl::expected<HairCrowd, ToolError> HairCrowd::create(const Asset& asset, const CrowdSettings& settings) {
  HairDesc desc;
  desc.instances = settings.heads;
  desc.solver = settings.solver == "thesis" ? &kThesisSolver : &kCoifSolver;
  const MemoryNeed need = Hair::memory_need(asset, desc);
  if (need.bytes == 0) return refused(ToolError::Kind::kUsage, describe(Status::kBadArgument));
  HairCrowd crowd(settings);
  void* memory = nullptr;
  if (posix_memalign(&memory, need.alignment, need.bytes) != 0) {
    return refused(ToolError::Kind::kUnsupported, "no memory for " + std::to_string(settings.heads) + " heads");
  }
  crowd.memory_.reset(static_cast<std::byte*>(memory));
  const Status status = crowd.hair_.create(asset, desc, {crowd.memory_.get(), need.bytes});
  if (status != Status::kOk) return refused(ToolError::Kind::kBadInput, describe(status));
  for (std::uint32_t i = 0; i < settings.heads; ++i) {
    (void)crowd.hair_.reset(i, crowd.poses_[i * kFramesApart % crowd.poses_.size()]);
  }
  if (!crowd.step()) return refused(ToolError::Kind::kUsage, describe(Status::kBadArgument));
  return crowd;
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
