#pragma once

#include "view/page/asset_motion.h"
#include "view/page/view_settings.h"

#include <coif/asset.h>

#include <string>
#include <vector>

namespace coif::view {

/// What a visitor changed of how an asset's hair moves: in the asset's memory, at once, and as a recipe.
class TunableMotion {
 public:
  TunableMotion() = default;
  /// Of an asset and its settings, as they came.
  TunableMotion(AssetMotion motion, const ViewSettings& settings);

  /// Take the place of the asset's own; empty: its own.
  void set_resistance(std::vector<cook::CurvePoint> curve) { curves_.resistance = std::move(curve); }
  void set_damping_ratio(std::vector<cook::CurvePoint> curve) { curves_.damping_ratio = std::move(curve); }

  /// The asset is another cook of the one that `before` tuned: recipes tell the changes of both.
  void go_on(const TunableMotion& before);
  /// After go_on(). Either what is set now is what the asset was cooked with, by a recipe that says so; or it was
  /// cooked without any changes, and those are told from how it came.
  void accept(const ViewSettings& settings, bool recipe_says_it);

  /// What is set is in the asset's memory already.
  [[nodiscard]] bool is_applied(const ViewSettings& settings) const;
  /// Writes it there: into an asset whose memory is the caller's own, and which is the one whose motion this was made
  /// of, or its copy.
  void apply(const ViewSettings& settings, const Asset& asset);
  /// What was written last is not what the asset came with.
  [[nodiscard]] bool is_tuned() const { return written_ != MotionTuning{}; }

  /// "dynamics" of a recipe of what is set; AssetMotion::recipe().
  [[nodiscard]] std::string recipe(const ViewSettings& settings) const;
  /// As the asset came; AssetMotion::json().
  [[nodiscard]] std::string json() const { return motion_.json(); }

 private:
  /// What changes are told against.
  struct Base {
    ViewSettings settings;
    MotionTuning curves;
    [[nodiscard]] MotionTuning to(const ViewSettings& settings, const MotionTuning& curves) const;
  };

  AssetMotion motion_, first_motion_;  ///< The asset's, and that of the one which recipes tell changes of.
  Base cooked_, first_;
  MotionTuning curves_;   ///< Nothing else.
  MotionTuning written_;  ///< In the asset's memory.
};

/// The settings with what the asset itself says of how hair moves.
[[nodiscard]] ViewSettings with_motion(ViewSettings settings, const AssetMotion& motion);

/// What `settings` say of how hair moves that `before` do not.
[[nodiscard]] MotionTuning tuning_between(const ViewSettings& before, const ViewSettings& settings);

}  // namespace coif::view
