#include "view/page/asset_motion.h"
#include "cook/recipe/recipe.h"

#include "base/json.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/choose_model.h"
#include "models/test_rig.h"
#include "view/page/tunable_motion.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace coif::view::asset_motion_test {
namespace {

using Curve = std::vector<cook::CurvePoint>;

/// Two chains, of three and of two bones, that hang at a slant.
struct Hair {
  cook::Skeleton skeleton;
  AssetContents rig;
};

Hair slanted_hair(ChainModel model) {
  TestRig rig;
  rig.model = model;
  rig.add_strand(3, {.rest_direction = {0.6f, -0.8f, 0}, .length = 0.1f});
  rig.add_strand(2, {.joint = {0.1f, 0, 0}, .rest_direction = {0, -0.8f, 0.6f}, .length = 0.15f});
  Hair hair{{}, rig.contents()};
  hair.skeleton.bones.resize(6);
  hair.skeleton.bones[0].kind = BoneKind::kHead;
  for (std::uint32_t b = 1; b < 6; ++b) {
    cook::SkeletonBone& bone = hair.skeleton.bones[b];
    bone.kind = BoneKind::kSimulated;
    bone.parent = hair.rig.bones[b].parent;
    bone.chain = hair.rig.bones[b].chain;
    bone.tail = bone.start - Eigen::Vector3d(0, double(hair.rig.bones[b].length), 0);
    bone.place = b <= 3 ? b / 3.0 : (b - 3) / 2.0;
  }
  hair.skeleton.chains = {{1, 3, 0, {}}, {4, 2, 0, {}}};
  return hair;
}

/// What a cook without conditioning makes of it.
AssetContents cooked(const cook::Recipe& recipe, ChainModel model) {
  Hair hair = slanted_hair(model);
  cook::Findings unheard;
  const cook::SaidMotion said = cook::bake_dynamics(importer::SourceModel(), hair.skeleton, recipe, {}, unheard);
  hair.rig.dynamics = said.records;
  hair.rig.skeleton.air_lag = cook::air_lag(recipe, said);
  cook::settle_model(recipe, said, std::vector(2, model), hair.rig, unheard);
  return hair.rig;
}

cook::Recipe curve_recipe() {
  cook::Recipe recipe = cook::default_recipe();
  recipe.resistance = {{0, 0.3}, {1, 0.05}};
  return recipe;
}

AssetMotion motion_of(const AssetContents& contents) {
  const lab::OpenedAsset opened(contents);
  EXPECT_TRUE(opened.asset().is_open());
  return AssetMotion(opened.asset());
}

/// The recipe with what the page says to put in.
cook::Recipe with(const cook::Recipe& recipe, const AssetMotion& motion, const MotionTuning& tuning) {
  nlohmann::json all = nlohmann::json::parse(cook::print_recipe(recipe), nullptr, true, true);
  all["dynamics"].update(nlohmann::json::parse(motion.recipe(tuning)));
  const auto read = cook::parse_recipe(all.dump(), "tuned");
  EXPECT_TRUE(read) << read.error().message;
  return read ? *read : recipe;
}

void expect_alike(const std::vector<DynamicsRecord>& tuned, const std::vector<DynamicsRecord>& wanted) {
  ASSERT_EQ(tuned.size(), wanted.size());
  const auto near = [](float a, float b) { return std::abs(a - b) <= 1e-4f * std::abs(b) + 1e-6f; };
  for (std::size_t b = 1; b < tuned.size(); ++b) {
    EXPECT_PRED2(near, tuned[b].resistance, wanted[b].resistance) << b;
    EXPECT_PRED2(near, tuned[b].stiffness, wanted[b].stiffness) << b;
    EXPECT_PRED2(near, tuned[b].damping, wanted[b].damping) << b;
    EXPECT_PRED2(near, tuned[b].friction, wanted[b].friction) << b;
    EXPECT_PRED2(near, tuned[b].gravity_scale, wanted[b].gravity_scale) << b;
    EXPECT_PRED2(near, tuned[b].angle_limit, wanted[b].angle_limit) << b;
    for (int k = 0; k < 2; ++k) EXPECT_PRED2(near, tuned[b].lean[k], wanted[b].lean[k]) << b;
  }
}

struct Case {
  const char* name;
  cook::Recipe recipe;
  ChainModel model;
  MotionTuning tuning;
};

std::vector<Case> cases() {
  cook::Recipe damped = curve_recipe(), soft = curve_recipe(), preset = cook::default_recipe();
  damped.damping_ratio = 0.4;
  soft.resistance = {{0, 0.001}, {1, 0.0005}};  // made stiffer, to carry its shape
  const Curve low{{0, 0.2}, {0.5, 0.02}, {1, 0.01}}, ratios{{0, 0.9}, {1, 0.2}};
  const auto two = [](const Case& of) {
    Case passive = of;
    passive.model = ChainModel::kPassive;
    return std::vector{of, passive};
  };
  std::vector<Case> all;
  const auto add = [&](const char* name, const cook::Recipe& recipe, const MotionTuning& tuning) {
    for (const Case& each : two({name, recipe, ChainModel::kCascade, tuning})) all.push_back(each);
  };
  add("a resistance", curve_recipe(), {.resistance = low});
  add("a resistance beside a ratio", damped, {.resistance = low});
  add("a damping curve", curve_recipe(), {.damping_ratio = ratios});
  add("both", damped, {.resistance = low, .damping_ratio = ratios});
  add("liveliness", curve_recipe(), {.liveliness = 0.9});
  add("liveliness against a ratio", damped, {.liveliness = 0.9});
  add("weight", curve_recipe(), {.gravity_scale = 0.3});
  add("weight beside a ratio", damped, {.gravity_scale = 2});
  add("friction, air and limit", damped, {.friction = 7, .air_follow = 0.25, .angle_limit = 40});
  add("soft hair's friction", soft, {.friction = 3});
  add("soft hair's resistance", soft, {.resistance = low});
  add("a preset", preset, {.preset = &cook::hair_presets()[1]});
  add("a livelier preset", preset, {.preset = &cook::hair_presets()[4], .liveliness = 0.7});
  add("a preset's weight", preset, {.gravity_scale = 0.5});
  add("a preset's curve", preset, {.resistance = low, .damping_ratio = ratios});
  return all;
}

TEST(AssetMotion, TunedBonesAreThoseThatTheRecipeCooksTo) {
  for (const Case& each : cases()) {
    SCOPED_TRACE(std::string(each.name) + (each.model == ChainModel::kPassive ? ", passive" : ", cascade"));
    const AssetContents before = cooked(each.recipe, each.model);
    const AssetMotion motion = motion_of(before);
    const AssetContents after = cooked(with(each.recipe, motion, each.tuning), each.model);
    expect_alike(motion.tuned(each.tuning), after.dynamics);
    EXPECT_FLOAT_EQ(motion.air_lag(each.tuning), after.skeleton.air_lag);
    EXPECT_NE(
        std::memcmp(before.dynamics.data(), after.dynamics.data(), sizeof(DynamicsRecord) * after.dynamics.size()), 0);
  }
}

TEST(AssetMotion, UntunedBonesAreTheirOwnToTheBit) {
  for (const Case& each : cases()) {
    const AssetContents before = cooked(each.recipe, each.model);
    const AssetMotion motion = motion_of(before);
    const auto records = motion.tuned({});
    EXPECT_EQ(std::memcmp(records.data(), before.dynamics.data(), sizeof(DynamicsRecord) * records.size()), 0);
    EXPECT_EQ(motion.recipe({}), "{}");
  }
}

TEST(AssetMotion, FindsAgainWhatTheRecipeSaid) {
  cook::Recipe recipe = curve_recipe();
  recipe.damping_ratio = Curve{{0, 0.9}, {1, 0.3}};
  const auto json = nlohmann::json::parse(motion_of(cooked(recipe, ChainModel::kCascade)).json());
  EXPECT_EQ(json["resistance"]["points"], nlohmann::json::parse("[[0, 0.3], [1, 0.05]]"));
  EXPECT_EQ(json["damping_ratio"]["points"], nlohmann::json::parse("[[0, 0.9], [1, 0.3]]"));
  EXPECT_EQ(json["resistance"]["bones"].size(), 5u);
  EXPECT_EQ(json["preset"], false);
  for (const cook::HairPreset& preset : cook::hair_presets()) {
    cook::Recipe of_preset = cook::default_recipe();
    of_preset.dynamics_preset = preset.name;
    const AssetMotion motion = motion_of(cooked(of_preset, ChainModel::kPassive));
    EXPECT_EQ(motion.preset(), &preset) << preset.name;
    EXPECT_NEAR(motion.mean().liveliness, 1 - preset.damping_ratio, 1e-4) << preset.name;
  }
}

TEST(AssetMotion, HairOfSpringsIsTakenOverByCurves) {
  cook::Recipe recipe = curve_recipe();
  recipe.sags = true;
  recipe.air_follow = 0;
  const AssetMotion motion = motion_of(cooked(recipe, ChainModel::kCascade));
  const auto said = nlohmann::json::parse(motion.recipe({.friction = 4}));
  EXPECT_EQ(said["source"], "curves") << "a spring's friction is the file's";
  EXPECT_EQ(said["resistance"], nlohmann::json::parse("[[0, 0.3], [1, 0.05]]"));
  EXPECT_EQ(said["sags"], true);
  EXPECT_FALSE(nlohmann::json::parse(motion.recipe({.liveliness = 0.5})).contains("source"))
      << "which springs listen to, too";
}

TEST(AssetMotion, ConditionedHairKeepsWhatItWasGiven) {
  cook::Recipe recipe = curve_recipe();
  AssetContents contents = cooked(recipe, ChainModel::kCascade);
  for (const DynamicsRecord& record : contents.dynamics)
    contents.asked.push_back({record.friction, record.damping, record.parent_share});
  for (DynamicsRecord& record : contents.dynamics) record.damping += 5;
  const AssetMotion motion = motion_of(contents);
  const auto lively = cooked(with(recipe, motion, {.liveliness = 0.6}), ChainModel::kCascade);
  EXPECT_NEAR(motion.tuned({.liveliness = 0.6})[2].damping, lively.dynamics[2].damping + 5, 1e-3);
  EXPECT_EQ(nlohmann::json::parse(motion.json())["conditioned"], true);
}

TEST(AssetMotion, HairThatDoesNotMoveHasNothingToTune) {
  const AssetMotion none;
  EXPECT_TRUE(none.is_empty());
  EXPECT_TRUE(none.tuned({.friction = 1}).empty());
  EXPECT_EQ(none.recipe({.friction = 1}), "{}");
  EXPECT_EQ(nlohmann::json::parse(none.json())["moves"], false);
}

TEST(TunableMotion, WritesIntoTheAssetAndBack) {
  const AssetContents contents = cooked(curve_recipe(), ChainModel::kCascade);
  const lab::OpenedAsset opened(contents);
  const AssetMotion own(opened.asset());
  ViewSettings settings;
  settings.friction = 2;
  TunableMotion motion(own, settings);
  EXPECT_TRUE(motion.is_applied(settings));
  motion.set_resistance({{0, 0.5}});
  EXPECT_FALSE(motion.is_applied(settings));
  motion.apply(settings, opened.asset());
  EXPECT_TRUE(motion.is_applied(settings)) << "once";
  EXPECT_EQ(opened.asset().dynamics()[1].resistance, 0.5f);
  settings.air_follow = 0.25f;
  EXPECT_FALSE(motion.is_applied(settings));
  motion.apply(settings, opened.asset());
  EXPECT_EQ(opened.asset().skeleton().air_lag, 0.75f);
  settings.air_follow = 1;
  motion.set_resistance({});
  EXPECT_FALSE(motion.is_applied(settings));
  motion.apply(settings, opened.asset());
  EXPECT_EQ(std::memcmp(opened.asset().dynamics().data(), contents.dynamics.data(),
                        sizeof(DynamicsRecord) * contents.dynamics.size()),
            0);
  EXPECT_EQ(opened.asset().skeleton().air_lag, contents.skeleton.air_lag);
}

TEST(TunableMotion, WhatWasCookedIsNotTunedTwiceAndStaysInTheRecipe) {
  const AssetContents first = cooked(curve_recipe(), ChainModel::kCascade);
  const lab::OpenedAsset opened(first);
  ViewSettings settings;
  TunableMotion before(AssetMotion(opened.asset()), settings);
  before.set_resistance({{0, 0.4}, {1, 0.1}});
  const std::string recipe = before.recipe(settings);

  cook::Recipe next = curve_recipe();
  next.resistance = {{0, 0.4}, {1, 0.1}};
  const lab::OpenedAsset cooked_again(cooked(next, ChainModel::kCascade));
  TunableMotion after(AssetMotion(cooked_again.asset()), settings);
  after.go_on(before);
  after.accept(settings, true);
  EXPECT_TRUE(after.is_applied(settings));
  EXPECT_EQ(after.recipe(settings), recipe);

  TunableMotion untold(AssetMotion(cooked_again.asset()), settings);
  untold.go_on(TunableMotion(AssetMotion(opened.asset()), settings));
  untold.accept(settings, false);
  EXPECT_EQ(untold.recipe(settings), "{}") << "the file was changed, not the page";
}

TEST(ReducedCurve, KeepsStraightLinesAsTheirEnds) {
  EXPECT_TRUE(reduced_curve({}, 1, 6).empty());
  EXPECT_EQ(reduced_curve(Curve{{0.5, 0.25}}, 1, 6), (Curve{{0, 0.25}, {1, 0.25}}));
  const Curve line{{0.8, 0.14}, {0.2, 0.26}, {0.5, 0.2}};
  const Curve ends = reduced_curve(line, 0.5, 6);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0].value, 0.3, 1e-12);
  EXPECT_NEAR(ends[1].value, 0.1, 1e-12);
}

TEST(ReducedCurve, FollowsBentOnesWithFewPointsAndMeansWhereBonesDiffer) {
  Curve bent;
  for (int i = 0; i <= 40; ++i) bent.push_back({i / 40.0, 0.3 * std::exp(-i / 8.0)});
  const Curve few = reduced_curve(bent, 1.0 / 3, 6);
  EXPECT_LE(few.size(), 6u);
  for (const cook::CurvePoint& point : bent) {
    EXPECT_NEAR(std::cbrt(cook::evaluate_curve(few, point.at)), std::cbrt(point.value), 0.05) << point.at;
  }
  EXPECT_DOUBLE_EQ(reduced_curve(Curve{{0.5, 0.2}, {0.5, 0.4}}, 1, 6)[0].value, 0.3);
}

}  // namespace
}  // namespace coif::view::asset_motion_test
