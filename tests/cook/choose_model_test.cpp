// Which model moves which chain.

#include "cook/dynamics/choose_model.h"

#include "cook/recipe/hair_preset.h"
#include "cook/recipe/recipe.h"
#include "cook/told.h"
#include "cook/vrm_chain.h"
#include "lab/rig.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <vector>

namespace coif::cook::choose_model_test {

Recipe recipe_with(DynamicsModel model = DynamicsModel::kAuto) {
  Recipe recipe = default_recipe();
  recipe.dynamics_model = model;
  return recipe;
}

/// All bones by one source.
SaidMotion said_by(MotionSource source, const AssetContents& contents) {
  SaidMotion said{.records = contents.dynamics, .sources = {}, .presets = {}, .damping_ratios = {}};
  for (const BoneRecord& bone : contents.bones) {
    said.sources.push_back(bone.kind == BoneKind::kSimulated ? source : MotionSource::kRigid);
    said.presets.push_back(&preset_of(default_recipe()));
    said.damping_ratios.push_back(preset_of(default_recipe()).damping_ratio);
  }
  return said;
}

Told<ModelChoice> chosen(const AssetContents& contents, MotionSource source = MotionSource::kCurve,
                         DynamicsModel model = DynamicsModel::kAuto, unsigned threads = 1) {
  return told([&](Findings& findings) {
    return choose_models(recipe_with(model), said_by(source, contents), contents, threads, findings);
  });
}

AssetContents soft() {
  return rig_of_chain({.bones = 5, .length = 0.4f, .stiffness = 60, .damping_ratio = 0.23f}).contents();
}

/// One of `bones` of equal length down from the head, without numbers.
void add_limp(TestRig& rig, int bones, float length, const Vec3& joint) {
  rig.add_strand(bones, {.joint = joint,
                         .rest_direction = {0, -1, 0},
                         .length = length / float(bones),
                         .friction = 0.5f,
                         .stiffness = 0,
                         .damping = 0,
                         .torsion = kShortestArc});
}

AssetContents strand(int bones, float length) {
  TestRig rig;
  add_limp(rig, bones, length, {0, 0.05f, -0.1f});
  return rig.contents();
}

TEST(ChooseModels, SoftHairThatACascadeWouldAmplifyIsPassive) {
  const auto choice = chosen(soft());
  EXPECT_EQ(choice.made.models, std::vector{ChainModel::kPassive});
  EXPECT_TRUE(choice.made.ill_posed.empty());
  ASSERT_EQ(choice.notes.size(), 1u);
  EXPECT_NE(choice.notes[0].find("passive model"), std::string::npos) << choice.notes[0];
  EXPECT_NE(choice.notes[0].find("tumble"), std::string::npos) << "and says what went wrong: " << choice.notes[0];
  EXPECT_EQ(chosen(soft(), MotionSource::kCurve, DynamicsModel::kAuto, 3).notes, choice.notes);
}

TEST(ChooseModels, HairWithOneMotionAsACascadeStaysOne) {
  const auto choice = chosen(rig_of_chain({.bones = 3, .length = 0.3f, .damping_ratio = 1}).contents());
  EXPECT_EQ(choice.made.models, std::vector{ChainModel::kCascade});
  EXPECT_TRUE(choice.made.ill_posed.empty());
  EXPECT_TRUE(choice.notes.empty());
}

TEST(ChooseModels, WhatIsTooStiffToBeCheckedStaysACascadeAndIsToBeConditioned) {
  const auto choice =
      chosen(rig_of_chain({.bones = 16, .length = 0.6f, .stiffness = 4000, .damping_ratio = 0.3f}).contents());
  EXPECT_EQ(choice.made.models, std::vector{ChainModel::kCascade});
  ASSERT_EQ(choice.made.ill_posed.size(), 1u);
  EXPECT_FALSE(choice.made.ill_posed[0].finding.is_good);
}

TEST(ChooseModels, ARecipesWordStands) {
  const auto cascade = chosen(soft(), MotionSource::kCurve, DynamicsModel::kCascade);
  EXPECT_EQ(cascade.made.models, std::vector{ChainModel::kCascade});
  EXPECT_EQ(cascade.made.ill_posed.size(), 1u) << "and is conditioned";
  const auto passive = chosen(rig_of_chain({.bones = 3, .length = 0.3f, .damping_ratio = 1}).contents(),
                              MotionSource::kCurve, DynamicsModel::kPassive);
  EXPECT_EQ(passive.made.models, std::vector{ChainModel::kPassive});
}

TEST(ChooseModels, OfAPresetLongHairIsPassiveAndABoneAloneNeedNotBe) {
  EXPECT_EQ(chosen(strand(5, 0.4f), MotionSource::kPreset).made.models, std::vector{ChainModel::kPassive});
  const auto one = chosen(strand(1, 0.05f), MotionSource::kPreset);
  EXPECT_EQ(one.made.models, std::vector{ChainModel::kCascade}) << "there it moves alike";
  ASSERT_EQ(one.notes.size(), 1u);
  EXPECT_NE(one.notes[0].find("costs less"), std::string::npos) << one.notes[0];
  EXPECT_EQ(chosen(strand(1, 0.05f), MotionSource::kPreset, DynamicsModel::kCascade).made.models,
            std::vector{ChainModel::kCascade});
}

TEST(ChooseModels, EachChainGetsItsOwn) {
  TestRig rig;
  add_limp(rig, 1, 0.05f, {0, 0.05f, 0.1f});
  add_limp(rig, 5, 0.4f, {0, 0.05f, -0.1f});
  const AssetContents contents = rig.contents();
  ASSERT_EQ(contents.chains.size(), 2u);
  const auto choice = chosen(contents, MotionSource::kPreset);
  EXPECT_EQ(choice.made.models, (std::vector{ChainModel::kCascade, ChainModel::kPassive}));
}

TEST(SettleModel, GivesEachChainItsOwnPreset) {
  TestRig rig;
  for (const float side : {-0.05f, 0.05f}) add_limp(rig, 2, 0.2f, {side, 0.05f, -0.1f});
  AssetContents contents = rig.contents();
  SaidMotion said = said_by(MotionSource::kPreset, contents);
  Recipe stiff = default_recipe();
  stiff.dynamics_preset = "stiff";
  for (const std::size_t bone : {3u, 4u}) said.presets[bone] = &preset_of(stiff);
  const auto settled = told([&](Findings& findings) {
    settle_model(recipe_with(), said, std::vector(2, ChainModel::kPassive), contents, findings);
    return 0;
  });
  EXPECT_GT(contents.dynamics[3].stiffness, 5 * contents.dynamics[1].stiffness);
  EXPECT_EQ(settled.notes.size(), 2u) << "one for each preset";
}

TEST(ModelsByRule, AreAsTheRecipeSaysElsePassiveForPresets) {
  const AssetContents contents = strand(2, 0.2f);
  const auto rule = [&](DynamicsModel model, MotionSource source) {
    return models_by_rule(recipe_with(model), said_by(source, contents), contents)[0];
  };
  EXPECT_EQ(rule(DynamicsModel::kAuto, MotionSource::kPreset), ChainModel::kPassive);
  EXPECT_EQ(rule(DynamicsModel::kAuto, MotionSource::kCurve), ChainModel::kCascade);
  EXPECT_EQ(rule(DynamicsModel::kAuto, MotionSource::kSpring), ChainModel::kCascade);
  EXPECT_EQ(rule(DynamicsModel::kPassive, MotionSource::kSpring), ChainModel::kPassive);
  EXPECT_EQ(rule(DynamicsModel::kCascade, MotionSource::kPreset), ChainModel::kCascade);
}

TEST(SettleModel, KeepsWhatIsSaidOfContacts) {
  AssetContents contents = strand(3, 0.3f);
  for (DynamicsRecord& bone : contents.dynamics) bone.hit_radius = 0.01f;
  const SaidMotion said = said_by(MotionSource::kPreset, strand(3, 0.3f));
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    AssetContents settled = contents;
    settle_model(recipe_with(), said, std::vector{model}, settled, unheard());
    EXPECT_EQ(settled.chains[0].model, model);
    EXPECT_EQ(settled.dynamics[1].hit_radius, 0.01f);
    EXPECT_GT(settled.dynamics[1].stiffness, 0);
  }
}

}  // namespace coif::cook::choose_model_test
