#pragma once

#include "cook/cook.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/choose_model.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/lods/detail_level.h"
#include "cook/order/choose_order.h"
#include "cook/rig/body_colliders.h"
#include "cook/rig/skeleton.h"
#include "cook/select/head.h"
#include "cook/size/measured_model.h"
#include "cook/strands/choose_patches.h"
#include "cook/strands/face_hair.h"
#include "cook/strands/patches.h"
#include "cook/texture/bake_textures.h"

namespace coif {

/// A cook on its way: what it was given, and what its passes have made so far.
struct Cooking {
  const SourceModel& source;
  const Recipe& recipe;
  const CookSettings& settings;
  CookReport& report;

  std::optional<SelectedHair> selected{};  ///< What the size was judged by, where that is the hair that is cooked.
  HairStrips hair{};
  BaseColor color{};
  HeadBone head_bone{};
  FittedHead head{};
  ExtractedPatches extracted{};
  std::vector<PatchListing> listings{};  ///< Empty unless somebody asks, or the recipe says something of patches alone.
  HairRig rig{};
  Colliders colliders{};
  BodyColliders body{};
  SaidMotion said{};    ///< Of the rig's bones.
  ModelChoice model{};  ///< Of its chains.
  bool moves = false;   ///< The packed rig can be run.
  TunedSolver tuned{};
  PatchOrder order{};
  BakedTextures textures{};
  std::vector<DetailLevel> levels{};
  AssetContents contents{};  ///< First the rig, then all that is drawn.
  std::vector<std::byte> asset{};
};

/// Adds what is drawn, and where it comes from, to the rig in `contents`. Moves the texels out of `textures`.
void pack_parts(Cooking& cooking);

/// Says how mips would cover with the thresholds that the hair has now; leaves them as they are.
void judge_coverage(Cooking& cooking);

/// Writes `asset`, without the parts that the recipe's scene does without. Error (kBadInput): the runtime would refuse it,
/// and that must never reach a disk.
tl::expected<void, ToolError> write_parts(Cooking& cooking);

/// What of the result is known only at the end: figures for the report, and the files that were read.
void fill_figures(Cooking& cooking);
[[nodiscard]] CookInputs inputs_of(const Cooking& cooking);
[[nodiscard]] ListedPatches patches_of(Cooking& cooking);

}  // namespace coif
