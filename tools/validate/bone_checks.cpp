#include "validate/asset_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace coif {
namespace {

constexpr float kHardlyAnyLength = 0.001f;  // metres
constexpr float kMuchLonger = 5;            // than the median
constexpr std::size_t kEnoughBones = 4;     // for a median that says something

bool is_simulated(const BoneRecord& bone) { return bone.kind == BoneKind::kSimulated; }

void find_unused_bones(const Asset& asset, Issues& issues) {
  if (asset.skin().empty()) return;
  std::vector<bool> used(asset.bones().size(), false);
  for (const SkinRecord& skin : asset.skin()) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (skin.weight[k] > 0) used[skin.bone[k]] = true;
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] || !is_simulated(asset.bones()[i])) continue;
    issues.push_back(make_issue("A207", "no vertex follows it, though it is simulated", bone_place(asset, i)));
  }
}

void find_stiff_chains(const Asset& asset, Issues& issues) {
  for (const ChainRecord& chain : asset.chains()) {
    if (chain.bone_count != 1) continue;
    issues.push_back(
        make_issue("A211", "its chain has no other bone: the strand cannot bend", bone_place(asset, chain.first_bone)));
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

void find_odd_lengths(const Asset& asset, Issues& issues) {
  const float median = median_length(asset);
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    if (!is_simulated(bone)) continue;
    if (bone.length < kHardlyAnyLength) {
      issues.push_back(
          make_issue("A212", fmt::format("only {:.2g} mm long: it flips", 1000 * bone.length), bone_place(asset, i)));
    } else if (median > 0 && bone.length > kMuchLonger * median) {
      issues.push_back(make_issue(
          "A213", fmt::format("{:.2g} m long, {:.0f} times the bones' median", bone.length, bone.length / median),
          bone_place(asset, i)));
    }
  }
}

}  // namespace

std::string bone_place(const Asset& asset, std::size_t bone) {
  const std::string name = asset.bone_name(std::uint32_t(bone));
  return name.empty() ? fmt::format("bone {}", bone) : fmt::format("bone '{}'", name);
}

void check_bones(const Asset& asset, Issues& issues) {
  if (asset.skeleton().simulated_count == 0) {
    issues.push_back(make_issue("A202", "no simulated bone: the hair is rigid; name the hair's bones in the recipe"));
  }
  find_unused_bones(asset, issues);
  find_stiff_chains(asset, issues);
  find_odd_lengths(asset, issues);
}

}  // namespace coif
