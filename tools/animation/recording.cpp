#include "animation/recording.h"

#include "base/collider_shapes.h"
#include "base/geometry.h"
#include "base/hair_runtime.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string_view>

namespace coif::animation {
namespace {

constexpr double kMaxFps = 1000;
constexpr double kMaxSeconds = 3600;
constexpr double kMaxRecordingBytes = 1024.0 * 1024.0 * 1024.0;

tl::unexpected<ToolError> refused(Status status) {
  return failure(ToolError::Kind::kBadInput, fmt::format("the runtime refuses this simulation: {}", describe(status)));
}

bool fit(const FrameLengths& lengths) {
  const auto is_length = [](double s) { return s >= kShortestFrame && s <= kLongestFrame; };
  return std::ranges::all_of(lengths.seconds, is_length) && lengths.jitter >= 0 && lengths.jitter <= kMostJitter;
}

// Written so that a NaN fails every check.
tl::expected<void, ToolError> check(const Asset& asset, const RecordingSettings& settings) {
  // dt is rounded to float; 1 / 0.1f is a little below 10, so exactly 10 frames per second must pass.
  if (!(settings.fps > 0 && static_cast<float>(1.0 / settings.fps) <= kMaxTimeStep && settings.fps <= kMaxFps)) {
    return usage(fmt::format("{} frames per second are outside {} .. {}", settings.fps,
                             std::lround(1.0f / kMaxTimeStep), kMaxFps));
  }
  if (!(settings.seconds >= 0 && settings.seconds <= kMaxSeconds)) {
    return usage(fmt::format("{} seconds are outside 0 .. {}", settings.seconds, kMaxSeconds));
  }
  if (!(settings.settle_seconds >= 0 && settings.settle_seconds <= kMaxSeconds)) {
    return usage(fmt::format("{} seconds to settle are outside 0 .. {}", settings.settle_seconds, kMaxSeconds));
  }
  if (const float scale = settings.company.scale; !(scale >= kSmallestScale && scale <= kLargestScale)) {
    return usage(fmt::format("{} is not the scale of a head, {} .. {}", scale, kSmallestScale, kLargestScale));
  }
  if (!fit(settings.lengths)) {
    return usage(fmt::format("frames take {} .. {} seconds each, and their lengths change by up to 0 .. {}",
                             kShortestFrame, kLongestFrame, kMostJitter));
  }
  const std::size_t frames = frame_ends(settings).size();
  const double frame_bytes = static_cast<double>(asset.bones().size()) * double(sizeof(Mat34) + sizeof(Vec3));
  if (frame_bytes * static_cast<double>(frames) > kMaxRecordingBytes) {
    return usage(
        fmt::format("{} frames of {} bones need more than 1 GiB; record fewer seconds", frames, asset.bones().size()));
  }
  return {};
}

RecordedFrame snapshot(const Hair& hair, const HeadPose& head, double seconds) {
  const auto palette = hair.palette(0);
  std::vector<Vec3> ends(hair.bone_count());
  (void)hair.bone_ends(0, ends);
  return {seconds, head, {palette.begin(), palette.end()}, std::move(ends)};
}

Status settle(Hair& hair, const RecordingSettings& settings, const StepSettings& step) {
  const auto steps = std::llround(settings.settle_seconds * settings.fps);
  if (const Status status = settings.company.tell(hair, 0); status != Status::kOk) return status;
  for (long long i = 0; i < steps; ++i) {
    if (const Status status = hair.step(step); status != Status::kOk) return status;
  }
  return Status::kOk;
}

/// Metres between the bone ends of two frames: the largest.
float farthest(const RecordedFrame& a, const RecordedFrame& b) {
  float most = 0;
  for (std::size_t i = 0; i < a.bone_ends.size(); ++i) {
    most = std::max(most, (to_eigen(a.bone_ends[i]) - to_eigen(b.bone_ends[i])).norm());
  }
  return most;
}

/// Metres from where a chain leaves the head to its farthest tip, along the bones.
float longest_chain(const Asset& asset) {
  std::vector<float> reach(asset.bones().size());
  float most = 0;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    if (bone.kind != BoneKind::kSimulated) continue;
    reach[i] = bone.length + reach[bone.parent];
    most = std::max(most, reach[i]);
  }
  return most;
}

float fastest_in_last_second(const Recording& recording) {
  float most = 0;
  const std::vector<RecordedFrame>& frames = recording.frames;
  for (std::size_t i = frames.size(); i-- > 1;) {
    if (frames[i].seconds <= frames.back().seconds - 1) break;
    most = std::max(most, farthest(frames[i], frames[i - 1]) / float(frames[i].seconds - frames[i - 1].seconds));
  }
  return most;
}

Status advance(Hair& hair, const HeadPose& pose, const StepSettings& step) {
  if (const Status status = hair.set_head(0, pose); status != Status::kOk) return status;
  return hair.step(step);
}

}  // namespace

tl::expected<Recording, ToolError> record(const Asset& asset, const RecordingSettings& settings) {
  if (auto checked = check(asset, settings); !checked) return tl::unexpected(checked.error());

  const HairDesc desc = settings.company.description(asset, settings.solver);
  const MemoryNeed need = Hair::memory_need(asset, desc);
  const HairMemory memory = allocate(need);
  if (!memory) return failure(ToolError::Kind::kInternal, "out of memory");
  Hair hair;
  if (const Status status = hair.create(asset, desc, {memory.get(), need.bytes}); status != Status::kOk) {
    return refused(status);
  }
  StepSettings step = settings.step;
  step.dt = static_cast<float>(1.0 / settings.fps);
  const std::shared_ptr<const motion::HeadPath> path = settings.clip ? settings.clip : motion::path_of(settings.motion);
  const auto pose_at = [&](double seconds) {
    HeadPose pose = path->pose(seconds);
    pose.scale = settings.company.scale;
    return pose;
  };
  if (const Status status = hair.reset(0, pose_at(0)); status != Status::kOk) return refused(status);
  const RecordedFrame rest = snapshot(hair, pose_at(0), 0);
  if (const Status status = settle(hair, settings, step); status != Status::kOk) return refused(status);

  Recording recording;
  recording.frames.push_back(snapshot(hair, pose_at(0), 0));
  const std::vector<double> ends = frame_ends(settings);
  recording.frames.reserve(ends.size());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double seconds = ends[i];
    const HeadPose pose = pose_at(seconds);
    if (!settings.lengths.is_even()) step.dt = static_cast<float>(seconds - ends[i - 1]);
    if (const Status status = settings.company.tell(hair, seconds); status != Status::kOk) return refused(status);
    if (const Status status = advance(hair, pose, step); status != Status::kOk) return refused(status);
    recording.frames.push_back(snapshot(hair, pose, seconds));
  }
  for (const RecordedFrame& frame : recording.frames) {
    recording.stretch_max = std::max(recording.stretch_max, worst_stretch(asset, frame.bone_ends));
    recording.penetration_max = std::max(recording.penetration_max, worst_penetration(asset, frame.bone_ends));
  }
  recording.from_rest = farthest(recording.frames.back(), rest) / std::max(longest_chain(asset), 1e-6f);
  recording.last_speed = fastest_in_last_second(recording);
  return recording;
}

std::vector<double> frame_ends(const RecordingSettings& settings) {
  std::vector<double> ends = {0};
  const FrameLengths& lengths = settings.lengths;
  if (lengths.is_even()) {
    const auto steps = std::llround(settings.seconds * settings.fps);
    for (long long i = 1; i <= steps; ++i) ends.push_back(static_cast<double>(i) / settings.fps);
    return ends;
  }
  std::mt19937 lot(lengths.seed);  // Its numbers are the same everywhere.
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0;; ++i) {
    const double usual = lengths.seconds.empty() ? 1 / settings.fps : lengths.seconds[i % lengths.seconds.size()];
    const double end = ends.back() + usual * (1 + lengths.jitter * (2 * double(lot()) / double(lot.max()) - 1));
    if (end > settings.seconds + kRounding) return ends;
    ends.push_back(end);
  }
}

namespace {

/// The start of a bone. Under a rigid bone that is its own joint, which may differ from its parent's.
Eigen::Vector3f start_of(const Asset& asset, const BoneRecord& bone, std::span<const Vec3> bone_ends) {
  if (asset.bones()[bone.parent].kind == BoneKind::kSimulated) return to_eigen(bone_ends[bone.parent]);
  return Eigen::Map<const Eigen::Vector3f>(bone.joint);
}

}  // namespace

float worst_stretch(const Asset& asset, std::span<const Vec3> bone_ends) {
  float worst = 0;
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    if (bone.kind != BoneKind::kSimulated) continue;
    const float length = (to_eigen(bone_ends[i]) - start_of(asset, bone, bone_ends)).norm();
    worst = std::max(worst, std::abs(length / bone.length - 1.0f));
  }
  return worst;
}

float worst_penetration(const Asset& asset, std::span<const Vec3> bone_ends) {
  float worst = 0;
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    for (std::size_t k = 0; k < asset.colliders().size(); ++k) {
      if ((asset.bones()[i].colliders >> k & 1) == 0) continue;
      worst = std::max(worst, share_inside(asset.colliders()[k], to_eigen(bone_ends[i])));
    }
  }
  return worst;
}

namespace {

// RFC 4180: a field with a comma, a quote or a line end is quoted, quotes inside are doubled.
std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

Eigen::Vector3d to_world(const HeadPose& head, const Vec3& point) {
  const Quat& q = head.rotation;
  const Eigen::Quaterniond rotation(double(q.w), double(q.x), double(q.y), double(q.z));
  return rotation * (to_eigen(point).cast<double>() * double(head.scale)) +
         Eigen::Map<const Eigen::Vector3d>(head.position);
}

}  // namespace

std::string to_csv(const Asset& asset, const Recording& recording) {
  std::vector<std::string> names;
  for (std::uint32_t bone = 0; bone < asset.bones().size(); ++bone) names.push_back(csv_field(asset.bone_name(bone)));

  std::string text = "frame,seconds,bone,name,x,y,z,world_x,world_y,world_z\n";
  auto out = std::back_inserter(text);
  for (std::size_t f = 0; f < recording.frames.size(); ++f) {
    const RecordedFrame& frame = recording.frames[f];
    for (std::size_t bone = 0; bone < frame.bone_ends.size(); ++bone) {
      const Vec3& p = frame.bone_ends[bone];
      const Eigen::Vector3d world = to_world(frame.head, p);
      fmt::format_to(out, "{},{:.6f},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", f, frame.seconds, bone,
                     names[bone], p.x, p.y, p.z, world.x(), world.y(), world.z());
    }
  }
  return text;
}

}  // namespace coif::animation
