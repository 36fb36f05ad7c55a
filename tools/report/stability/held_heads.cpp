#include "report/stability/held_heads.h"

#include "base/hair_runtime.h"
#include "lab/rig.h"
#include "motion/head_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kAttitudes = 26;

/// A head in each attitude, and where its bones ended after the last frame.
class HeldCrowd {
 public:
  HeldCrowd(const Asset& asset, const HeldHeads& held) : heads_(motion::held_attitudes()) {
    const HairDesc desc{.instances = kAttitudes, .links = links_of(asset, kCoifSolver)};
    const MemoryNeed need = Hair::memory_need(asset, desc);
    memory_ = allocate(need);
    if (!memory_) throw std::bad_alloc();
    (void)hair_.create(asset, desc, {memory_.get(), need.bytes});
    settings_.dt = float(1 / held.frame_rate);
    settings_.substeps = held.substeps;
    settings_.sleep_after = std::numeric_limits<float>::infinity();
    settings_.dynamics = {held.stiffness, held.damping, held.friction};
    ends_.resize(hair_.bone_count());
    for (std::uint32_t i = 0; i < kAttitudes; ++i) {
      (void)hair_.reset(i, heads_[i].path->pose(0));
      before_.emplace_back(hair_.bone_count());
      (void)hair_.bone_ends(i, before_.back());
    }
  }

  void step(double seconds) {
    for (std::uint32_t i = 0; i < kAttitudes; ++i) (void)hair_.set_head(i, heads_[i].path->pose(seconds));
    (void)hair_.step(settings_);
  }

  /// m/s, against the head, in the last frame; infinite where a number is not finite.
  double speed(std::uint32_t head) {
    (void)hair_.bone_ends(head, ends_);
    double fastest = 0;
    for (std::size_t b = 0; b < ends_.size(); ++b) {
      const Vec3 way{ends_[b].x - before_[head][b].x, ends_[b].y - before_[head][b].y, ends_[b].z - before_[head][b].z};
      const double speed =
          std::sqrt(double(way.x) * way.x + double(way.y) * way.y + double(way.z) * way.z) / settings_.dt;
      fastest = std::isfinite(speed) ? std::max(fastest, speed) : std::numeric_limits<double>::infinity();
    }
    before_[head] = ends_;
    return fastest;
  }

  [[nodiscard]] const Vector3d& up(std::uint32_t head) const { return heads_[head].up; }

 private:
  std::vector<motion::HeldAttitude> heads_;
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  StepSettings settings_;
  std::vector<Vec3> ends_;
  std::vector<std::vector<Vec3>> before_;
};

HeldHeadsFinding watch(const Asset& asset, const HeldHeads& held) {
  HeldCrowd crowd(asset, held);
  HeldHeadsFinding finding;
  const auto frames = std::int64_t(std::ceil(held.seconds * held.frame_rate));
  for (std::int64_t frame = 1; frame <= frames && finding.is_finite; ++frame) {
    const double now = double(frame) / held.frame_rate;
    crowd.step(now);
    for (std::uint32_t head = 0; head < kAttitudes; ++head) {
      const double speed = crowd.speed(head);
      finding.is_finite = finding.is_finite && std::isfinite(speed);
      finding.max_speed = std::max(finding.max_speed, speed);
      if (speed > kAtRest) finding.settled_after = now;
      if (now <= kSettlingTime || speed <= finding.rest_speed) continue;
      finding.rest_speed = speed;
      for (int k = 0; k < 3; ++k) finding.up[k] = int(crowd.up(head)[k]);
    }
  }
  return finding;
}

}  // namespace

HeldHeadsFinding hold_heads(const Asset& asset, const HeldHeads& held) {
  HeldHeads asked = held;
  // A part of the asset does not have the asset's tuning.
  if (held.substeps == 0) asked.substeps = tuned_substeps(asset, float(1 / held.frame_rate));
  if (held.collides) return watch(asset, asked);
  const lab::OpenedAsset bare(lab::untouched_part(asset));
  return watch(bare.asset(), asked);
}

std::string name_of(const HeldHeads& held) {
  const std::string parts =
      held.substeps == 0 ? "tuned" : fmt::format("{} part{}", held.substeps, held.substeps == 1 ? "" : "s");
  return fmt::format("held, {} at {:g} fps{}", parts, held.frame_rate, held.collides ? "" : ", no colliders");
}

std::vector<HeldHeads> ways_to_hold(const Asset& asset, std::uint64_t most_bone_steps) {
  std::vector<HeldHeads> ways;
  std::uint64_t left = most_bone_steps;
  for (const std::uint32_t substeps : {0u, 1u, 2u, 4u, 8u}) {
    for (const double rate : {60.0, 30.0, 144.0}) {
      for (const bool collides : {true, false}) {
        if (collides && asset.colliders().empty()) continue;
        const HeldHeads way{.substeps = substeps, .frame_rate = rate, .collides = collides};
        const std::uint32_t parts = substeps == 0 ? tuned_substeps(asset, float(1 / rate)) : substeps;
        const auto steps = std::uint64_t(way.seconds * rate) * parts * kAttitudes * asset.skeleton().simulated_count;
        if (steps > left) return ways;
        left -= steps;
        ways.push_back(way);
      }
    }
  }
  return ways;
}

}  // namespace coif::report
