#pragma once

#include "base/tool_error.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/lods/make_lods.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/colliders.h"
#include "cook/rig/skeleton.h"
#include "cook/select/select_hair.h"
#include "cook/strands/patches.h"
#include "cook/strands/strand_direction.h"
#include "cook/texture/bake_textures.h"
#include "cook/texture/source_images.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coif {

/// What a cook's result depends on beside the source's and the recipe's own bytes.
struct CookInputs {
  std::vector<std::filesystem::path>
      source_files;  ///< What the source names, side files and images; some may be absent.
  std::vector<std::filesystem::path> recipe_files;  ///< What the recipe names, found from the recipe's folder.
  std::vector<TextureQuestion> questions;           ///< To the TextureFolder of the source.
};

struct PassTime {
  std::string name;
  double ms = 0;
};

struct CookReport {
  std::vector<PassTime> passes;
  std::vector<std::string> warnings;
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;
  std::uint32_t patches = 0;
  std::uint32_t patches_by_index = 0;
  std::uint32_t patches_by_position = 0;
  std::uint32_t chains = 0;
  std::uint32_t bones = 0;
  std::uint32_t simulated_bones = 0;
  std::vector<std::string> notes;  ///< What was chosen, and why.
  std::vector<LeftOut> left_out;   ///< What of the source is not in the asset, and why.
};

struct CookResult {
  std::vector<std::byte> asset;  ///< The bytes of a .coif; opens without error.
  CookReport report;
  CookInputs inputs;
};

/// Runs every pass on a source model. Pure: same model, recipe and settings give the same bytes.
tl::expected<CookResult, ToolError> cook(const SourceModel& source, const Recipe& recipe, const CookSettings& settings);

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
