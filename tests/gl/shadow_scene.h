#pragma once

#include "gl/gl_test.h"

#include <coif/shadow.h>

#include <array>
#include <span>
#include <vector>

namespace coif {

/// A white card in the middle of the picture that catches the shadow of others, by a light from the upper right, which
/// is out of the picture: what is half a metre towards the light shades the card's middle and leaves its left side.
class ShadowScene : public CountedGlTest {
 protected:
  /// The way to the light: metres up are metres to the right.
  static constexpr Vec3 kTowardsLight{1, 0, 1};
  static constexpr ShadowBall kBall{{0.4, 0, 0.4}, 1.5f};

  void SetUp() override;
  void TearDown() override;

  [[nodiscard]] static Light lamp() { return {Light::Kind::kDirectional, kTowardsLight, {1, 1, 1}}; }

  /// `height` metres above the receiver and as many to the right of it; `alpha` 0..1.
  [[nodiscard]] static DrawnCard card_above(float height, double alpha, float half_size = 0.2f);

  /// The map of these cards alone; all must succeed.
  void cast(HairShadow& shadow, std::span<const DrawnCard> cards, const Light& light = lamp(),
            const ShadowBall& ball = kBall);

  /// The share of the light that reaches the receiver at a pixel: its diffuse light with the shadow, of that without.
  [[nodiscard]] double light_at(int x, int y, const HairShadow& shadow, const Light& light = lamp());
  [[nodiscard]] double light_at_middle(const HairShadow& shadow, const Light& light = lamp()) {
    return light_at(kSize / 2, kSize / 2, shadow, light);
  }

  /// Where light_at() draws to: the framebuffer that was bound when the test began.
  void bind_target() const;

  HairModel receiver_;
  unsigned target_ = 0;
};

/// Every technique, small maps.
[[nodiscard]] std::vector<ShadowDesc> all_shadows();

}  // namespace coif
