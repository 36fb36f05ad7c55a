#pragma once

// What a recipe says of some patches alone.

#include "cook/recipe/root_tip_curve.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// Which patches are meant: those for which all that is given holds. 'coif cook --list patches' prints what there is.
struct PatchSelection {
  std::string mesh, material;          ///< Patterns with * and ?, letters of either case; "": any.
  std::vector<std::uint32_t> indices;  ///< Numbers of patches; empty: any.
  std::vector<std::uint32_t> islands;  ///< Numbers of parts of the texture; empty: any.
  std::optional<std::array<double, 6>>
      box;  ///< Lowest and highest corner, metres, model space: the patch's middle is inside.
  std::optional<std::array<double, 3>> near;  ///< Metres, model space: the patch nearest to this point,
  std::optional<double> within;               ///< or with this all that are so near (metres).

  /// Empty: nothing is selected by, which a recipe may not say.
  [[nodiscard]] bool is_empty() const {
    return mesh.empty() && material.empty() && indices.empty() && islands.empty() && !box && !near;
  }
};

/// What is said of them; what is absent is as for the whole hair.
struct PatchOverride {
  PatchSelection select;
  std::optional<bool> keep;          ///< False: no hair, and left out.
  std::optional<std::string> root;   ///< As StripRecipe::strand_root; "swap": the other end than the cook would take.
  std::optional<std::string> chain;  ///< "auto"; "none": rigid with the head.
  // Of the chains that carry mostly these patches.
  std::optional<std::vector<CurvePoint>> resistance;
  std::optional<std::string> preset;  ///< Before springs and resistances of the whole.
  std::optional<NumberOrCurve> damping_ratio;
  std::optional<double> liveliness, friction, gravity_scale, angle_limit, parent_share;

  /// Something is said of how the patches move.
  [[nodiscard]] bool is_of_motion() const {
    return resistance || preset || liveliness || friction || gravity_scale || damping_ratio || angle_limit ||
           parent_share;
  }
  /// Adds what a later one says of motion, which holds where both say something.
  void add_motion(const PatchOverride& later);
  /// Puts what is said of motion in place of what `recipe` says.
  void apply_motion(RigRecipe& recipe) const;
};

}  // namespace coif::cook
