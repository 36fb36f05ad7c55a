#include "base/text.h"
#include "motion/head_path.h"
#include "report/cost/measure_cost.h"

#include <coif/instruction_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

constexpr std::string_view kAlgorithm1 = "thesis";

bool touches_colliders(const Asset& asset) {
  return std::ranges::any_of(asset.bones(), [](const BoneRecord& bone) { return bone.colliders != 0; });
}

void add_levels(const Asset& asset, const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  for (std::uint32_t level = 1; level < asset.stored_lods().size() && !asset.lod_bones().empty(); ++level) {
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
    settings.substeps = 0;  // A number of sub-steps would be per frame, and nothing would be saved.
    features.push_back(
        {fmt::format("every-{}{}-frame", interval, interval == 2 ? "nd" : "th"),
         "each head is stepped that often, in turns, with the sub-steps that the asset asks for such a step",
         settings});
  }
}

/// Features that cost next to nothing, with what they save.
void add_rest(const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  CrowdSettings unseen = usual, asleep = usual, awake = usual;
  unseen.detail.simulated = false;
  asleep.heads_move = awake.heads_move = false;
  awake.sleeps = false;
  features.push_back({"unseen", "no head is seen, and none simulated", unseen});
  features.push_back({"asleep", "no head moves, and all hair has fallen asleep", asleep});
  features.push_back({"still-awake", "no head moves, and hair may not fall asleep", awake});
}

/// The features of a character, one at a time.
void add_characters(const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  constexpr std::uint32_t kRoom = 4;
  const auto add = [&](const char* name, const char* description, const CrowdCharacter& character) {
    features.push_back({name, description, usual});
    features.back().settings.character = character;
  };
  add("scale", "every head is twice as large", {.scale = 2});
  add("character", "on characters, with room for four colliders, of which none is given",
      {.is_one = true, .room = kRoom});
  add("gusts", "on characters, in gusts, which each bone feels where it starts", {.is_one = true, .in_gusts = true});
  for (const std::uint32_t count : {1u, kRoom}) {
    const bool is_one = count == 1;
    add(is_one ? "collider-far" : "4-colliders-far",
        is_one ? "the same with one collider, out of reach" : "the same with four colliders, out of reach",
        {.is_one = true, .room = kRoom, .colliders = count});
    add(is_one ? "collider-near" : "4-colliders-near",
        is_one ? "the same with a fist in the hair" : "the same with four fists in the hair",
        {.is_one = true, .room = kRoom, .colliders = count, .are_near = true});
  }
  add("pose", "on characters, the hair follows a pose that changes in every frame", {.is_one = true, .weight = 1.0f});
  add("half-pose", "the same, half of it the animation", {.is_one = true, .weight = 0.5f});
}

void add_instruction_sets(const CrowdSettings& usual, std::vector<CrowdFeature>& features) {
  constexpr InstructionSet kAll[] = {InstructionSet::kScalar, InstructionSet::kPortable, InstructionSet::kSse4,
                                     InstructionSet::kAvx2,   InstructionSet::kAvx512,   InstructionSet::kNeon,
                                     InstructionSet::kWasm};
  for (const InstructionSet set : kAll) {
    if (!can_run(set) || set == best_instruction_set()) continue;
    CrowdSettings settings = usual;
    settings.instruction_set = set;
    const std::string name = lower_case(coif::name_of(set));
    features.push_back(
        {name, fmt::format("run with {} instead of {}", coif::name_of(set), coif::name_of(best_instruction_set())),
         settings});
  }
}

}  // namespace

std::vector<CrowdFeature> crowd_features(const Asset& asset, const CrowdSettings& usual) {
  std::vector<CrowdFeature> features{{kAsCooked, "all heads run", usual}};
  if (touches_colliders(asset)) {
    features.push_back({"no-colliders", "the hair touches nothing", usual});
    features.back().asset = FeatureAsset::kTouchingNothing;
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
  if (usual.solver != kAlgorithm1) {
    features.push_back({"links", "each chain hangs together with the one next to it", usual, FeatureAsset::kLinked});
    add_characters(usual, features);
  }
  add_instruction_sets(usual, features);
  return features;
}

}  // namespace coif::report
