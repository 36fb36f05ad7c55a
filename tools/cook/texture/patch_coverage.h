#pragma once

#include "cook/recipe/findings.h"
#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"
#include "cook/texture/transparency.h"
#include "platform/stop.h"

#include <array>
#include <vector>

namespace coif::cook {

struct DrawnRecipe;

/// The texels of the base colour that count: those with alpha times `factor` of at least `threshold`.
struct AlphaTest {
  const Image* image = nullptr;  ///< RGBA; null: everything counts.
  double factor = 1;
  double threshold = 0.5;

  /// `uv` may lie outside 0..1: the texture repeats.
  [[nodiscard]] bool passes(const Eigen::Vector2f& uv) const;
};

/// The test for the hair: texels that are at least half opaque, or those of the opaque pass if it draws more. Keeps a
/// pointer to the image of `color`.
[[nodiscard]] AlphaTest alpha_test(const BaseColor& color, const Transparency& transparency, const DrawnRecipe& recipe);

/// Pictures of the hair at rest in low resolution from all sides. They show which patches are seen, and which have
/// others behind or before them everywhere.
class PatchCoverage {
 public:
  PatchCoverage(const HairStrips& hair, const AlphaTest& alpha, const platform::Threads& threads);

  /// Pixels of all views in which nothing is before the patch.
  [[nodiscard]] std::size_t seen(std::uint32_t patch) const { return seen_[patch]; }
  /// Pixels of all views that some patch covers.
  [[nodiscard]] std::size_t covered() const { return covered_; }
  /// Pixels of all views that the patch covers and no other patch that was not dropped.
  [[nodiscard]] std::size_t pixels(std::uint32_t patch) const;
  [[nodiscard]] std::size_t alone(std::uint32_t patch) const;
  void drop(std::uint32_t patch);

 private:
  static constexpr std::size_t kDirections = 7;

  struct View {
    std::vector<std::uint32_t> layers;              ///< Per pixel, patches that cover it.
    std::vector<std::vector<std::uint32_t>> cover;  ///< Per patch, its pixels.
    std::vector<std::uint32_t> seen;                ///< Per patch, from this side and from the opposite one.
  };
  static View draw(const HairStrips& hair, const AlphaTest& alpha, std::size_t direction, int pixels);

  std::array<View, kDirections> views_;
  std::vector<std::size_t> seen_;
  std::size_t covered_ = 0;
};

/// The patches that end as if cut with scissors, ascending. Real hair thins out; an end that stays opaque over its
/// whole width up to the last edge shows the polygon. Warns where there are more than a few.
///
/// A patch has a blunt end where it has a free edge at its tips, where it is opaque there over at least half of its
/// greatest width, and where no other hair lies over that edge or continues its strands. So ends that are modelled to a
/// point, that fade in alpha or are tied up in other hair, and closed shapes do not count. `opaque` has the threshold
/// from which on texels are drawn as opaque.
[[nodiscard]] std::vector<std::uint32_t> find_blunt_ends(const HairStrips& hair, const FittedHead& head,
                                                         const AlphaTest& opaque, const platform::Threads& threads,
                                                         Findings& findings);

}  // namespace coif::cook
