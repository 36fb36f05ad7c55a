// The stages of a cook, each called alone.

#include "cook/stages/stages.h"
#include "cook/built_models.h"
#include "cook/cook.h"
#include "lab/rig.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::stages_test {

/// A recipe, and all that stages tell.
class Stages : public testing::Test {
 protected:
  Stages() { settings_.draft = true; }

  SourceHair hair_of(const importer::SourceModel& model) {
    auto hair = find_hair(model, recipe_, recipe_, settings_, log_);
    EXPECT_TRUE(hair) << (hair ? "" : hair.error().message);
    return hair ? std::move(*hair) : SourceHair{};
  }
  Strips strips_of(const importer::SourceModel& model) {
    SourceHair hair = hair_of(model);
    auto strips = find_strips(model, std::move(hair.mesh), hair.color, recipe_, recipe_, settings_, log_);
    EXPECT_TRUE(strips) << (strips ? "" : strips.error().message);
    return strips ? std::move(*strips) : Strips{};
  }
  std::vector<std::string> told_passes() const {
    std::vector<std::string> names;
    for (const PassTime& pass : report_.passes) names.push_back(pass.name);
    return names;
  }

  Recipe recipe_ = draft_of(default_recipe());
  CookSettings settings_;
  CookReport report_;
  CookLog log_{settings_, report_};
};

TEST_F(Stages, FindHairLeavesTheSourceAsItIs) {
  const importer::SourceModel wig = make_wig();
  const SourceHair hair = hair_of(wig);
  EXPECT_EQ(&hair.model(wig), &wig) << "it is in metres with Y up";
  EXPECT_EQ(hair.mesh.triangle_count(), wig.meshes[0].triangles.size() / 3);
  EXPECT_EQ(told_passes(), (std::vector<std::string>{"size", "select", "base color"}));
}

TEST_F(Stages, FindHairMakesMetres) {
  importer::SourceModel wig = make_wig();
  for (Eigen::Vector3f& at : wig.meshes[0].positions) at *= 100;
  for (importer::SourceNode& node : wig.nodes) node.model_from_node.translation() *= 100;
  wig.space.unit = importer::Statement::kUnsaid;
  const SourceHair hair = hair_of(wig);
  ASSERT_TRUE(hair.settled) << "hair of 30 m is in centimetres";
  EXPECT_NEAR(hair.mesh.positions[0].y(), wig.meshes[0].positions[0].y() / 100, 1e-5f);
}

TEST_F(Stages, FindStripsKnowsPatchesHeadAndStrands) {
  const Strips strips = strips_of(make_wig());
  EXPECT_EQ(strips.hair.patches.count, 1u);
  EXPECT_EQ(strips.head_bone.name, "Head");
  EXPECT_EQ(strips.hair.strands.place.size(), strips.hair.mesh.positions.size());
  EXPECT_TRUE(strips.listings.empty()) << "nobody asked for a list";
}

TEST_F(Stages, MakeRigNeedsNothingThatIsDrawn) {
  const importer::SourceModel wig = make_wig();
  Strips strips = strips_of(wig);
  strips.hair.mesh.uvs.clear();
  const auto rig = make_rig(wig, strips, recipe_, settings_, log_);
  ASSERT_TRUE(rig) << rig.error().message;
  EXPECT_EQ(rig->contents.chains.size(), 1u);
  EXPECT_EQ(rig->contents.bones.size(), rig->rig.skeleton.bones.size());
  EXPECT_TRUE(rig->contents.vertices.empty());
  EXPECT_TRUE(rig->contents.tuning.empty()) << "a draft is not tuned";
}

TEST_F(Stages, MakeRigSaysWhatItsRecipeLacks) {
  const importer::SourceModel wig = make_wig();
  recipe_.body_colliders.resize(1);
  recipe_.body_colliders[0].bone = "Chest";
  recipe_.body_colliders[0].radius = 0.1;
  const auto rig = make_rig(wig, strips_of(wig), recipe_, settings_, log_);
  ASSERT_FALSE(rig);
  EXPECT_EQ(rig.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(rig.error().message.find("Chest"), std::string::npos) << rig.error().message;
}

TEST_F(Stages, OneAfterAnotherTheyAreTheCook) {
  const importer::SourceModel wig = make_wig();
  SourceHair hair = hair_of(wig);
  auto strips = find_strips(wig, std::move(hair.mesh), hair.color, recipe_, recipe_, settings_, log_);
  ASSERT_TRUE(strips);
  auto rig = make_rig(wig, *strips, recipe_, settings_, log_);
  ASSERT_TRUE(rig);
  auto drawn =
      draw_hair(wig, std::move(hair.color), std::move(*strips), std::move(*rig), recipe_, recipe_, settings_, log_);
  ASSERT_TRUE(drawn);
  const auto asset = write_hair(wig.path, recipe_, drawn->contents, log_);
  ASSERT_TRUE(asset);

  Recipe same = default_recipe();
  same.scene_provenance = false;
  CookSettings whole;
  whole.draft = true;
  const auto cooked = cook(wig, same, whole);
  ASSERT_TRUE(cooked);
  std::vector<std::string> names;
  for (const PassTime& pass : cooked->report.passes) names.push_back(pass.name);
  EXPECT_EQ(told_passes(), names);
  EXPECT_EQ(report_.notes, cooked->report.notes);
  const lab::OpenedAsset by_hand(*asset), by_cook(cooked->asset);
  ASSERT_TRUE(by_hand.status());
  ASSERT_TRUE(by_cook.status());
  EXPECT_EQ(by_hand.asset().vertices().size(), by_cook.asset().vertices().size());
  EXPECT_TRUE(std::ranges::equal(by_hand.asset().indices(), by_cook.asset().indices()));
}

TEST_F(Stages, WriteHairRefusesWhatTheRuntimeWould) {
  const importer::SourceModel wig = make_wig();
  auto rig = make_rig(wig, strips_of(wig), recipe_, settings_, log_);
  ASSERT_TRUE(rig);
  rig->contents.bones[1].parent = 77;
  const auto asset = write_hair("there/wig.glb", recipe_, rig->contents, log_);
  ASSERT_FALSE(asset);
  EXPECT_EQ(asset.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(asset.error().message.find("there/wig.glb: the cooked asset is not valid"), std::string::npos)
      << asset.error().message;
}

}  // namespace coif::cook::stages_test
