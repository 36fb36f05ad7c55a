// Programs are built for the asset that needs them, and do no more than it needs.

#include "gl/gl_test.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace coif::lean_programs_test {

AssetContents textured(int alpha = 255) {
  DrawnCard card;
  card.rgba = {200, 160, 120, std::uint8_t(alpha)};
  card.shift_mask = {128, 255};
  AssetContents contents = card_contents(std::array{card});
  MaterialRecord& m = contents.material[0];
  std::fill_n(m.primary_color, 3, 0.5f);
  std::fill_n(m.secondary_color, 3, 0.25f);
  m.primary_exponent = m.secondary_exponent = 4;
  return contents;
}

AssetContents without(TextureRole role, AssetContents contents) {
  std::erase_if(contents.textures, [&](const TextureRecord& texture) { return texture.role == role; });
  return contents;
}

class LeanPrograms : public CountedGlTest {
 protected:
  void draw_lit(const AssetContents& contents) {
    const std::array lights{Light{Light::Kind::kDirectional, {0.2f, 0.9f, 0.4f}, {0.6f, 0.6f, 0.6f}}};
    HeadDraw desc = at_rest(std::uint32_t(contents.bones.size()));
    desc.lights = lights;
    calls_->forget();
    clear();
    draw(contents, desc);
  }
  /// Whether any program of the last draw has this uniform.
  [[nodiscard]] bool used(const char* uniform) const {
    return std::any_of(calls_->drawn_with.begin(), calls_->drawn_with.end(),
                       [&](GLuint program) { return glGetUniformLocation(program, uniform) >= 0; });
  }
};

TEST_F(LeanPrograms, NoneExistsBeforeAnAssetNeedsIt) {
  EXPECT_EQ(renderer_.program_count(), 0u);
  EXPECT_EQ(calls_->links, 0);
  draw_lit(textured());
  EXPECT_EQ(renderer_.program_count(), 1u) << "opaque: no depth pass, no alpha test";
  EXPECT_EQ(calls_->links, 1);
  draw_lit(textured(200));
  EXPECT_EQ(renderer_.program_count(), 2u) << "a depth program more; its texture has one alpha";
}

TEST_F(LeanPrograms, ModelsWithTheSameNeedsShareThem) {
  draw_lit(textured());
  draw_lit(textured());
  EXPECT_EQ(calls_->links, 0);
  renderer_.destroy();
  ASSERT_EQ(renderer_.create(calls_->loader()), Status::kOk);
  EXPECT_EQ(renderer_.program_count(), 0u);
}

TEST_F(LeanPrograms, AreAllBuiltWithTheUpload) {
  DrawnCard hole;
  hole.rgba[3] = 0;
  for (const AssetContents& one : {textured(), textured(200), card_contents(std::array{DrawnCard{}, hole})}) {
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, *DrawnAsset(one)), Status::kOk);
    calls_->forget();
    for (std::uint8_t c = 0; c < std::uint8_t(Component::kDirection); ++c) {
      for (const bool flag : {false, true}) {
        HeadDraw desc = at_rest();
        desc.component = Component(c);
        desc.transparency = flag ? &kBlendMode : &kOpaqueMode;
        desc.framebuffer_is_srgb = flag;
        ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk);
      }
    }
    EXPECT_EQ(calls_->links, 0);
    EXPECT_GT(calls_->draws, 0);
    model.destroy();
  }
}

TEST_F(LeanPrograms, PrepareBuildsWhatAnUnusualDrawNeeds) {
  AssetContents contents = textured();
  const MaterialRecord shiny = contents.material[0];
  std::fill_n(contents.material[0].secondary_color, 3, 0.0f);
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
  HeadDraw direction = at_rest();
  direction.component = Component::kDirection;
  HeadDraw other_material = at_rest();
  other_material.material = &shiny;
  for (const HeadDraw& desc : {direction, other_material}) {
    calls_->forget();
    ASSERT_EQ(renderer_.prepare(model, desc), Status::kOk);
    EXPECT_EQ(calls_->links, 1);
    EXPECT_EQ(calls_->draws, 0);
    ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk);
    EXPECT_EQ(calls_->links, 1) << "built before";
  }
  MaterialRecord bad = shiny;
  bad.primary_exponent = 0;
  other_material.material = &bad;
  EXPECT_EQ(renderer_.prepare(model, other_material), Status::kBadArgument);
  model.destroy();
  EXPECT_EQ(renderer_.prepare(model, direction), Status::kNotCreated);
}

TEST_F(LeanPrograms, FollowAReliefOnlyWhereTheAssetHasOneAndSomethingIsLit) {
  draw_lit(textured());
  EXPECT_FALSE(used("normal_texture") || used("strand_texture"));
  AssetContents contents = textured(200);
  contents.relief_texels.resize(32, std::byte{128});
  contents.reliefs = {{TextureRole::kNormal, TexelFormat::kRg8, 1, 1, 1, 0, 0, 2}};
  draw_lit(contents);
  EXPECT_TRUE(used("normal_texture"));
  EXPECT_FALSE(used("strand_texture"));
  EXPECT_EQ(calls_->textures, 3);
  const auto lit = [&](GLuint program) { return glGetUniformLocation(program, "normal_texture") >= 0; };
  EXPECT_GT(std::ranges::count_if(calls_->drawn_with, std::not_fn(lit)), 0) << "depth alone wants no normals";
  contents.reliefs.push_back({TextureRole::kStrandAxis, TexelFormat::kRg8, 1, 1, 1, 0, 16, 2});
  draw_lit(contents);
  EXPECT_TRUE(used("normal_texture") && used("strand_texture"));
}

TEST_F(LeanPrograms, FetchOnlyTexturesThatTheAssetHas) {
  draw_lit(textured());
  EXPECT_TRUE(used("base_texture"));
  EXPECT_TRUE(used("shift_mask_texture"));
  EXPECT_EQ(calls_->textures, 2);
  const Pixel whole = middle_pixel();

  draw_lit(without(TextureRole::kShiftMask, textured()));
  EXPECT_TRUE(used("base_texture"));
  EXPECT_FALSE(used("shift_mask_texture"));
  EXPECT_EQ(calls_->textures, 1);
  EXPECT_TRUE(near(middle_pixel(), whole)) << "shift 0.5 and mask 1 are what an absent texture means";

  draw_lit(without(TextureRole::kBaseColor, textured()));
  EXPECT_FALSE(used("base_texture"));
  EXPECT_TRUE(used("shift_mask_texture"));
  EXPECT_EQ(calls_->textures, 1);
  EXPECT_GT(middle_pixel()[2], whole[2]) << "white";
}

TEST_F(LeanPrograms, ReadTheShiftOnlyForAHighlight) {
  for (const auto& [primary, secondary] : {std::pair{0.5f, 0.25f}, {0.5f, 0.0f}, {0.0f, 0.25f}, {0.0f, 0.0f}}) {
    AssetContents contents = textured();
    MaterialRecord& m = contents.material[0];
    std::fill_n(m.primary_color, 3, primary);
    std::fill_n(m.secondary_color, 3, secondary);
    draw_lit(contents);
    EXPECT_EQ(used("shift_mask_texture"), primary > 0 || secondary > 0) << primary << ", " << secondary;
    const Pixel lean = middle_pixel();
    // A highlight too dark to see, but there.
    if (primary == 0) m.primary_color[0] = 1e-6f;
    if (secondary == 0) m.secondary_color[0] = 1e-6f;
    draw_lit(contents);
    EXPECT_EQ(middle_pixel(), lean) << primary << ", " << secondary;
  }
}

TEST_F(LeanPrograms, ReadMatricesFromOnePlace) {
  for (const std::uint32_t bones : {3u, kMostInBlock, kMostInBlock + 1}) {
    AssetContents contents = card_contents(std::array{DrawnCard{}}, bones);
    for (const int first : {255, 254}) {  // one bone, then two
      for (SkinRecord& skin : contents.skin)
        skin = {{0, 1, 0, 0}, {std::uint8_t(first), std::uint8_t(255 - first), 0, 0}};
      draw_lit(contents);
      EXPECT_EQ(used("palette_texture"), bones > kMostInBlock) << bones;
    }
    HeadDraw direction = at_rest(bones);
    direction.component = Component::kDirection;
    draw(contents, direction);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "a program that draw() builds leaves no error";
  }
}

TEST_F(LeanPrograms, ReadNoMatricesForRigidHair) {
  AssetContents contents = textured();
  draw_lit(contents);
  const Pixel skinned = middle_pixel();
  contents.skin.clear();
  draw_lit(contents);
  EXPECT_EQ(middle_pixel(), skinned) << "at rest";
  EXPECT_FALSE(used("palette_texture"));

  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
  HeadDraw desc = at_rest(0);
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kOk) << "no palette is needed";
  Mat34 elsewhere;
  elsewhere.m[0][3] = 5;
  desc.palette = std::span(&elsewhere, 1);
  clear();
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kOk) << "nor does one matter";
  EXPECT_EQ(middle_pixel()[3], 255);
  desc = at_rest(2);
  EXPECT_EQ(draw_head(renderer_, model, desc), Status::kSizeMismatch);
  model.destroy();
}

TEST_F(LeanPrograms, HaveNoAlphaTestWhereEveryTexelPasses) {
  DrawnCard card, hole;
  hole.rgba[3] = 0;
  hole.center[0] = 5;
  draw_lit(card_contents(std::array{card}));
  EXPECT_EQ(renderer_.program_count(), 1u);
  const Pixel lean = middle_pixel();
  draw_lit(card_contents(std::array{card, hole}));
  EXPECT_EQ(calls_->draws, 4);
  EXPECT_EQ(renderer_.program_count(), 3u) << "colour and depth, both with the test";
  EXPECT_EQ(middle_pixel(), lean);
}

TEST_F(LeanPrograms, ARefusedShaderLeavesTheModelAndSaysWhy) {
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(textured())), Status::kOk);
  calls_->spoil_shaders();
  EXPECT_EQ(model.upload(renderer_, *DrawnAsset(textured(200))), Status::kDriver);
  EXPECT_STRNE(renderer_.failure(), "");
  HeadDraw direction = at_rest();
  direction.component = Component::kDirection;
  calls_->forget();
  EXPECT_EQ(draw_head(renderer_, model, direction), Status::kDriver);
  EXPECT_EQ(calls_->draws, 0);
  EXPECT_EQ(draw_head(renderer_, model, at_rest()), Status::kOk) << "what was built before still draws";
  EXPECT_EQ(calls_->draws, 1);
  model.destroy();
}

// Passes that no texel can be in are not drawn.

/// One card for each alpha, each the whole of a texel.
AssetContents cards_of(const std::vector<int>& alphas) {
  std::vector<DrawnCard> cards(alphas.size());
  for (std::size_t i = 0; i < cards.size(); ++i) cards[i].rgba = {255, 0, 0, std::uint8_t(alphas[i])};
  return card_contents(cards);
}

class LeanPasses : public CountedGlTest {
 protected:
  int draws_of(const AssetContents& contents, const HeadDraw& desc = at_rest()) {
    calls_->forget();
    draw(contents, desc);
    return calls_->draws;
  }
  int draws_of(const AssetContents& contents, const std::function<void(MaterialRecord&)>& change) {
    AssetContents changed = contents;
    change(changed.material[0]);
    return draws_of(changed);
  }
};

// The made-up material is opaque from 0.9 (230 of 255) on and drops what is below 0.1 (25).
TEST_F(LeanPasses, AlphaOfTheTextureSaysWhichPassesAreDrawn) {
  EXPECT_EQ(draws_of(cards_of({255, 0})), 4) << "everything between occurs between two texels";
  EXPECT_EQ(draws_of(cards_of({255})), 1) << "opaque";
  EXPECT_EQ(draws_of(cards_of({255, 231})), 1) << "opaque";
  EXPECT_EQ(draws_of(cards_of({200})), 3) << "both blended passes and depth";
  EXPECT_EQ(draws_of(cards_of({100})), 2) << "too faint for depth";
  EXPECT_EQ(draws_of(cards_of({200, 240})), 4);
  EXPECT_EQ(draws_of(cards_of({20, 0})), 0) << "nobody sees it";
}

TEST_F(LeanPasses, EveryMipCounts) {
  AssetContents contents = cards_of({255, 255});
  TextureRecord& base = contents.textures[0];
  ASSERT_EQ(base.role, TextureRole::kBaseColor);
  contents.textures.resize(1);
  contents.texels.assign(12, std::byte{255});
  base.mip_count = 2;
  base.bytes = 12;
  EXPECT_EQ(draws_of(contents), 1);
  contents.texels.back() = std::byte{128};
  EXPECT_EQ(draws_of(contents), 4);
}

TEST_F(LeanPasses, MaterialSaysWhichPassesAreDrawn) {
  const AssetContents faint = cards_of({200, 100});
  ASSERT_EQ(draws_of(faint), 3);
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.opaque_threshold = 0; }), 1) << "all of it counts as opaque";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.opaque_threshold = 0.5f; }), 3) << "opaque and both blended";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.discard_threshold = 1; }), 0) << "nothing is left";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.flags = 0; }), 2) << "no back faces";
  EXPECT_EQ(draws_of(faint, [](auto& m) { m.base_color[3] = 0.5f; }), 2) << "too faint for depth";
  EXPECT_EQ(draws_of(cards_of({255}), [](auto& m) { m.base_color[3] = 0.8f; }), 3) << "no longer opaque";
}

TEST_F(LeanPasses, HairWithoutTextureHasTheMaterialsAlpha) {
  AssetContents contents = cards_of({255});
  contents.textures.clear();
  contents.texels.clear();
  EXPECT_EQ(draws_of(contents), 1);
  EXPECT_TRUE(near(middle_pixel(), {255, 255, 255, 255}));
  EXPECT_EQ(draws_of(contents, [](auto& m) { m.base_color[3] = 0.8f; }), 3);
}

TEST_F(LeanPasses, TheMaterialOfTheCallDecides) {
  MaterialRecord all_opaque = plain_material();
  all_opaque.opaque_threshold = 0;
  HeadDraw desc = at_rest();
  desc.material = &all_opaque;
  EXPECT_EQ(draws_of(cards_of({255, 0}), desc), 1);
  EXPECT_EQ(middle_pixel()[3], 255);
}

TEST_F(LeanPasses, WithoutTransparencyThereIsAtMostOne) {
  HeadDraw desc = at_rest();
  desc.transparency = &kOpaqueMode;
  EXPECT_EQ(draws_of(cards_of({255, 0}), desc), 1);
  EXPECT_EQ(draws_of(cards_of({200}), desc), 0) << "all of it is cut away";
}

TEST_F(LeanPasses, UndrawnPassesWouldHaveChangedNothing) {
  for (const int alpha : {255, 231, 200, 128, 100, 20}) {
    // Below, a card of alpha 0 and one of 255, beside the view, let all values occur, so nothing is left out.
    AssetContents all = cards_of({alpha, 255, 0});
    for (std::size_t i = 4; i < all.vertices.size(); ++i) all.vertices[i].position[0] += 5;
    clear({0, 0, 255, 255});
    ASSERT_EQ(draws_of(all), 4);
    const Pixel expected = middle_pixel();
    clear({0, 0, 255, 255});
    ASSERT_LT(draws_of(cards_of({alpha})), 4);
    EXPECT_EQ(middle_pixel(), expected) << alpha;
  }
}

}  // namespace coif::lean_programs_test
