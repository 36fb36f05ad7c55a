#include "report/crowd_features.h"

#include <coif/instruction_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace coif {
namespace {

bool touches_colliders(const Asset& asset) {
  return std::ranges::any_of(asset.bones(), [](const BoneRecord& bone) { return bone.colliders != 0; });
}

void add_levels(const Asset& asset, const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  for (std::uint32_t level = 1; level < asset.lods().size() && !asset.lod_bones().empty(); ++level) {
    CrowdSettings settings = usual;
    settings.detail.level = level;
    const auto bones = std::ranges::count_if(asset.lod_bones(), [level](auto levels) { return levels > level; });
    features.push_back({fmt::format("level-{}", level),
                        fmt::format("level of detail {}: {} of {} bones are simulated", level, bones,
                                    asset.skeleton().simulated_count),
                        settings});
  }
}

void add_intervals(const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  for (const std::uint32_t interval : {2u, 4u}) {
    CrowdSettings settings = usual;
    settings.detail.interval = interval;
    settings.substeps = 0;  // a number of them would be meant for each frame, and nothing be saved
    features.push_back(
        {fmt::format("every-{}{}-frame", interval, interval == 2 ? "nd" : "th"),
         "each head is stepped that often, in turns, with the sub-steps that the asset asks for such a step",
         settings});
  }
}

/// What costs next to nothing, and what would be paid for it otherwise.
void add_rest(const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  CrowdSettings unseen = usual, asleep = usual, awake = usual;
  unseen.detail.simulated = false;
  asleep.heads_move = awake.heads_move = false;
  awake.sleeps = false;
  features.push_back({"unseen", "no head is seen, and none simulated", unseen});
  features.push_back({"asleep", "no head moves, and all hair has fallen asleep", asleep});
  features.push_back({"still-awake", "no head moves, and hair may not fall asleep", awake});
}

void add_instruction_sets(const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  constexpr InstructionSet kAll[] = {InstructionSet::kScalar, InstructionSet::kPortable, InstructionSet::kSse4,
                                     InstructionSet::kAvx2,   InstructionSet::kAvx512,   InstructionSet::kNeon,
                                     InstructionSet::kWasm};
  for (const InstructionSet set : kAll) {
    if (!can_run(set) || set == best_instruction_set()) continue;
    CrowdSettings settings = usual;
    settings.instruction_set = set;
    std::string name;
    std::ranges::transform(std::string_view(coif::name_of(set)), std::back_inserter(name),
                           [](unsigned char letter) { return char(std::tolower(letter)); });
    features.push_back(
        {name, fmt::format("run with {} instead of {}", coif::name_of(set), coif::name_of(best_instruction_set())),
         settings});
  }
}

}  // namespace

std::vector<CrowdFeature> crowd_features(const Asset& asset, const CrowdSettings& usual) {
  std::vector<CrowdFeature> features{{"as-cooked", "all heads run", usual}};
  if (touches_colliders(asset)) {
    features.push_back({"no-colliders", "the hair touches nothing", usual});
    features.back().touches_colliders = false;
  }
  CrowdSettings varying = usual;
  varying.frame_time_varies = true;
  features.push_back(
      {"varying-frame-time", "no frame is as long as the last, so that nothing computed for it can be kept", varying});
  add_levels(asset, usual, features);
  add_intervals(usual, features);
  add_rest(usual, features);
  features.push_back(
      {"poses-only", "telling where the heads are, which is part of all the others, and no step", usual});
  features.back().steps = false;
  add_instruction_sets(usual, features);
  return features;
}

}  // namespace coif
