#pragma once

// The recipe's values for some patches alone.

#include "cook/recipe/root_tip_curve.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// The patches that are meant: those that match all members given. 'coif cook --list patches' prints the patches.
struct PatchSelection {
  std::string mesh, material;          ///< Patterns with * and ?, letters of either case; "": any.
  std::vector<std::uint32_t> indices;  ///< Numbers of patches; empty: any.
  std::vector<std::uint32_t> islands;  ///< Numbers of parts of the texture; empty: any.
  std::optional<std::array<double, 6>>
      box;  ///< Lowest and highest corner, metres, model space: the patch's middle is inside.
  std::optional<std::array<double, 3>> near;  ///< Metres, model space: selects the patch nearest to this point.
  std::optional<double> within;               ///< Metres: with `near`, selects all patches within this distance.

  /// Selects by nothing, which is an error in a recipe.
  [[nodiscard]] bool is_empty() const {
    return mesh.empty() && material.empty() && indices.empty() && islands.empty() && !box && !near;
  }
};

/// The values for these patches. Absent ones are those of the whole hair.
struct PatchOverride {
  PatchSelection select;
  std::optional<bool> keep;          ///< False: no hair, and left out.
  std::optional<std::string> root;   ///< As StripRecipe::strand_root; "swap": the other end than the cook would choose.
  std::optional<std::string> chain;  ///< "auto"; "none": rigid with the head.
  // For chains that carry mostly these patches.
  std::optional<std::vector<CurvePoint>> resistance;
  std::optional<std::string> preset;  ///< Overrides springs and resistances of the whole hair.
  std::optional<NumberOrCurve> damping_ratio;
  std::optional<double> liveliness, friction, gravity_scale, angle_limit, parent_share;

  /// It has a value for the patches' motion.
  [[nodiscard]] bool is_of_motion() const {
    return resistance || preset || liveliness || friction || gravity_scale || damping_ratio || angle_limit ||
           parent_share;
  }
  /// Adds the motion of a later override, which takes precedence.
  void add_motion(const PatchOverride& later);
  /// Replaces the motion of `recipe` where this has a value.
  void apply_motion(RigRecipe& recipe) const;
};

}  // namespace coif::cook
