// That the ways to draw exactly agree, and what is refused.

#include "gl/exact_mode_test.h"
#include "gl/made_up_wig.h"
#include "gl/pixels.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace coif {
namespace {

class ExactModes : public ExactMode {
 protected:
  /// Of a wig that fills the view, in the bound target.
  void draw_wig(Way way, const Asset& wig, float turn) {
    start(way);
    if (IsSkipped()) return;
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, wig, kExactMode), Status::kOk);
    HeadDraw desc = exact(std::uint32_t(wig.bones().size()));
    desc.head.rotation = {0, std::sin(turn / 2), 0, std::cos(turn / 2)};
    for (const int axis : {0, 5, 10}) desc.clip_from_world[axis] *= 5;
    clear({30, 60, 90, 255});
    ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk) << renderer_.failure();
    model.destroy();
  }
  /// In place of the bytes. False where the driver draws to no such target.
  static bool bind_half_floats() {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA16F, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
    return glGetError() == GL_NO_ERROR && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  static std::vector<float> read_floats() {
    std::vector<float> rgba(std::size_t(4 * kSize * kSize));
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, rgba.data());
    return rgba;
  }

  static constexpr float kTurns[] = {0.0f, 0.7f, 2.0f, 4.0f};
  const std::vector<std::byte> bytes_ = made_up_wig({.strips = 60, .texture_size = 64});
};

TEST_P(ExactModes, GiveTheSamePicture) {
  if (!bind_half_floats()) GTEST_SKIP() << "the driver does not draw to half floats";
  const OpenedAsset wig(bytes_);
  for (const float turn : kTurns) {
    std::vector<float> pictures[2];
    draw_wig(Way::kLists, *wig, turn);
    pictures[0] = read_floats();
    draw_wig(GetParam(), *wig, turn);
    pictures[1] = read_floats();
    if (IsSkipped()) return;
    for (std::size_t i = 0; i < pictures[0].size(); ++i) ASSERT_NEAR(pictures[0][i], pictures[1][i], 1.0 / 255) << turn;
  }
}

// Peeling blends layer after layer into the target, which rounds each.
TEST_P(ExactModes, GiveNearlyTheSameBytes) {
  const OpenedAsset wig(bytes_);
  for (const float turn : kTurns) {
    draw_wig(Way::kLists, *wig, turn);
    const auto listed = read_pixels(kSize);
    draw_wig(GetParam(), *wig, turn);
    if (IsSkipped()) return;
    EXPECT_LE(worst_difference(listed, read_pixels(kSize)), 2) << turn;
    EXPECT_GT(worst_difference(listed, std::vector<std::uint8_t>(listed.size(), listed[0])), 100) << "hair is seen";
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, ExactModes, testing::Values(Way::kPeeling, Way::kOverflow),
                         [](const auto& param) { return name_of(param.param); });

class ExactModeRefused : public CountedGlTest {};

TEST_F(ExactModeRefused, SaysWhichFunctionIsMissing) {
  WithoutFunctions without(calls_->loader(), "glGenQueries");
  ASSERT_EQ(renderer_.create(without.loader(), kSmallBlocks), Status::kOk) << "only this mode needs it";
  const OpenedAsset asset(card_contents(std::array{soft_card({255, 0, 0, 128}, 0)}));
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset), Status::kOk);
  HeadDraw desc = at_rest();
  desc.transparency = &kExactMode;
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kDriver);
  EXPECT_NE(std::string(renderer_.failure()).find("glGenQueries"), std::string::npos) << renderer_.failure();
  EXPECT_EQ(middle_pixel(), (Pixel{0, 0, 0, 0}));
  desc.transparency = &kBlendMode;
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kOk);
  model.destroy();
}

TEST_F(ExactModeRefused, ListsOfAnUnreasonableSizeAreABadArgument) {
  for (const std::uint32_t bytes : {0u, 1000u, (1u << 30) + 1}) {
    RendererDesc desc = kSmallBlocks;
    desc.list_bytes = bytes;
    EXPECT_EQ(renderer_.create(calls_->loader(), desc), Status::kBadArgument) << bytes;
  }
}

}  // namespace
}  // namespace coif
