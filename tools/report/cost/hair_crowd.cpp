#include "motion/head_path.h"
#include "report/cost/measure_cost.h"

#include <coif/instruction_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

constexpr std::string_view kPublished = "thesis";
constexpr std::string_view kSolvers[] = {"coif", kPublished};

constexpr motion::Motion kMotion = motion::Motion::kRun;
constexpr std::size_t kFramesThere =
    240;  // Frames of the motion; then they play backwards, so that nothing ever jumps.
constexpr unsigned kMostFramesToSleep = 3600;
constexpr std::size_t kFramesApart = 7;  // between neighbours, so that no two heads do the same

std::vector<HeadPose> running_poses() {
  const auto path = motion::path_of(kMotion);
  std::vector<HeadPose> poses;
  for (std::size_t i = 0; i < kFramesThere; ++i) poses.push_back(path->pose(double(i) / kCrowdRate));
  for (std::size_t i = kFramesThere - 1; i-- > 1;) poses.push_back(poses[i]);
  return poses;
}

HairDesc desc_of(const Asset& asset, const CrowdSettings& settings) {
  const Solver* const ours = settings.character.is_one ? &kCharacterSolver : &kCoifSolver;
  const Solver* const solver = settings.solver == kPublished ? &kThesisSolver : ours;
  return {.instances = settings.heads,
          .solver = solver,
          .instruction_set = settings.instruction_set,
          .longest_interval = settings.detail.interval,
          .links = links_of(asset, *solver),
          .moving_colliders = settings.character.room,
          .follows_poses = settings.character.weight.has_value(),
          .feels_gusts = settings.character.in_gusts};
}

constexpr float kColliderRadius = 0.04f;  // metres
constexpr double kFar = 5;                // metres
constexpr std::size_t kPosedFrames = 60;

/// Places in the hair side by side, or out of its reach.
std::vector<Eigen::Vector3d> collider_places(const Asset& asset, const CrowdCharacter& character) {
  std::vector<Eigen::Vector3d> places;
  if (character.colliders == 0) return places;
  const lab::HairPlace hair = lab::place_of(lab::rig_of(asset));
  const Eigen::Vector3d aside = Eigen::Vector3d::UnitY().cross(hair.outward);
  for (std::uint32_t i = 0; i < character.colliders; ++i) {
    const double off = 1.5 * double(kColliderRadius) * (double(i) - 0.5 * (character.colliders - 1));
    places.push_back(hair.middle + aside * off + hair.outward * (character.are_near ? 0.0 : kFar));
  }
  return places;
}

/// All bones nod a little, once a second.
std::vector<std::vector<Quat>> nodding(std::size_t bones) {
  std::vector<std::vector<Quat>> frames;
  for (std::size_t frame = 0; frame < kPosedFrames; ++frame) {
    const double half = 0.05 * std::sin(2 * std::numbers::pi * double(frame) / kPosedFrames);
    frames.emplace_back(bones, Quat{float(std::sin(half)), 0, 0, float(std::cos(half))});
  }
  return frames;
}

tl::unexpected<ToolError> refused(ToolError::Kind kind, const std::string& why) {
  return tl::unexpected(ToolError{kind, "the hair cannot be simulated: " + why});
}

}  // namespace

std::span<const std::string_view> crowd_solvers() { return kSolvers; }

HairCrowd::HairCrowd(const Asset& asset, const CrowdSettings& settings)
    : settings_(settings),
      poses_(settings.heads_move ? running_poses() : std::vector<HeadPose>(1)),
      collider_places_(collider_places(asset, settings.character)) {
  for (HeadPose& pose : poses_) pose.scale = settings.character.scale;
  if (settings.character.weight) rotations_ = nodding(asset.skeleton().bone_count);
  const bool published = settings.solver == kPublished;
  step_.dt = float(1 / kCrowdRate);
  step_.substeps = settings.substeps;
  if (published) step_.iterations = std::max(settings.substeps, 1u);
  if (!settings.sleeps) step_.sleep_after = std::numeric_limits<float>::infinity();
}

std::uint64_t HairCrowd::memory_bytes(const Asset& asset, const CrowdSettings& settings) {
  return Hair::memory_need(asset, desc_of(asset, settings)).bytes;
}

tl::expected<HairCrowd, ToolError> HairCrowd::create(const Asset& asset, const CrowdSettings& settings) {
  const HairDesc desc = desc_of(asset, settings);
  const MemoryNeed need = Hair::memory_need(asset, desc);
  if (need.bytes == 0) return refused(ToolError::Kind::kUsage, describe(Status::kBadArgument));
  HairCrowd crowd(asset, settings);
  crowd.memory_ = allocate(need);
  if (!crowd.memory_) {
    return refused(ToolError::Kind::kUnsupported, "no memory for " + std::to_string(settings.heads) + " heads");
  }
  const Status created = crowd.hair_.create(asset, desc, {crowd.memory_.get(), need.bytes});
  if (created != Status::kOk) return refused(ToolError::Kind::kBadInput, describe(created));
  Status placed = crowd.place_heads();
  if (placed == Status::kOk && settings.character.in_gusts) placed = crowd.hair_.set_gusts({.amplitude = 1});
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
    if (!collider_places_.empty() && !hand_over_colliders(i, pose)) return false;
    if (rotations_.empty()) continue;
    const auto& rotations = rotations_[(frame_ + i * kFramesApart) % rotations_.size()];
    if (hair_.set_pose(i, rotations, {&*settings_.character.weight, 1}) != Status::kOk) return false;
  }
  return true;
}

bool HairCrowd::hand_over_colliders(std::uint32_t head, const HeadPose& pose) {
  MovingCollider colliders[kMaxMovingColliders];
  const Quat& q = pose.rotation;
  const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
  for (std::size_t k = 0; k < collider_places_.size(); ++k) {
    const Eigen::Vector3d place = turn * (collider_places_[k] * double(pose.scale));
    for (int axis = 0; axis < 3; ++axis) colliders[k].center[axis] = pose.position[axis] + place[axis];
    colliders[k].radius = kColliderRadius;
  }
  return hair_.set_colliders(head, {colliders, collider_places_.size()}) == Status::kOk;
}

bool HairCrowd::step() {
  if (settings_.frame_time_varies) {
    // Steps of an odd length through a cycle of odd length: no two frames that follow each other are alike.
    const double share = double(frame_ * 37 % 101) / 100;
    step_.dt = float((0.9 + 0.2 * share) / kCrowdRate);
  }
  return hand_over_poses() && hair_.step(step_) == Status::kOk;
}

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;  // All crowds together.
constexpr double kLargestShare = 0.25;                        // Share of the time, for one crowd.
constexpr double kLeastRuns = 8;  // Runs of a slow crowd: warming up, and the fewest rounds.

}  // namespace

tl::expected<HairCrowd*, ToolError> CrowdLineUp::take(const Asset& asset, const CrowdSettings& settings) {
  auto crowd = HairCrowd::create(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  bytes_ += HairCrowd::memory_bytes(asset, settings);
  crowds_.push_back(std::make_unique<HairCrowd>(std::move(*crowd)));
  return crowds_.back().get();
}

tl::expected<void, ToolError> CrowdLineUp::add(const Asset& asset, const CrowdSettings& settings) {
  const auto crowd = take(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  // With an interval, a single frame would step all of the hair or none.
  const unsigned frames = settings.detail.interval;
  works_.emplace_back([moved = *crowd, frames] {
    for (unsigned i = 0; i < frames; ++i) (void)moved->step();
  });
  frames_.push_back(frames);
  return {};
}

tl::expected<void, ToolError> CrowdLineUp::add_poses(const Asset& asset, const CrowdSettings& settings) {
  const auto crowd = take(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  works_.emplace_back([posed = *crowd] { (void)posed->hand_over_poses(); });
  frames_.push_back(1);
  return {};
}

std::string CrowdLineUp::objection(const Asset& asset, const CrowdSettings& settings, double seconds_per_head) const {
  const std::uint64_t bytes = HairCrowd::memory_bytes(asset, settings);
  if (bytes > kMostBytes - bytes_)
    return fmt::format("its {:.0f} MB are more memory than is set aside", 1e-6 * double(bytes));
  const double seconds = seconds_per_head * settings.heads;
  if (seconds * kLeastRuns <= kLargestShare * seconds_) return "";
  return fmt::format("one frame takes about {:.0f} ms, too long for the time there is", 1e3 * seconds);
}

std::vector<Timing> CrowdLineUp::time() const {
  auto timings = SideBySideTiming({.clock = TimingClock::kThread, .seconds = seconds_}).run(works_);
  for (std::size_t i = 0; i < timings.size(); ++i) timings[i].seconds /= frames_[i];
  return timings;
}

}  // namespace coif::report
