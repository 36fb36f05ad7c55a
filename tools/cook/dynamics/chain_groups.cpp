#include "cook/dynamics/chain_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

namespace coif::cook {
namespace {

constexpr double kEarthGravity = 9.81;  // m/s^2: a hanging bone is stiffened as a pendulum

double softness(const AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  double sum = 0;
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    sum += 1 / std::sqrt(contents.dynamics[b].stiffness + kEarthGravity / contents.bones[b].length);
  }
  return sum;
}

double total_length(const AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  double sum = 0;
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    sum += contents.bones[b].length;
  }
  return sum;
}

}  // namespace

std::vector<ChainGroup> group_chains(const AssetContents& contents) {
  std::map<std::pair<ChainModel, std::uint32_t>, ChainGroup> by_shape;
  for (std::uint32_t c = 0; c < contents.chains.size(); ++c) {
    by_shape[{contents.chains[c].model, contents.chains[c].bone_count}].chains.push_back(c);
  }
  std::vector<ChainGroup> groups;
  for (auto& [shape, group] : by_shape) {
    const auto by = [&](auto measure) {
      return *std::ranges::max_element(group.chains, {}, [&](std::uint32_t c) { return measure(contents, c); });
    };
    group.telling = {by(softness), by(total_length)};
    if (group.telling[0] == group.telling[1]) group.telling.pop_back();
    groups.push_back(std::move(group));
  }
  return groups;
}

namespace {

/// The larger root of z^2 - (1 + a) T z + a T = 0.
double larger_root(std::complex<double> follow, double share) {
  const std::complex<double> half = 0.5 * (1 + share) * follow;
  const std::complex<double> spread = std::sqrt(half * half - share * follow);
  return std::max(std::abs(half + spread), std::abs(half - spread));
}

double bone_growth(const DynamicsRecord& dynamics, double length) {
  const double stiffness = dynamics.stiffness + kEarthGravity * std::abs(dynamics.gravity_scale) / length;
  const double natural = std::sqrt(stiffness);
  double worst = 1;
  for (double octave = -4; octave <= 4; octave += 0.25) {
    const std::complex<double> s(0, natural * std::exp2(octave));
    const double damping = dynamics.damping, friction = dynamics.friction;
    const auto follow = (damping * s + stiffness) / (s * s + (damping + friction) * s + stiffness);
    worst = std::max(worst, larger_root(follow, dynamics.parent_share));
  }
  return worst;
}

}  // namespace

double chain_growth(const AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  // A tree grows along each of its branches alone.
  std::vector<double> growth(contents.bones.size(), 1);
  double worst = 1;
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    const BoneRecord& bone = contents.bones[b];
    growth[b] = growth[bone.parent] * bone_growth(contents.dynamics[b], bone.length);
    worst = std::max(worst, growth[b]);
  }
  return worst;
}

std::string chain_name(const AssetContents& contents, std::uint32_t chain) {
  const std::uint32_t bone = contents.chains[chain].first_bone;
  const bool named = bone < contents.bone_names.size() && !contents.bone_names[bone].empty();
  return named ? fmt::format("'{}'", contents.bone_names[bone]) : fmt::format("{}", chain);
}

std::string names_of(const AssetContents& contents, const ChainGroup& group, std::uint32_t chain) {
  const std::string first = fmt::format("chain {}", chain_name(contents, chain));
  return group.chains.size() == 1 ? first : fmt::format("{} and {} like it", first, group.chains.size() - 1);
}

namespace {

/// Copies one bone and records its new place for its children.
void keep_bone(const AssetContents& from, std::uint32_t bone, std::uint32_t chain, std::vector<std::uint32_t>& moved_to,
               AssetContents& to) {
  BoneRecord record = from.bones[bone];
  if (record.parent != kNone) record.parent = moved_to[record.parent];
  record.chain = chain;
  record.name = kNone;
  moved_to[bone] = std::uint32_t(to.bones.size());
  to.bones.push_back(record);
  to.dynamics.push_back(from.dynamics[bone]);
  if (!from.limits.empty()) to.limits.push_back(from.limits[bone]);
}

}  // namespace

AssetContents chains_alone(const AssetContents& contents, std::span<const std::uint32_t> chains) {
  AssetContents part;
  part.skeleton = contents.skeleton;
  part.colliders = contents.colliders;
  std::vector<std::uint32_t> moved_to(contents.bones.size(), kNone);
  for (std::uint32_t b = 0; b < contents.bones.size(); ++b) {
    if (contents.bones[b].kind != BoneKind::kSimulated) keep_bone(contents, b, kNone, moved_to, part);
  }
  for (const std::uint32_t chain : chains) {
    ChainRecord record = contents.chains[chain];
    const std::uint32_t first = record.first_bone, end = first + record.bone_count;
    record.first_bone = std::uint32_t(part.bones.size());
    record.root = moved_to[record.root];
    for (std::uint32_t b = first; b < end; ++b) {
      keep_bone(contents, b, std::uint32_t(part.chains.size()), moved_to, part);
    }
    part.chains.push_back(record);
  }
  return part;
}

}  // namespace coif::cook
