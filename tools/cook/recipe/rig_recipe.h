#pragma once

#include "cook/recipe/body_collider.h"
#include "cook/recipe/bone_limit.h"
#include "cook/recipe/chain_links.h"
#include "cook/recipe/root_tip_curve.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

/// The bones that are rigid with the head, like a scalp: by the thesis's rule, none, or those of `scalp_bones`.
enum class ScalpRule { kThesis, kNoScalp, kPattern };
enum class ChainSource { kAuto, kFile, kFit, kNoChains };
enum class DynamicsSource { kAuto, kCurves, kSprings };
enum class DynamicsModel { kAuto, kCascade, kPassive };
enum class ConditioningRule { kAuto, kOff };

/// The recipe's values for bones, their motion, and the motion's budget.
struct RigRecipe {
  bool scene_simulate = false;
  ScalpRule scalp = ScalpRule::kThesis;
  std::vector<std::string> scalp_bones;
  ChainSource chain_source = ChainSource::kAuto;
  // Chains that are fitted.
  std::uint32_t chain_max_count = 0;
  std::uint32_t chain_max_bones = 0;
  double chain_bone_length = 0;
  double chain_shortest = 0;
  std::vector<std::string> chain_only;
  std::vector<std::string> chain_exclude;
  bool body_from_file = false;  ///< The file's spring colliders that are not on the head.
  std::vector<RecipeBodyCollider> body_colliders;

  DynamicsSource dynamics_source = DynamicsSource::kAuto;
  std::string dynamics_preset;  ///< "natural", "stiff", "heavy", "bouncy" or "wet".
  DynamicsModel dynamics_model = DynamicsModel::kAuto;
  /// 0..1; none: the preset's, or the damping that comes with a resistance or spring.
  std::optional<double> liveliness;
  std::vector<CurvePoint> resistance;  ///< Empty: by the preset.
  std::optional<double> friction;      ///< 1/s; none: the preset's, or 2 with a resistance.
  std::optional<double> air_follow;
  bool sags = false;
  double gravity_scale = 0;
  double authoring_rate = 0;
  std::optional<NumberOrCurve> damping_ratio;  ///< None: follows from `liveliness`.
  ConditioningRule conditioning = ConditioningRule::kAuto;
  std::optional<double> torsion;        ///< 1/s; none: chosen for each chain.
  double angle_limit = 0;               ///< Degrees.
  std::vector<RecipeBoneLimit> limits;  ///< If two are for one bone, the later one holds.
  RecipeLinks links;
  double link_stretch = 0;  ///< Share of the distance at rest.
  double link_shrink = 0;   ///< As link_stretch.
  double parent_share = 0;

  double budget_error = 0;  ///< Percent of the chain's length.
  double budget_error_mm = 0;
  double budget_max_error = 0;     ///< Percent of the chain's length.
  double budget_worst_second = 0;  ///< Percent of the chain's length.
  double budget_cost = 0;          ///< Nominal nanoseconds per head and frame.
  double slowest_rate = 0;
  double fastest_rate = 0;
};

}  // namespace coif::cook
