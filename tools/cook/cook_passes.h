#pragma once

#include "cook/bake_dynamics.h"
#include "cook/bake_textures.h"
#include "cook/cook.h"
#include "cook/extract_patches.h"
#include "cook/make_lods.h"
#include "cook/select_hair.h"
#include "cook/settle_colliders.h"
#include "cook/skin_weights.h"
#include "cook/sort_patches.h"
#include "cook/split_shells.h"
#include "cook/tune_solver.h"

#include <chrono>

namespace coif {

/// What each pass made, in the order in which they run.
struct CookedParts {
  SelectedHair selected;
  BaseColor base_color;
  HeadBone head_bone;
  FittedHead head;
  std::vector<std::uint32_t> place;  ///< Of each vertex: weld_places(), kept up as vertices are copied.
  ExtractedPatches extracted;
  StrandField strands;
  Skeleton skeleton;
  SkinWeights weights;
  Colliders colliders;
  BakedDynamics dynamics;
  TunedSolver tuned;
  PatchOrder order;
  BakedTextures textures;
  DetailLevels lods;
};

/// Announces a pass, runs it and notes its time.
template <typename Pass>
auto run_timed(const CookSettings& settings, CookReport& report, const char* name, const Pass& pass) {
  if (settings.progress) settings.progress(name);
  const auto start = std::chrono::steady_clock::now();
  auto result = pass();
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
  report.passes.push_back({name, elapsed.count()});
  return result;
}

/// Runs the passes one after the other; what they chose, left out and warn of goes to the report as they go.
tl::expected<CookedParts, ToolError> run_passes(const SourceModel& source, const Recipe& recipe,
                                                const CookSettings& settings, CookReport& report);

}  // namespace coif
