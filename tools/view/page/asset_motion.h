#pragma once
// How an asset's hair moves, as recipes say it, and what becomes of it when somebody says something else: what the cook
// would make of the same recipe, as far as the asset tells, by the cook's own formulas.

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

/// What somebody changed; what is absent is as the asset has it.
struct MotionTuning {
  std::vector<cook::CurvePoint> resistance{}, damping_ratio{};  ///< Empty: as it is.
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
  AssetMotion() = default;  ///< Of hair that does not move.
  /// Copies what it needs.
  explicit AssetMotion(const Asset& asset);

  [[nodiscard]] bool is_empty() const { return bones_.empty(); }
  [[nodiscard]] const MeanMotion& mean() const { return mean_; }
  /// That moves all of it; null: resistances or springs do, or several.
  [[nodiscard]] const cook::HairPreset* preset() const { return preset_; }

  /// One for each bone of the asset, rigid ones included; its own to the bit where nothing is said. Neither chooses
  /// models, sub-steps or twist anew nor looks whether chains have one motion: what the cook changed for that is kept.
  [[nodiscard]] std::vector<DynamicsRecord> tuned(const MotionTuning& tuning) const;
  /// SkeletonRecord::air_lag.
  [[nodiscard]] float air_lag(const MotionTuning& tuning) const;

  /// The "dynamics" of a recipe that cooks to that, as a JSON object: what was changed, and what a cook would else
  /// choose anew beside it.
  /// "{}" where nothing is said.
  [[nodiscard]] std::string recipe(const MotionTuning& tuning) const;

  /// For the page: {"moves", "preset", "springs", "conditioned": bool, "resistance", "damping_ratio": {"points",
  /// "bones": [[place, value]]}}.
  [[nodiscard]] std::string json() const;

 private:
  /// What a bone's numbers tell of who said them.
  struct Bone {
    DynamicsRecord own{};  ///< As asked for: before the cook made its chain have one motion.
    double place = 0;      ///< Where its middle is along its chain, which takes the values of curves.
    const cook::HairPreset* preset = nullptr;  ///< By which it has its stiffness.
    bool is_tied = false;                      ///< With a preset: as tied hair swings.
    std::optional<double> said_ratio;  ///< Share of critical damping; none: what its resistance or its preset brings.
    double shown_ratio = 0;            ///< By its preset's measure where it has one.
    double curve_ratio = 0;            ///< By that of bones with a resistance.
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
  std::vector<BoneRecord> bone_records_;  ///< Of the simulated ones, as all that follows.
  std::vector<Bone> bones_;
  lab::Rig rig_;
  std::vector<lab::Carried> carried_;
  MeanMotion mean_;
  const cook::HairPreset* preset_ = nullptr;
  float air_lag_ = 0;
  bool has_springs_ = false;  ///< As far as can be told.
};

/// A curve from 0 to 1 of few points through many `values`, in any order: bones of one place count by their mean. Up to
/// `most` points, 2 or more, fewer where those are as near as nobody sees, where values are seen by their `power`.
/// Values are >= 0. Empty for none.
[[nodiscard]] std::vector<cook::CurvePoint> reduced_curve(std::span<const cook::CurvePoint> values, double power,
                                                          std::size_t most);

}  // namespace coif::view
