#pragma once

// The motion of an asset's hair in the words of recipes, and the effect of changes. The cook's own formulas give, as
// far as the asset shows it, the result that a cook of the same recipe would have.

#include "cook/dynamics/bone_motion.h"
#include "cook/recipe/hair_preset.h"
#include "cook/recipe/root_tip_curve.h"
#include "lab/rig.h"

#include <coif/asset.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::view {

/// A user's changes; absent values are the asset's.
struct MotionTuning {
  std::vector<cook::CurvePoint> resistance{}, damping_ratio{};  ///< Empty: the asset's.
  const cook::HairPreset* preset = nullptr;
  std::optional<double> liveliness{}, friction{}, gravity_scale{}, air_follow{};
  std::optional<double> angle_limit{};  ///< Degrees.

  bool operator==(const MotionTuning&) const = default;
};

/// The numbers of all bones together: means, where they differ.
struct MeanMotion {
  double liveliness = 0, friction = 0, gravity_scale = 0, air_follow = 0;
  double angle_limit = 0;  ///< Degrees.
};

class AssetMotion {
 public:
  AssetMotion() = default;  ///< For hair that does not move.
  /// Copies what it needs.
  explicit AssetMotion(const Asset& asset);

  [[nodiscard]] bool is_empty() const { return bones_.empty(); }
  [[nodiscard]] const MeanMotion& mean() const { return mean_; }
  /// The preset that moves all of it; null: resistances or springs do, or several presets.
  [[nodiscard]] const cook::HairPreset* preset() const { return preset_; }

  /// One for each bone of the asset, rigid ones included; without changes its own to the bit. Does not choose models,
  /// sub-steps or twists anew, and does not check whether chains have a well-defined motion: the cook's changes for
  /// that are kept.
  [[nodiscard]] std::vector<DynamicsRecord> tuned(const MotionTuning& tuning) const;
  /// SkeletonRecord::air_lag.
  [[nodiscard]] float air_lag(const MotionTuning& tuning) const;

  /// The "dynamics" of a recipe that cooks to that, as a JSON object: the changes, and values that a cook would
  /// otherwise choose anew. "{}" without changes.
  [[nodiscard]] std::string recipe(const MotionTuning& tuning) const;

  /// For the page: {"moves", "preset", "springs", "conditioned": bool, "resistance", "damping_ratio": {"points",
  /// "bones": [[place, value]]}}.
  [[nodiscard]] std::string json() const;

 private:
  /// The source of a bone's numbers.
  struct Bone {
    DynamicsRecord own{};  ///< The artist's numbers, before the cook made its chain's motion well-defined.
    double place = 0;      ///< Place of its middle along its chain, where it takes the values of curves.
    const cook::HairPreset* preset = nullptr;  ///< The preset that gives its stiffness.
    bool is_tied = false;                      ///< With a preset: it swings like tied hair.
    std::optional<double> said_ratio;          ///< Share of critical damping; none: from its resistance or its preset.
    double shown_ratio = 0;                    ///< In its preset's unit, if it has one.
    double curve_ratio = 0;                    ///< In the unit of bones with a resistance.
    bool leans = false;
  };

  void find_places(const Asset& asset);
  void find_preset(std::size_t i);
  void find_ratios(std::size_t i);
  void find_means();
  [[nodiscard]] bool goes_by_curve(const MotionTuning& tuning) const;
  [[nodiscard]] bool says_ratio() const;
  [[nodiscard]] std::vector<cook::CurvePoint> resistances() const;
  [[nodiscard]] std::vector<cook::CurvePoint> ratios(double Bone::*ratio) const;
  [[nodiscard]] MotionTuning completed(MotionTuning tuning) const;
  void bake(std::size_t i, const MotionTuning& tuning, lab::Rig& rig, DynamicsRecord& record) const;
  void add_conditioning(std::size_t i, DynamicsRecord& record) const;

  std::vector<DynamicsRecord> records_;   ///< The asset's, of all bones.
  std::vector<BoneRecord> bone_records_;  ///< For the simulated bones, like all that follows.
  std::vector<Bone> bones_;
  lab::Rig rig_;
  std::vector<lab::Carried> carried_;
  MeanMotion mean_;
  const cook::HairPreset* preset_ = nullptr;
  float air_lag_ = 0;
  bool has_springs_ = false;  ///< As far as the asset shows.
};

/// A curve of few points from 0 to 1 through many `values`, in any order; bones at one place count with their mean. Up
/// to `most` points, 2 or more; fewer where nobody sees the difference, with values shown by their `power`. Values are
/// >= 0. Empty for no values.
[[nodiscard]] std::vector<cook::CurvePoint> reduced_curve(std::span<const cook::CurvePoint> values, double power,
                                                          std::size_t most);

}  // namespace coif::view
