#pragma once

#include "view/page/asset_motion.h"
#include "view/page/view_settings.h"

#include <coif/asset.h>

#include <string>
#include <vector>

namespace coif::view {

/// A visitor's changes of the motion of an asset's hair: applied in the asset's memory at once, and as a recipe.
class TunableMotion {
 public:
  TunableMotion() = default;
  /// Takes the motion and the settings of the opened asset.
  TunableMotion(AssetMotion motion, const ViewSettings& settings);

  /// Replaces the asset's own curve; empty: its own.
  void set_resistance(std::vector<cook::CurvePoint> curve) { curves_.resistance = std::move(curve); }
  void set_damping_ratio(std::vector<cook::CurvePoint> curve) { curves_.damping_ratio = std::move(curve); }

  /// The asset is another cook of the one that `before` tuned: recipes contain the changes of both.
  void go_on(const TunableMotion& before);
  /// Call it after go_on(). Either the asset was cooked with the present settings, by a recipe that contains them; or
  /// it was cooked without any changes, and changes count from there.
  void accept(const ViewSettings& settings, bool recipe_says_it);

  /// The present settings are already in the asset's memory.
  [[nodiscard]] bool is_applied(const ViewSettings& settings) const;
  /// Writes them into an asset in the caller's own memory: the one whose motion this was made of, or its copy.
  void apply(const ViewSettings& settings, const Asset& asset);
  /// The values written last differ from the asset's own.
  [[nodiscard]] bool is_tuned() const { return written_ != MotionTuning{}; }

  /// The "dynamics" of a recipe with the settings; AssetMotion::recipe().
  [[nodiscard]] std::string recipe(const ViewSettings& settings) const;
  /// The asset as it was opened; AssetMotion::json().
  [[nodiscard]] std::string json() const { return motion_.json(); }

 private:
  /// The reference of changes.
  struct Base {
    ViewSettings settings;
    MotionTuning curves;
    [[nodiscard]] MotionTuning to(const ViewSettings& settings, const MotionTuning& curves) const;
  };

  AssetMotion motion_, first_motion_;  ///< The asset's motion, and that of the asset from which recipes count changes.
  Base cooked_, first_;
  MotionTuning curves_;   ///< Nothing else.
  MotionTuning written_;  ///< In the asset's memory.
};

/// The settings with the asset's own motion.
[[nodiscard]] ViewSettings with_motion(ViewSettings settings, const AssetMotion& motion);

/// The differences of `settings` from `before` that concern motion.
[[nodiscard]] MotionTuning tuning_between(const ViewSettings& before, const ViewSettings& settings);

}  // namespace coif::view
