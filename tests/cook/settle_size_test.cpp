// Unit and up axis by what a model shows: heads of hair made here, at every scale, with everything that a file may say.

#include "cook/size/settle_size.h"
#include "cook/built_models.h"
#include "cook/fitted_wig.h"
#include "cook/recipe/recipe.h"
#include "cook/size/evidence.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>
#include <tuple>
#include <vector>

namespace coif::cook::settle_size_test {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// Hair around a head of 0.1 m at (0, 1.6, 0), open towards +Z, with tails of half a metre; a node in the head, no
/// body.
importer::SourceModel long_hair() {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  add_node(model, "Head", 0, {0, 1.52, 0});
  const std::uint32_t wig = add_node(model, "wig", 1, {0, 1.52, 0});
  importer::SourceMesh hair = make_cap(24, 12, 1.5f * std::numbers::pi_v<float>);  // from +X by +Z and -X to -Z
  for (Vector3f& p : hair.positions)
    p = Vector3f(Eigen::AngleAxisf(-0.75f * std::numbers::pi_v<float>, Vector3f::UnitY()) *
                 (p - Vector3f(0, 1.6f, 0))) +
        Vector3f(0, 1.6f, 0);
  hair.node = wig;
  model.meshes.push_back(hair);
  for (const double degrees : {120.0, 150.0, 180.0, 210.0, 240.0}) {
    model.meshes.push_back(make_tail(degrees, 0.5f));
    model.meshes.back().node = wig;
  }
  for (importer::SourceMesh& mesh : model.meshes) mesh.name = "hair";
  return model;
}

/// The same on a ball that follows the head, above joints of a body.
importer::SourceModel styled_person() {
  importer::SourceModel model = long_hair();
  const std::uint32_t hips = add_node(model, "Hips", 0, {0, 0.95, 0});
  add_node(model, "Neck", hips, {0, 1.45, 0});
  for (const double side : {-0.1, 0.1}) add_node(model, "Foot", hips, {side, 0.08, 0});
  importer::SourceMesh face = make_cap(16, 12, 2 * std::numbers::pi_v<float>, 0.095f);
  for (Vector3f& p : face.positions) {  // what hung down closes the ball
    if (p.y() < 1.6f) p = {0.5f * p.x(), std::max(p.y(), 1.51f), 0.5f * p.z()};
  }
  face.name = "face";
  face.node = 1;
  model.meshes.push_back(face);
  return model;
}

importer::SourceModel at_scale(importer::SourceModel model, double scale, importer::Statement unit,
                               double metres_per_unit = 1) {
  model = settled(std::move(model), {scale, Eigen::Matrix3d::Identity(), {}, {}});
  model.space.unit = model.space.up = unit;
  model.space.metres_per_unit = metres_per_unit;
  return model;
}

importer::SourceModel turned(importer::SourceModel model, std::size_t up, importer::Statement said) {
  model = settled(std::move(model), {1, y_up_from_direction(up).transpose(), {}, {}});
  model.space.up = model.space.unit = said;
  return model;
}

bool doubts(const JudgedSize& size, SizeDoubt::Of of) {
  return std::ranges::any_of(size.doubts, [&](const SizeDoubt& doubt) { return doubt.of == of; });
}

JudgedSize judge(const importer::SourceModel& model) { return judge_size(model, default_recipe()); }

class EveryStatement : public testing::TestWithParam<std::tuple<importer::Statement, double>> {
 protected:
  [[nodiscard]] importer::Statement said() const { return std::get<0>(GetParam()); }
  [[nodiscard]] double metres_per_unit() const { return std::get<1>(GetParam()); }
};

const char* const kNames[] = {"Declared", "UsualCentimetres", "UsualMetres", "Unsaid"};

INSTANTIATE_TEST_SUITE_P(Size, EveryStatement,
                         testing::Values(std::tuple{importer::Statement::kDeclared, 1.0},
                                         std::tuple{importer::Statement::kUsual, 0.01},
                                         std::tuple{importer::Statement::kUsual, 1.0},
                                         std::tuple{importer::Statement::kUnsaid, 1.0}),
                         [](const auto& statement) { return kNames[statement.index]; });

TEST_P(EveryStatement, AHeadOfTheRightSizeIsLeftAlone) {
  for (const importer::SourceModel& model : {long_hair(), styled_person()}) {
    const JudgedSize size = judge(at_scale(model, 1, said(), metres_per_unit()));
    EXPECT_FALSE(size.changes());
    EXPECT_TRUE(size.doubts.empty()) << size.doubts.front().text;
  }
}

TEST_P(EveryStatement, SmallAndLargeHeadsKeepTheirSizeWhereAFileSaysIt) {
  // A doll, a child, a chibi, a giant; without a unit there is only what is usual.
  const std::vector<double> usual{0.75, 1.6}, kept{0.3, 0.5, 1.5, 2.0, 3.0};
  for (const double scale : said() == importer::Statement::kUnsaid ? usual : kept) {
    EXPECT_FALSE(judge(at_scale(long_hair(), scale, said(), metres_per_unit())).changes()) << scale;
  }
}

TEST_P(EveryStatement, AWrongPowerOfTenIsFoundAndTold) {
  for (const double scale : {0.01, 0.1, 10.0, 100.0}) {
    const importer::SourceModel model = at_scale(long_hair(), scale, said(), metres_per_unit());
    const JudgedSize size = judge(model);
    EXPECT_NEAR(size.factor * scale, 1, 1e-9) << scale;
    ASSERT_TRUE(doubts(size, SizeDoubt::Of::kOtherUnit)) << scale;
    EXPECT_NE(size.doubts[0].text.find("\"source.metres_per_unit\""), std::string::npos) << "the cure";
    EXPECT_NE(size.doubts[0].text.find("usually"), std::string::npos) << "the evidence";
    EXPECT_FALSE(judge(settled(model, size)).changes()) << "judged again it is right";
  }
}

TEST_P(EveryStatement, AnotherAxisUpIsFoundByTheSkeleton) {
  for (const std::size_t up : {1u, 2u}) {
    const JudgedSize size = judge(turned(styled_person(), up, said()));
    EXPECT_TRUE((size.rotation * up_direction(up)).isApprox(Vector3d::UnitY()))
        << up << ": " << size.decisions.at(0).text();
    EXPECT_TRUE(doubts(size, SizeDoubt::Of::kOtherUp)) << up;
    EXPECT_EQ(size.factor, 1) << up;
  }
}

TEST_P(EveryStatement, AnotherAxisUpIsFoundByLongHairAlone) {
  importer::SourceModel model = long_hair();
  model.nodes[1].name = "part";
  const JudgedSize size = judge(turned(model, 1, said()));
  EXPECT_TRUE((size.rotation * Vector3d::UnitZ()).isApprox(Vector3d::UnitY()));
}

TEST(JudgedSizes, WhatTheCallerGaveHoldsAndIsDoubted) {
  for (const double scale : {0.01, 100.0}) {
    const JudgedSize size = judge(at_scale(styled_person(), scale, importer::Statement::kGiven));
    EXPECT_FALSE(size.changes()) << scale;
    ASSERT_TRUE(doubts(size, SizeDoubt::Of::kDoubtfulUnit)) << scale;
    EXPECT_NE(size.doubts[0].text.find("the recipe's \"source.metres_per_unit\""), std::string::npos);
  }
  const JudgedSize size = judge(turned(styled_person(), 1, importer::Statement::kGiven));
  EXPECT_FALSE(size.changes());
  EXPECT_TRUE(doubts(size, SizeDoubt::Of::kDoubtfulUp));
  EXPECT_TRUE(judge(styled_person()).doubts.empty()) << "and not where all is well";
}

TEST(JudgedSizes, AFileThatNearlyLosesIsDoubted) {
  // A head of 1.5 cm: a doll's, or a person's in the wrong unit. The format's definition holds, narrowly.
  const JudgedSize size = judge(at_scale(long_hair(), 0.15, importer::Statement::kDeclared));
  EXPECT_FALSE(size.changes());
  EXPECT_TRUE(doubts(size, SizeDoubt::Of::kDoubtfulUnit));
}

TEST(JudgedSizes, AConvertersWordCountsLess) {
  importer::SourceModel model = at_scale(long_hair(), 0.14, importer::Statement::kDeclared);
  EXPECT_FALSE(judge(model).changes());
  model.space.generator = "Open Asset Import Library (assimp v5.2.0)";
  EXPECT_EQ(judge(model).factor, 10);
}

TEST(JudgedSizes, LengthsInTheRecipeSpeakForTheModelAsItIs) {
  Recipe recipe = default_recipe();
  const importer::SourceModel model = at_scale(long_hair(), 0.1, importer::Statement::kUsual);
  EXPECT_EQ(judge_size(model, recipe).factor, 10);
  recipe.head_center = {0, 0.16, 0};
  recipe.head_radii = {0.01, 0.01, 0.01};
  EXPECT_FALSE(judge_size(model, recipe).changes());
}

TEST(JudgedSizes, AScalpTellsAUnitOfItsOwnWhereTheFileSaysNone) {
  importer::SourceModel model = long_hair();
  model.scalp_radius = 0.1;
  EXPECT_EQ(judge(at_scale(model, 100, importer::Statement::kUnsaid)).factor, 0.01)
      << "a usual one is taken where it fits";
  const JudgedSize strange = judge(at_scale(model, 300, importer::Statement::kUnsaid));
  EXPECT_DOUBLE_EQ(strange.factor, 0.0032) << "0.095 m over 30, to two digits";
  EXPECT_TRUE(doubts(strange, SizeDoubt::Of::kOtherUnit));
  EXPECT_FALSE(judge(at_scale(model, 1.6, importer::Statement::kUnsaid)).changes()) << "a large head";
  EXPECT_NE(judge(at_scale(model, 3, importer::Statement::kDeclared)).factor, 0.32) << "the file has a unit";
  model.scalp_radius = 0;
  EXPECT_NE(judge(at_scale(model, 300, importer::Statement::kUnsaid)).factor, 0.0032)
      << "the hair alone tells powers of ten";
}

TEST(JudgedSizes, BrowsAloneAreNoHead) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  for (const float side : {-0.035f, 0.035f}) {
    model.meshes.push_back(
        make_strip({.root = {side - 0.02f, 1.6f, 0.1f}, .along = {0.04f, 0, 0}, .across = {0, 0.008f, 0}}));
    model.meshes.back().name = "eyebrow";
  }
  for (const importer::Statement said :
       {importer::Statement::kDeclared, importer::Statement::kUsual, importer::Statement::kUnsaid}) {
    const JudgedSize size = judge(at_scale(model, 1, said));
    EXPECT_FALSE(size.changes());
    EXPECT_TRUE(size.doubts.empty()) << size.doubts.front().text;
  }
  EXPECT_EQ(judge(at_scale(model, 100, importer::Statement::kUnsaid)).factor, 0.01);
}

TEST(JudgedSizes, WhatSaysNothingForAnotherAxisIsNotDoubted) {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  for (const float size : {0.1f, 1.0f}) {
    importer::SourceMesh card;
    card.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    card.triangles = {0, 1, 2};
    model.meshes = {card};
    model.space.unit = model.space.up = importer::Statement::kUnsaid;
    const JudgedSize judged = judge(model);
    EXPECT_FALSE(judged.changes());
    for (const SizeDoubt& doubt : judged.doubts) ADD_FAILURE() << doubt.text;
  }
}

TEST(JudgedSizes, NothingToMeasureChangesNothing) {
  importer::SourceModel model;
  EXPECT_FALSE(judge(model).changes());
  model.space.unit = model.space.up = importer::Statement::kUnsaid;
  EXPECT_FALSE(judge(model).changes());
}

TEST(JudgedSizes, SettlingMovesEverything) {
  importer::SourceModel model = styled_person();
  model.colliders.push_back({});
  model.colliders[0].center = {0, 1.6, 0.1};
  model.colliders[0].radius = 0.1;
  model.springs.push_back({"tail", {{1, 0.2, 1, 0.5, -Vector3d::UnitY(), 0.5, 0.02}}, importer::kNoIndex, {0}});
  const importer::SourceModel other = settled(model, {10, y_up_from_direction(1), {}, {}});
  EXPECT_TRUE(other.nodes[1].model_from_node.translation().isApprox(Vector3d(0, 0, -15.2)));
  EXPECT_TRUE(other.meshes[0].positions[0].isApprox(Eigen::Matrix3f(10 * y_up_from_direction(1).cast<float>()) *
                                                    model.meshes[0].positions[0]));
  EXPECT_TRUE(other.colliders[0].center.isApprox(Vector3d(0, 1, -16)));
  EXPECT_DOUBLE_EQ(other.colliders[0].radius, 1);
  EXPECT_DOUBLE_EQ(other.springs[0].joints[0].length, 2);
  EXPECT_TRUE(other.springs[0].joints[0].gravity_direction.isApprox(Vector3d::UnitZ()));
  EXPECT_EQ(importer::find_model_fault(other), importer::find_model_fault(model));
}

}  // namespace coif::cook::settle_size_test
