#include "grow/grow_hair.h"

#include "cook/recipe/recipe.h"
#include "grow/body_surface.h"
#include "grow/head_frame.h"
#include "grow/round_bodies.h"
#include "grow/strand_paths.h"
#include "mannequin/head_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::grow::grow_hair_test {

using Eigen::Vector3f;

cook::Recipe recipe_of(const std::string& keys) {
  const auto recipe = cook::parse_recipe("{\"grow\": " + keys + "}", "test");
  EXPECT_TRUE(recipe) << (recipe ? "" : recipe.error().message);
  return recipe.value_or(cook::default_recipe());
}

groom::Groom grown(const std::string& keys, unsigned threads = 2) {
  static const importer::SourceModel body = sample_body();
  const auto groom = grow_from(recipe_of(keys), body, "test", threads);
  EXPECT_TRUE(groom) << (groom ? "" : groom.error().message);
  return groom ? *groom : groom::Groom{};
}

float length_of(std::span<const Vector3f> strand) {
  float length = 0;
  for (std::size_t k = 1; k < strand.size(); ++k) length += (strand[k] - strand[k - 1]).norm();
  return length;
}

/// The sample's skull, face towards +Z.
Vector3f direction_of(const Vector3f& point) {
  return (point - mannequin::kCraniumCenter.cast<float>())
      .cwiseQuotient(mannequin::kCraniumRadii.cast<float>())
      .normalized();
}

/// Metres from the bust's triangles, negative inside.
float away_from_skin(const Vector3f& point) {
  static const grow::BodySurface skin = [] {
    importer::SourceMesh mesh = sample_body().meshes[0];
    return grow::BodySurface(std::move(mesh.positions), std::move(mesh.triangles));
  }();
  const float away = skin.distance(point, 10);
  return skin.is_inside(point) ? -away : away;
}

class EveryStyle : public testing::TestWithParam<const char*> {};

TEST_P(EveryStyle, BeginsOnTheSkinAndNeverPassesThroughIt) {
  const groom::Groom groom = grown(std::string("{\"strands\": 400, \"style\": \"") + GetParam() + "\"}");
  EXPECT_EQ(groom::find_groom_fault(groom), "");
  EXPECT_EQ(groom.strand_count(), 400u);
  EXPECT_TRUE(groom.root_first);
  EXPECT_EQ(groom.widths.size(), groom.points.size());
  EXPECT_EQ(groom.colors.size(), groom.points.size());
  float deepest = 1;
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    const auto strand = groom.strand(i);
    EXPECT_NEAR(away_from_skin(strand[0]), 0, 0.0015);
    for (std::size_t k = 1; k < strand.size(); ++k) {
      // Between points, too.
      if (k > 1) deepest = std::min(deepest, away_from_skin(0.5f * (strand[k] + strand[k - 1])));
      deepest = std::min(deepest, away_from_skin(strand[k]));
    }
  }
  EXPECT_GT(deepest, -0.0003f) << "metres";
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, EveryStyle,
                         testing::Values("none", "bob", "fringe_bob", "locks", "long", "wavy", "curly", "coily", "afro",
                                         "short", "spiky", "slick", "ponytail"),
                         [](const auto& style) { return std::string(style.param); });

TEST(GrowHair, EveryStyleIsNamed) {
  std::string words = "none";
  for (const cook::BuiltInStyle& style : cook::built_in_styles()) {
    words += std::string("|") + style.name;
    EXPECT_EQ(recipe_of(std::string("{\"style\": \"") + style.name + "\"}").grow_style, style.name);
  }
  EXPECT_EQ(words, cook::kStyleWords);
}

TEST(GrowHair, KeysGoBeforeTheStylesOwn) {
  EXPECT_TRUE(recipe_of(R"({"style": "bob"})").grow_parting.has_value());
  EXPECT_FALSE(recipe_of(R"({"parting": null, "style": "bob"})").grow_parting.has_value());
  const auto chosen =
      cook::parse_recipe(R"({"grow": {"style": "bob", "curl_radius": 0.5e-2}})", "test", {"", "ponytail"});
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->grow_style, "ponytail");
  EXPECT_TRUE(chosen->grow_gather.has_value());
  EXPECT_EQ(chosen->grow_curl_radius, 0.005);
  const auto again = cook::parse_recipe(cook::print_recipe(*chosen), "printed");
  ASSERT_TRUE(again);
  EXPECT_EQ(cook::print_recipe(*again), cook::print_recipe(*chosen));
}

TEST(GrowHair, RepeatsOnAnyNumberOfThreadsAndDiffersBySeed) {
  const groom::Groom one = grown(R"({"style": "wavy", "strands": 200})", 1),
                     three = grown(R"({"style": "wavy", "strands": 200})", 3);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.widths, three.widths);
  EXPECT_EQ(one.colors, three.colors);
  EXPECT_NE(one.points, grown(R"({"style": "wavy", "strands": 200, "seed": 2})").points);
}

TEST(GrowHair, RootsKeepToTheHairline) {
  const cook::Recipe recipe = recipe_of(R"({"strands": 3000})");
  const groom::Groom groom = grown(R"({"strands": 3000})");
  std::size_t on_face = 0, at_back = 0;
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    const Vector3f root = direction_of(groom.strand(i)[0]);
    const float azimuth = grow::azimuth_of(root), elevation = grow::elevation_of(root);
    // The bust's frame is not quite this test's, and the line is steep at the temples.
    const float lowest = std::min(grow::hairline(recipe, azimuth - 3), grow::hairline(recipe, azimuth + 3));
    EXPECT_GT(elevation, lowest - 7);
    on_face += std::abs(azimuth) < 40 && elevation < 25 ? 1 : 0;
    at_back += std::abs(azimuth) > 140 && elevation < 0 ? 1 : 0;
  }
  EXPECT_EQ(on_face, 0u);
  EXPECT_GT(at_back, 150u);
}

TEST(GrowHair, TheHairlineIsOneSmoothLineWithTemplesAndSideburns) {
  const cook::Recipe recipe = recipe_of("{}");
  EXPECT_FLOAT_EQ(grow::hairline(recipe, 0), 40);
  EXPECT_FLOAT_EQ(grow::hairline(recipe, 55), 28);
  EXPECT_FLOAT_EQ(grow::hairline(recipe, 98), 2);
  EXPECT_FLOAT_EQ(grow::hairline(recipe, 180), -42);
  EXPECT_FLOAT_EQ(grow::hairline(recipe, 76), 2 - 18) << "before the ear";
  EXPECT_LT(grow::hairline(recipe, 115), -15) << "behind the ear";
  float bend = 0;
  for (float a = 0; a < 179; a += 0.5f) {
    EXPECT_FLOAT_EQ(grow::hairline(recipe, a), grow::hairline(recipe, -a));
    const float before = grow::hairline(recipe, a), here = grow::hairline(recipe, a + 0.5f),
                after = grow::hairline(recipe, a + 1);
    EXPECT_LT(std::abs(here - before), 2) << a << " degrees";
    bend = std::max(bend, std::abs(after - 2 * here + before));
  }
  EXPECT_LT(bend, 0.4f) << "no corners";
  const cook::Recipe without = recipe_of(R"({"hairline_sideburns": 0, "hairline_recess": 0})");
  EXPECT_NEAR(grow::hairline(without, 76), 2, 0.01f);
  EXPECT_LT(grow::hairline(without, 38), grow::hairline(recipe, 38));
}

TEST(GrowHair, HairAtTheHairlineIsShorterAndFiner) {
  const std::string keys = R"("strands": 4000, "length_random": 0, "flyaways": 0, "width": 0.0001)";
  const cook::Recipe recipe = recipe_of("{" + keys + "}");
  struct Mean {
    double length = 0, width = 0;
    std::size_t strands = 0;
  };
  const auto means = [&](const groom::Groom& groom, float from, float to) {
    Mean mean;
    for (std::size_t i = 0; i < groom.strand_count(); ++i) {
      const Vector3f root = direction_of(groom.strand(i)[0]);
      const float above = grow::elevation_of(root) - grow::hairline(recipe, grow::azimuth_of(root));
      if (above < from || above >= to) continue;
      mean.length += length_of(groom.strand(i));
      mean.width += groom.widths[std::size_t(groom.strand(i).data() - groom.points.data())];
      ++mean.strands;
    }
    mean.length /= double(mean.strands), mean.width /= double(mean.strands);
    return mean;
  };
  const groom::Groom wispy = grown("{" + keys + "}"), plain = grown("{" + keys + R"(, "hairline_wisps": 0})");
  const Mean line = means(wispy, -5, 4), inside = means(wispy, 20, 50);
  EXPECT_LT(line.length, 0.75 * inside.length);
  EXPECT_LT(line.width, 0.85 * inside.width);
  EXPECT_NEAR(means(plain, -5, 4).length, means(plain, 20, 50).length, 0.02);
  EXPECT_NEAR(means(plain, -5, 4).width, means(plain, 20, 50).width, 1e-8);
}

TEST(GrowHair, IsAsLongAsAskedAndCutLevel) {
  const groom::Groom plain =
      grown(R"({"strands": 300, "length_top": 0.2, "length_front": 0.2, "length_sides": 0.2, "length_back": 0.2,
    "length_random": 0, "clump": 0, "clump_children": 0, "frizz": 0, "flyaways": 0, "hairline_wisps": 0})");
  for (std::size_t i = 0; i < plain.strand_count(); ++i) EXPECT_NEAR(length_of(plain.strand(i)), 0.2f, 0.025f);
  const groom::Groom cut = grown(R"({"strands": 300, "cut": -1, "length_random": 0})");
  const double level = mannequin::kCraniumCenter.y() - mannequin::kCraniumRadii.y();
  for (std::size_t i = 0; i < cut.strand_count(); ++i) EXPECT_GT(cut.strand(i).back().y(), level - 0.01);
}

TEST(GrowHair, APartingSendsHairToItsSides) {
  const groom::Groom groom = grown(R"({"strands": 1500, "parting": 0, "flyaways": 0})");
  std::size_t on_top = 0, crossed = 0;
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    const Vector3f root = direction_of(groom.strand(i)[0]);
    if (!(root.z() > 0.1f && std::abs(root.x()) > 0.06f)) continue;
    ++on_top;
    crossed += root.x() * groom.strand(i).back().x() < 0 ? 1 : 0;
  }
  EXPECT_GT(on_top, 100u);
  EXPECT_LT(crossed, on_top / 50);
}

TEST(GrowHair, LiesCloseToTheSkull) {
  const groom::Groom groom = grown(R"({"style": "bob", "strands": 600, "flyaways": 0})");
  float farthest = 0;
  for (const Vector3f& p : groom.points) {
    if (direction_of(p).y() > 0.3f) farthest = std::max(farthest, away_from_skin(p));
  }
  EXPECT_LT(farthest, 0.035f) << "metres";
}

TEST(GrowHair, RootsAreDensestWhereHairLeavesThemToBothSides) {
  const groom::Groom groom = grown(R"({"strands": 6000, "parting": 0})");
  const auto between = [&](float from, float to) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < groom.strand_count(); ++i) {
      const Vector3f root = direction_of(groom.strand(i)[0]);
      count += root.z() > 0.1f && root.y() > 0.75f && std::abs(root.x()) >= from && std::abs(root.x()) < to ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(between(0, 0.04f), between(0.2f, 0.24f) * 3 / 2);
}

TEST(GrowHair, WavesOfALockGoTogetherAndGrowTowardsTheTips) {
  const std::string keys = R"("style": "wavy", "strands": 1200, "flyaways": 0, "frizz": 0)";
  const groom::Groom waved = grown("{" + keys + "}"), plain = grown("{" + keys + ", \"wave_height\": 0.00001}");
  ASSERT_EQ(waved.points.size(), plain.points.size());
  const auto shift = [&](std::size_t i, float t) {
    const auto k = std::size_t(t * float(waved.strand(i).size() - 1));
    return Vector3f(waved.strand(i)[k] - plain.strand(i)[k]);
  };
  float near_root = 0, near_tip = 0, alike = 0, any = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < waved.strand_count(); ++i) {
    near_root += shift(i, 0.15f).norm(), near_tip += shift(i, 0.85f).norm();
    for (std::size_t k = i + 1; k < waved.strand_count(); ++k) {
      if ((waved.strand(i)[0] - waved.strand(k)[0]).norm() > 0.004f) continue;
      ++pairs;
      alike += shift(i, 0.5f).dot(shift(k, 0.5f));
      any += shift(i, 0.5f).norm() * shift(k, 0.5f).norm();
    }
  }
  EXPECT_GT(near_tip, 3 * near_root);
  ASSERT_GT(pairs, 100u);
  EXPECT_GT(alike, 0.4f * any);
}

TEST(GrowHair, FallsBeforeOrBehindTheShoulders) {
  const groom::Groom groom = grown(R"({"style": "long", "strands": 500, "flyaways": 0})");
  std::size_t over_the_end = 0;
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    const bool beyond = std::ranges::any_of(groom.strand(i), [](const Vector3f& p) { return std::abs(p.x()) > 0.19f; });
    over_the_end += beyond ? 1 : 0;
  }
  EXPECT_LT(over_the_end, groom.strand_count() / 50);
}

TEST(GrowHair, ATieHoldsEveryStrand) {
  const groom::Groom groom = grown(R"({"style": "ponytail", "strands": 300, "flyaways": 0})");
  // Behind the tie all hair is in one tail: no strand's tip is before the middle of the head.
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    EXPECT_LT(groom.strand(i).back().z(), mannequin::kCraniumCenter.z());
    EXPECT_LT(std::abs(groom.strand(i).back().x()), 0.06f);
  }
}

TEST(GrowHair, GrowsWithTheHeadWhereverThatIs) {
  importer::SourceModel large = sample_body();
  for (Vector3f& p : large.meshes[0].positions) p = 2 * p + Vector3f(1, -3, 0.5f);
  const auto groom = grow_from(recipe_of(R"({"style": "bob", "strands": 100})"), large, "test", 2);
  ASSERT_TRUE(groom);
  const groom::Groom usual = grown(R"({"style": "bob", "strands": 100})");
  double apart = 0;
  for (std::size_t i = 0; i < 100; ++i)
    apart += double((groom->strand(i)[0] - (2 * usual.strand(i)[0] + Vector3f(1, -3, 0.5f))).norm()) / 100;
  EXPECT_LT(apart, 0.003);
  EXPECT_NEAR(length_of(groom->strand(7)), 2 * length_of(usual.strand(7)), 0.05f);
}

TEST(GrowHair, TurnsWithABodyThatLooksBackwards) {
  importer::SourceModel turned = sample_body();
  for (Vector3f& p : turned.meshes[0].positions) p = Vector3f(-p.x(), p.y(), -p.z());
  turned.facing = importer::Facing::kBackwards;
  const auto groom = grow_from(recipe_of(R"({"style": "short", "strands": 50})"), turned, "test", 1);
  ASSERT_TRUE(groom);
  const groom::Groom usual = grown(R"({"style": "short", "strands": 50})");
  for (std::size_t i = 0; i < 50; ++i) {
    const Vector3f p = usual.strand(i)[0];
    EXPECT_LT((groom->strand(i)[0] - Vector3f(-p.x(), p.y(), -p.z())).norm(), 1e-3f);
  }
}

TEST(GrowHair, SaysWhyNothingGrows) {
  const importer::SourceModel plank = test::model_of(test::ellipsoid(Vector3f::Zero(), {1, 0.05f, 0.01f}));
  const auto headless = grow_from(cook::default_recipe(), plank, "a.recipe.json", 1);
  ASSERT_FALSE(headless);
  EXPECT_EQ(headless.error().kind, ToolError::Kind::kBadInput);
  EXPECT_TRUE(headless.error().message.starts_with("a.recipe.json: no head at the top of body.glb; say where"))
      << headless.error().message;
  const auto bald = grow_from(
      recipe_of(
          R"({"hairline_front": 90, "hairline_temples": 90, "hairline_sides": 90, "hairline_nape": 90, "hairline_fade": 0})"),
      sample_body(), "a.recipe.json", 1);
  ASSERT_FALSE(bald);
  EXPECT_NE(bald.error().message.find("leaves no room for hair"), std::string::npos) << bald.error().message;
}

}  // namespace coif::grow::grow_hair_test
