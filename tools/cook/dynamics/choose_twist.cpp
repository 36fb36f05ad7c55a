#include "base/parallel_for.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/dynamics/settle_dynamics.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "motion/head_path.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::cook {
namespace {

constexpr double kWatchedSeconds = 2;
constexpr std::uint32_t kWatchedRate = 60, kWatchedSubsteps = 2;
/// Radians. Games move heads in other ways than the suite does: 60 degrees are left until the arc flips, and at 120 it
/// turns about the bone no faster than sqrt(3) times as fast as the bone swings.
constexpr double kMostFold = 2 * std::numbers::pi / 3;
constexpr std::size_t kMostNames = 4;  ///< Most names in a note.

/// Whether the bone may bend that far from its parent's default direction. The limit is measured from the direction
/// that parent and head share, and colliders push after it.
bool may_fold(const BoneRecord& bone, const DynamicsRecord& dynamics) {
  const bool is_held = dynamics.parent_share == 1 && bone.colliders == 0;
  return !is_held || double(dynamics.angle_limit) > kMostFold;
}

bool may_fold(const AssetContents& contents, const ChainRecord& chain) {
  if (chain.model == ChainModel::kPassive) return false;
  for (std::uint32_t b = chain.first_bone; b < chain.first_bone + chain.bone_count; ++b) {
    if (may_fold(contents.bones[b], contents.dynamics[b])) return true;
  }
  return false;
}

/// Cosine of the angle between where a bone points and where it would by its parent alone; both frames are rotations
/// from rest.
double cosine_of_fold(const BoneRecord& bone, const Mat34& own, const Mat34& parent) {
  double cosine = 0;
  for (int row = 0; row < 3; ++row) {
    double here = 0, there = 0;
    for (int k = 0; k < 3; ++k) {
      here += double(own.m[row][k]) * double(bone.rest_direction[k]);
      there += double(parent.m[row][k]) * double(bone.rest_direction[k]);
    }
    cosine += here * there;
  }
  return cosine;
}

/// Per chain, the largest angle at the end of any frame of one motion, radians; infinite where the runtime fails.
std::vector<double> folds_during(const AssetContents& contents, const Asset& asset, motion::Motion motion) {
  std::vector<double> least(contents.chains.size(), 1);
  const auto path = motion::path_of(motion);
  lab::RuntimeSolver solver(asset, {}, kCoifSolver, int(kWatchedSubsteps));
  solver.reset(path->pose(0));
  for (std::uint32_t frame = 1; frame <= kWatchedSeconds * kWatchedRate; ++frame) {
    if (!solver.step(path->pose(double(frame) / kWatchedRate), 1.0 / kWatchedRate))
      return std::vector<double>(least.size(), INFINITY);
    const std::span<const Mat34> palette = solver.palette();
    for (std::uint32_t b = 0; b < contents.bones.size(); ++b) {
      const BoneRecord& bone = contents.bones[b];
      if (bone.kind != BoneKind::kSimulated) continue;
      least[bone.chain] = std::min(least[bone.chain], cosine_of_fold(bone, palette[b], palette[bone.parent]));
    }
  }
  for (double& cosine : least) cosine = std::acos(std::clamp(cosine, -1.0, 1.0));
  return least;
}

/// Per chain, over the whole suite; 0 where none can bend that far.
std::vector<double> largest_folds(const AssetContents& contents, const platform::Threads& threads) {
  std::vector<double> largest(contents.chains.size(), 0);
  const auto may = [&](const ChainRecord& chain) { return may_fold(contents, chain); };
  if (std::ranges::none_of(contents.chains, may)) return largest;
  const lab::OpenedAsset opened(contents);
  std::vector<std::vector<double>> during(std::size(kCookSuite));
  parallel_for(during.size(), threads,
               [&](std::size_t m) { during[m] = folds_during(contents, opened.asset(), kCookSuite[m]); });
  for (std::size_t c = 0; c < largest.size(); ++c) {
    if (!may(contents.chains[c])) continue;
    for (const std::vector<double>& folds : during) largest[c] = std::max(largest[c], folds[c]);
  }
  return largest;
}

/// Bytes of the runtime's memory per head of a large crowd.
std::uint64_t bytes_per_head(const AssetContents& contents) {
  const lab::OpenedAsset opened(contents);
  HairDesc desc;
  desc.instances = 1024;
  return Hair::memory_need(opened.asset(), desc).bytes / desc.instances;
}

std::string kept_text(const AssetContents& contents, std::span<const std::uint32_t> kept, double largest) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kept.size(), kMostNames); ++i) names.push_back(chain_name(contents, kept[i]));
  if (kept.size() > kMostNames) names.push_back(fmt::format("{} more", kept.size() - kMostNames));
  return fmt::format("twist: carried in chain{} {}, where bones bend by up to {:.0f} degrees from their parents",
                     kept.size() == 1 ? "" : "s", fmt::join(names, ", "), largest * 180 / std::numbers::pi);
}

LeftOut twist_left_out(const AssetContents& before, const AssetContents& after, std::size_t chains, std::size_t bones) {
  LeftOut twist;
  twist.what = fmt::format("twist of {} bones in {} of {} chains", bones, chains, before.chains.size());
  twist.why =
      fmt::format("no motion bends them by {:.0f} degrees from their parents", kMostFold * 180 / std::numbers::pi);
  const std::uint64_t with = bytes_per_head(before), without = bytes_per_head(after);
  twist.bytes_per_head = with > without ? with - without : 0;
  twist.ns_per_frame = nominal_twist_cost(bones, 1);
  return twist;
}

}  // namespace

std::vector<DynamicsRecord> choose_twist(const AssetContents& contents, const platform::Threads& threads,
                                         Findings& findings) {
  const std::vector<double> folds = largest_folds(contents, threads);
  AssetContents chosen = contents;
  std::vector<std::uint32_t> kept;
  double largest = 0;
  std::size_t bones = 0, without = 0;
  for (std::uint32_t c = 0; c < contents.chains.size(); ++c) {
    if (!(folds[c] < kMostFold)) {
      kept.push_back(c);
      largest = std::max(largest, folds[c]);
      continue;
    }
    const ChainRecord& chain = contents.chains[c];
    if (chain.model == ChainModel::kPassive) continue;
    ++without;
    bones += chain.bone_count;
    for (std::uint32_t i = 0; i < chain.bone_count; ++i) chosen.dynamics[chain.first_bone + i].torsion = kShortestArc;
  }
  if (!kept.empty()) findings.note(kept_text(contents, kept, largest));
  if (bones > 0) findings.leave_out(twist_left_out(contents, chosen, without, bones));
  return std::move(chosen.dynamics);
}

}  // namespace coif::cook
