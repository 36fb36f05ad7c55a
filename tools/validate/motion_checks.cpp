#include "animation/recording.h"
#include "base/text.h"
#include "validate/asset_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coif::validate {
namespace {

constexpr float kHardlyAnyLength = 0.001f;  // metres
constexpr float kMuchLonger = 5;            // than the median
constexpr std::size_t kEnoughBones = 4;     // For a meaningful median.

bool is_simulated(const BoneRecord& bone) { return bone.kind == BoneKind::kSimulated; }

void find_unused_bones(const Asset& asset, Diagnostics& issues) {
  if (asset.skin().empty()) return;
  std::vector<bool> used(asset.bones().size(), false);
  for (const SkinRecord& skin : asset.skin()) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (skin.weight[k] > 0) used[skin.bone[k]] = true;
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] || !is_simulated(asset.bones()[i])) continue;
    add_issue(issues, "A207", bone_place(asset, i), "no vertex follows it, though it is simulated");
  }
}

float median_length(const Asset& asset) {
  std::vector<float> lengths;
  for (const BoneRecord& bone : asset.bones()) {
    if (is_simulated(bone)) lengths.push_back(bone.length);
  }
  if (lengths.size() < kEnoughBones) return 0;
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  return *middle;
}

void find_odd_lengths(const Asset& asset, Diagnostics& issues) {
  const float median = median_length(asset);
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    if (!is_simulated(bone)) continue;
    if (bone.length < kHardlyAnyLength) {
      add_issue(issues, "A212", bone_place(asset, i), "only {:.2g} mm long: it flips", 1000 * bone.length);
    } else if (median > 0 && bone.length > kMuchLonger * median) {
      add_issue(issues, "A213", bone_place(asset, i), "{:.2g} m long, {:.0f} times the bones' median", bone.length,
                bone.length / median);
    }
  }
}

}  // namespace

std::string bone_place(const Asset& asset, std::size_t bone) {
  const std::string name = asset.bone_name(std::uint32_t(bone));
  return name.empty() ? fmt::format("bone {}", bone) : fmt::format("bone '{}'", name);
}

void check_bones(const Asset& asset, Diagnostics& issues) {
  if (asset.skeleton().simulated_count == 0) {
    add_issue(issues, "A202", "", "no simulated bone: the hair is rigid; name the hair's bones in the recipe");
  }
  find_unused_bones(asset, issues);
  for (const ChainRecord& chain : asset.chains()) {
    if (chain.bone_count != 1) continue;
    add_issue(issues, "A211", bone_place(asset, chain.first_bone),
              "its chain has no other bone: the strand cannot bend");
  }
  find_odd_lengths(asset, issues);
}

namespace {

constexpr float kRestingDepth = 0.01f;  // Share of the head's radius.
constexpr float kNeverMoves = 0.9999f;
constexpr float kRoundedGap = 1.0e-5f;  // metres, and of the gap

/// Rigid bones have length 0 and rest at their joint.
std::vector<Vec3> resting_particles(const Asset& asset) {
  std::vector<Vec3> particles;
  for (const BoneRecord& bone : asset.bones()) {
    particles.push_back({bone.joint[0] + bone.length * bone.rest_direction[0],
                         bone.joint[1] + bone.length * bone.rest_direction[1],
                         bone.joint[2] + bone.length * bone.rest_direction[2]});
  }
  return particles;
}

void find_resting_penetration(const Asset& asset, Diagnostics& issues) {
  const float depth = animation::worst_penetration(asset, resting_particles(asset));
  if (!(depth > kRestingDepth)) return;
  add_issue(issues, "A205", "",
            "the rest pose is up to {:.0f} % of the head's radius inside the head: the simulation will push it out",
            100 * depth);
}

void find_idle_colliders(const Asset& asset, Diagnostics& issues) {
  std::uint32_t reached = 0;
  for (const BoneRecord& bone : asset.bones()) reached |= bone.colliders;
  for (std::size_t i = 0; i < asset.colliders().size(); ++i) {
    if ((reached >> i & 1u) != 0) continue;
    const std::string where = fmt::format("collider {} on {}", i, bone_place(asset, asset.colliders()[i].bone));
    add_issue(issues, "A221", where, "no bone can ever reach it");
  }
}

void find_idle_body_colliders(const Asset& asset, Diagnostics& issues) {
  std::uint32_t touched = 0;
  for (const std::uint32_t set : asset.body_sets()) touched |= set;
  for (std::uint32_t i = 0; i < asset.body_colliders().size(); ++i) {
    if ((touched >> i & 1u) != 0) continue;
    const std::string bone = clean_text(asset.body_bone_name(asset.body_colliders()[i].bone));
    add_issue(issues, "A221", fmt::format("body collider {} on '{}'", i, bone), "no bone may touch it");
  }
}

void find_odd_pulls(const Asset& asset, Diagnostics& issues) {
  for (std::size_t i = 0; i < asset.dynamics().size(); ++i) {
    if (!is_simulated(asset.bones()[i])) continue;
    const DynamicsRecord& bone = asset.dynamics()[i];
    if (bone.resistance <= 0 && bone.stiffness <= 0) {
      add_issue(issues, "A222", bone_place(asset, i), "nothing pulls it to the modelled pose");
    } else if (bone.resistance >= kNeverMoves) {
      add_issue(issues, "A223", bone_place(asset, i), "its resistance of 1 keeps it from ever moving");
    }
  }
}

void find_strained_links(const Asset& asset, Diagnostics& issues) {
  const std::vector<Vec3> particles = resting_particles(asset);
  for (const LinkRecord& link : asset.links()) {
    const Vec3 one = particles[link.bone], other = particles[link.to];
    const float gap = std::hypot(one.x - other.x, one.y - other.y, one.z - other.z);
    const float rounding = kRoundedGap * (1 + gap);
    if (gap >= link.shortest - rounding && gap <= link.longest + rounding) continue;
    add_issue(issues, "A224", bone_place(asset, link.bone),
              "modelled {:.4g} mm from {}, and its link keeps it {:.4g} to {:.4g} mm away", 1000 * gap,
              bone_place(asset, link.to), 1000 * link.shortest, 1000 * link.longest);
  }
}

}  // namespace

void check_dynamics(const Asset& asset, Diagnostics& issues) {
  if (asset.skeleton().simulated_count == 0) return;
  if (asset.colliders().empty()) add_issue(issues, "A203", "", "no collider: hair will pass through the head");
  find_resting_penetration(asset, issues);
  find_idle_colliders(asset, issues);
  find_idle_body_colliders(asset, issues);
  find_odd_pulls(asset, issues);
  find_strained_links(asset, issues);
}

namespace {

using Eigen::Vector3f;

constexpr int kMostWeight = 128;  // In steps of 255.
constexpr float kFarAway = 0.6f;  // Share of the hair's size.

bool moves(const Asset& asset, const SkinRecord& skin) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (skin.weight[k] > 0 && is_simulated(asset.bones()[skin.bone[k]])) return true;
  }
  return false;
}

/// The simulated bone with most of the vertex's weight; null where there is none.
const BoneRecord* mover_of(const Asset& asset, const SkinRecord& skin) {
  for (std::size_t k = 0; k < 4; ++k) {
    const BoneRecord& bone = asset.bones()[skin.bone[k]];
    if (skin.weight[k] >= kMostWeight && is_simulated(bone)) return &bone;
  }
  return nullptr;
}

/// Distance of a place from the bone's segment at rest, metres. Rest directions are in the parent's frame, which at
/// rest has the axes of head space.
float distance(const Vector3f& at, const BoneRecord& bone) {
  const Vector3f from = at - Vector3f(bone.joint);
  const Vector3f direction(bone.rest_direction);
  return (from - direction * std::clamp(from.dot(direction), 0.0f, bone.length)).norm();
}

void find_strays(const Asset& asset, Diagnostics& issues) {
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(Vector3f(vertex.position));
  const float far_away = kFarAway * cook::largest_side(box);
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchRecord& patch = asset.patches()[i];
    for (const std::uint32_t vertex : asset.indices().subspan(patch.first_index, patch.index_count)) {
      const BoneRecord* bone = mover_of(asset, asset.skin()[vertex]);
      if (bone == nullptr) continue;
      const float off = distance(Vector3f(asset.vertices()[vertex].position), *bone);
      if (off <= far_away) continue;
      const std::string mover = bone_place(asset, std::size_t(bone - asset.bones().data()));
      add_patch_issue(issues, "A262", i, "a vertex follows {}, {:.2g} m away", mover, off);
      break;
    }
  }
}

}  // namespace

void check_skin(const Asset& asset, Diagnostics& issues) {
  if (asset.vertices().empty() || asset.skeleton().simulated_count == 0) return;
  if (std::ranges::none_of(asset.skin(), [&](const SkinRecord& skin) { return moves(asset, skin); })) {
    return add_issue(issues, "A261", "", "no vertex follows a simulated bone: what is drawn does not move");
  }
  find_strays(asset, issues);
}

namespace {

constexpr float kLargeError = 0.03f;  // Share of the chain's length, RMS.
constexpr float kDeep = 0.05f;        // Share of the collider's radius.
constexpr float kStretched = 0.01f;
constexpr float kRounding = 1.001f;

/// The rows that a game following `tuning` runs.
bool is_chosen(const QualityRecord& row, const TuningRecord& tuning) {
  if (row.frame_rate < tuning.slowest_rate || row.frame_rate > tuning.fastest_rate) return false;
  return float(row.substeps) == std::max(1.0f, std::ceil(tuning.substep_rate / row.frame_rate));
}

/// The worst of the rows that are used; the values in `tuning` itself if there are none.
QualityRecord worst_of(const Asset& asset, const TuningRecord& tuning) {
  QualityRecord worst{};
  worst.rms_error = tuning.reached_error;
  worst.cost = tuning.cost;
  for (const QualityRecord& row : asset.quality()) {
    if (!is_chosen(row, tuning)) continue;
    worst.rms_error = std::max(worst.rms_error, row.rms_error);
    worst.cost = std::max(worst.cost, row.cost);
    worst.penetration = std::max(worst.penetration, row.penetration);
    worst.stretch = std::max(worst.stretch, row.stretch);
  }
  return worst;
}

void check_budget(const TuningRecord& tuning, const QualityRecord& worst, Diagnostics& issues) {
  if (tuning.asked_error > 0 && worst.rms_error > kRounding * tuning.asked_error) {
    add_issue(issues, "A281", "chunk QUAL", "an error of {:.2g} % of the chain's length, where {:.2g} % was the budget",
              100 * worst.rms_error, 100 * tuning.asked_error);
  }
  if (tuning.asked_cost > 0 && worst.cost > kRounding * tuning.asked_cost) {
    add_issue(issues, "A281", "chunk QUAL", "{:.0f} ns for a head and frame, where {:.0f} ns was the budget",
              worst.cost, tuning.asked_cost);
  }
}

void add_share(const char* code, const char* text, float share, float limit, Diagnostics& issues) {
  if (share > limit) add_issue(issues, code, "chunk QUAL", "{} {:.2g} %", text, 100 * share);
}

}  // namespace

void check_origin(const Asset& asset, Diagnostics& issues) {
  if (is_draft(asset)) add_issue(issues, "A291", "chunk PROV", "a draft: cooked with --draft, to look at");
}

void check_quality(const Asset& asset, Diagnostics& issues) {
  if (asset.dynamics().empty() || asset.skeleton().simulated_count == 0) return;
  if (asset.tuning() == nullptr) {
    if (is_draft(asset)) return;  // A291 reports it.
    return add_issue(issues, "A283", "", "not tuned: the number of sub-steps is left to the game");
  }
  const QualityRecord worst = worst_of(asset, *asset.tuning());
  check_budget(*asset.tuning(), worst, issues);
  add_share("A282", "tips are off the exact motion by", worst.rms_error, kLargeError, issues);
  add_share("A284", "tips get into a collider by", worst.penetration, kDeep, issues);
  add_share("A285", "bones are longer than at rest by", worst.stretch, kStretched, issues);
}

}  // namespace coif::validate
