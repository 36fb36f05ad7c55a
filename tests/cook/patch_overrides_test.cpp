

// The recipe's values for some patches alone.

#include "cook/built_models.h"
#include "cook/cook.h"
#include "cook/fitted_wig.h"
#include "cook/strands/choose_patches.h"
#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cook::patch_overrides_test {

using Numbers = std::vector<std::uint32_t>;

Recipe recipe_from(const std::string& text) {
  auto recipe = parse_recipe(text, "r.json");
  EXPECT_TRUE(recipe) << (recipe ? "" : recipe.error().message);
  return recipe ? *recipe : default_recipe();
}

std::string refusal_of(const std::string& text) {
  const auto recipe = parse_recipe(text, "r.json");
  return recipe ? "" : recipe.error().message;
}

/// Four tails around a head without bones, 0.4 m long: behind, right, in front and left, meshes "tail_0" to "tail_3",
/// the last two of another material, which shows another part of the texture.
importer::SourceModel four_tails() {
  importer::SourceModel model;
  model.path = "wig.glb";
  const std::uint32_t node = add_node(model, "Head", importer::kNoIndex, {0, 1.5, 0});
  for (std::uint32_t i = 0; i < 4; ++i) {
    importer::SourceMesh tail = make_tail(180 + 90.0 * i, 0.4f, 30);
    tail.name = "tail_" + std::to_string(i);
    tail.node = node;
    tail.material = i / 2;
    if (i >= 2) {
      for (Eigen::Vector2f& uv : tail.uvs) uv.x() = 0.5f + uv.x() / 4;
    }
    model.meshes.push_back(tail);
  }
  model.materials.resize(2);
  model.materials[0].name = "Brown";
  model.materials[1].name = "Blond";
  return model;
}

CookResult cooked(const importer::SourceModel& model, const std::string& recipe) {
  auto result = cook(model, recipe_from(recipe), {.threads = 1, .list_patches = true, .draft = true});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *result : CookResult{};
}

/// Which patches an override selects.
Numbers selected_by(const std::string& select) {
  Numbers numbers;
  for (const PatchListing& patch :
       cooked(four_tails(), R"({"patches": [{"select": )" + select + R"(, "root": "auto"}]})").patches.patches) {
    if (!patch.overrides.empty()) numbers.push_back(patch.number);
  }
  return numbers;
}

bool warns(const CookResult& result, const std::string& message) {
  const auto& warnings = result.report.warnings;
  return std::ranges::find(warnings, message, &Diagnostic::message) != warnings.end();
}

TEST(PatchOverrides, AreSelectedByWhatIsKnownOfAPatch) {
  EXPECT_EQ(selected_by(R"({"mesh": "TAIL_?"})"), (Numbers{0, 1, 2, 3}));
  EXPECT_EQ(selected_by(R"({"mesh": "*_1"})"), Numbers{1});
  EXPECT_EQ(selected_by(R"({"material": "blond"})"), (Numbers{2, 3}));
  EXPECT_EQ(selected_by(R"({"index": [3, 0]})"), (Numbers{0, 3}));
  EXPECT_EQ(selected_by(R"({"island": 1})"), (Numbers{2, 3})) << "they show another part of the texture";
  EXPECT_EQ(selected_by(R"({"box": [[-1, 0, -1], [1, 2, -0.05]]})"), Numbers{0}) << "behind";
  EXPECT_EQ(selected_by(R"({"near": [0, 1.3, 0.3]})"), Numbers{2}) << "in front, the nearest";
  EXPECT_EQ(selected_by(R"({"near": [0, 1.4, 0.105], "within": 0.14})"), Numbers{2});
  EXPECT_EQ(selected_by(R"({"near": [0, 1.4, 0.105], "within": 0.16})"), (Numbers{1, 2, 3})) << "at a right angle";
  EXPECT_EQ(selected_by(R"({"material": "blond", "index": [1, 2]})"), Numbers{2}) << "all that is said holds";
}

TEST(PatchOverrides, ThatSelectNothingAreRefused) {
  const auto result = cook(four_tails(), recipe_from(R"({"patches": [{"select": {"index": 4}, "keep": false}]})"), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ToolError::Kind::kBadInput);
  EXPECT_EQ(result.error().message,
            "wig.glb: recipe key \"patches.overrides\" [0] selects none of the 4 patches; 'coif cook "
            "wig.glb --list patches' lists them");
  const CookResult listed = cooked(four_tails(), R"({"patches": [{"select": {"index": 4}, "keep": false}]})");
  EXPECT_EQ(listed.patches.patches.size(), 4u) << "whoever looks for numbers gets them all the same";
  EXPECT_TRUE(warns(listed, "\"patches.overrides\" [0] selects none of the 4 patches"));
  const auto nothing =
      cook(four_tails(), recipe_from(R"({"patches": [{"select": {"mesh": "*"}, "keep": false}]})"), {});
  ASSERT_FALSE(nothing);
  EXPECT_NE(nothing.error().message.find("keeps no patch"), std::string::npos);
}

TEST(PatchOverrides, LeaveOutWhatIsNotKeptAndTheNumbersStay) {
  const CookResult result = cooked(four_tails(), R"({"patches": [{"select": {"mesh": "tail_1"}, "keep": false},
                                                                  {"select": {"index": 3}, "root": "auto"}]})");
  ASSERT_EQ(result.patches.patches.size(), 4u);
  EXPECT_FALSE(result.patches.patches[1].kept);
  EXPECT_EQ(result.patches.patches[3].overrides, Numbers{1});
  EXPECT_EQ(result.report.patches, 3u);
  EXPECT_EQ(result.report.triangles, 180u) << "60 of each tail";
  EXPECT_EQ(result.report.vertices, 3 * 62u) << "none is left of those that went";
  Numbers drawn = result.patches.number_of_place;
  std::ranges::sort(drawn);
  EXPECT_EQ(drawn, (Numbers{0, 2, 3}));
  EXPECT_TRUE(std::ranges::any_of(result.report.left_out,
                                  [](const LeftOut& part) { return part.what == "patch 1 (60 triangles)"; }));
}

TEST(PatchOverrides, ALaterOneHolds) {
  const CookResult result = cooked(four_tails(), R"({"patches": [{"select": {"mesh": "*"}, "keep": false},
                                                                  {"select": {"material": "Brown"}, "keep": true}]})");
  EXPECT_EQ(result.report.patches, 2u);
}

TEST(PatchOverrides, SayWhereTheRootsOfSomeAre) {
  const auto roots = [](const std::string& recipe) {
    std::vector<std::string> words;
    for (const PatchListing& patch : cooked(four_tails(), recipe).patches.patches) words.push_back(patch.root);
    return words;
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(roots("{}"), (Words{"low_v", "low_v", "low_v", "low_v"}));
  EXPECT_EQ(
      roots(R"({"patches": [{"select": {"index": 2}, "root": "high_v"}, {"select": {"index": 0}, "root": "low_u"}]})"),
      (Words{"low_u", "low_v", "high_v", "low_v"}));
  EXPECT_EQ(roots(R"({"patches": [{"select": {"index": 1}, "root": "swap"}]})"),
            (Words{"low_v", "high_v", "low_v", "low_v"}));
  EXPECT_EQ(
      roots(
          R"({"strands": {"root": "high_v"}, "patches": {"overrides": [{"select": {"index": 3}, "root": "low_v"}]}})"),
      (Words{"high_v", "high_v", "high_v", "low_v"}))
      << "what is said of one goes before what is said of all";
}

TEST(PatchOverrides, HoldPatchesToTheHead) {
  const CookResult free = cooked(four_tails(), "{}");
  const CookResult held = cooked(four_tails(), R"({"patches": [{"select": {"mesh": "tail_2"}, "chain": "none"}]})");
  EXPECT_EQ(free.report.chains, 4u);
  EXPECT_EQ(held.report.chains, 3u);
  for (const PatchListing& patch : held.patches.patches)
    EXPECT_EQ(patch.chain.empty(), patch.number == 2) << patch.number;
}

TEST(PatchOverrides, HoldPatchesThatTheFilesBonesMove) {
  importer::SourceModel model = make_wig();
  const CookResult held = cooked(model, R"({"patches": [{"select": {"index": 0}, "chain": "none"}]})");
  AlignedBytes file(held.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  for (const SkinRecord& skin : asset.skin()) EXPECT_EQ(skin.bone[0], 0u);
}

TEST(PatchOverrides, SayHowTheChainsOfSomeMove) {
  const CookResult result = cooked(four_tails(), R"({"dynamics": {"friction": 3}, "patches": [
      {"select": {"mesh": "tail_0"}, "resistance": [[0, 0.9], [1, 0.9]], "gravity_scale": 0.25},
      {"select": {"index": [0, 3]}, "friction": 7}]})");
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  std::size_t stiff = 0, rough = 0;
  for (std::size_t b = 1; b < asset.bones().size(); ++b) {
    const std::string name = asset.bone_name(std::uint32_t(b));
    const DynamicsRecord& bone = asset.dynamics()[b];
    const bool is_behind = name.starts_with("back"), is_left = name.starts_with("left");
    EXPECT_EQ(bone.resistance == 0.9f, is_behind) << name;
    EXPECT_EQ(bone.gravity_scale, is_behind ? 0.25f : 1.0f) << name;
    EXPECT_EQ(bone.friction, is_behind || is_left ? 7.0f : 3.0f) << name;
    stiff += is_behind ? 1 : 0;
    rough += is_left ? 1 : 0;
  }
  EXPECT_GT(stiff, 0u);
  EXPECT_GT(rough, 0u);
}

TEST(PatchOverrides, WarnOfMotionThatIsSaidInVain) {
  const CookResult result =
      cooked(four_tails(), R"({"patches": [{"select": {"index": 0}, "chain": "none", "friction": 7}]})");
  EXPECT_TRUE(warns(
      result, "\"patches.overrides\" [0] says how patches move, but they are not most of what any chain carries"));
}

TEST(PatchOverrides, AreRefusedWithTheirPlace) {
  const auto refused = [](const std::string& entry) { return refusal_of(R"({"patches": [)" + entry + "]}"); };
  EXPECT_NE(refused(R"({"keep": false})").find("\"patches.overrides\" [0]: wants an object with \"select\""),
            std::string::npos);
  EXPECT_NE(refused(R"({"select": {"index": 1}})").find("says nothing of the patches"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {}, "keep": true})").find("selects all patches; say which"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {"indx": 1}, "keep": true})").find("\"indx\" selects nothing"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {"within": 1}, "keep": true})").find("needs the point of \"near\""),
            std::string::npos);
  EXPECT_NE(refused(R"({"select": {"near": [0, 1]}, "keep": true})").find("a point [x, y, z]"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {"near": [0, 1, 1e9]}, "keep": true})").find("a point [x, y, z]"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {"box": [[1, 1, 1], [0, 2, 2]]}, "keep": true})").find("lowest corner first"),
            std::string::npos);
  EXPECT_NE(refused(R"({"select": {"index": []}, "keep": true})").find("at least one number"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {"index": 1}, "keep": 1})").find("\"keep\" wants true or false"), std::string::npos);
  EXPECT_NE(refused(R"({"select": {"index": 1}, "torsion": 1})").find("cannot be said of patches alone"),
            std::string::npos);
  EXPECT_NE(refused(R"({"select": {"index": 1}, "keep": true}, {"select": {"index": 1}, "friction": -1})")
                .find("[1]: \"friction\" wants a number from 0 to 10000"),
            std::string::npos);
}

TEST(PatchOverrides, PrintAndReadBack) {
  const std::string text = R"({"patches": [
    {"select": {"mesh": "a*", "material": "b", "index": [1, 2], "island": 0, "box": [[0, 0, 0], [1, 1, 1]], "near": [0, 1, 0],
                "within": 0.5}, "keep": true, "root": "swap", "chain": "none", "resistance": [[0, 0.5], [1, 0.1]], "friction": 3,
     "gravity_scale": -1, "preset": "wet", "liveliness": 0.25, "damping_ratio": 0.5, "angle_limit": 90, "parent_share": 0.25}]})";
  const Recipe recipe = recipe_from(text);
  const Recipe again = recipe_from(print_recipe(recipe));
  EXPECT_EQ(print_recipe(again), print_recipe(recipe));
  ASSERT_EQ(again.patch_overrides.size(), 1u);
  const PatchOverride& said = again.patch_overrides.front();
  EXPECT_EQ(said.select.indices, (Numbers{1, 2}));
  EXPECT_EQ(said.select.within, 0.5);
  EXPECT_EQ(said.root, "swap");
  EXPECT_EQ(said.resistance, (std::vector<CurvePoint>{{0, 0.5}, {1, 0.1}}));
  EXPECT_EQ(said.parent_share, 0.25);
  EXPECT_EQ(said.preset, "wet");
  EXPECT_EQ(said.liveliness, 0.25);
  EXPECT_EQ(said.damping_ratio, NumberOrCurve(0.5));
}

TEST(PatchOverrides, DampingMayBeACurve) {
  using Curve = std::vector<CurvePoint>;
  const Recipe recipe = recipe_from(R"({"dynamics": {"damping_ratio": 0.5},
    "patches": [{"select": {"index": 1}, "damping_ratio": [[0, 1], [1, 0.25]]}]})");
  ASSERT_EQ(recipe.patch_overrides.size(), 1u);
  EXPECT_EQ(recipe.patch_overrides[0].damping_ratio, NumberOrCurve(Curve{{0, 1}, {1, 0.25}}));
  EXPECT_EQ(print_recipe(recipe_from(print_recipe(recipe))), print_recipe(recipe));
  Recipe of_patch = recipe;
  recipe.patch_overrides[0].apply_motion(of_patch);
  EXPECT_EQ(of_patch.damping_ratio, NumberOrCurve(Curve{{0, 1}, {1, 0.25}}));
  EXPECT_NE(refusal_of(R"({"patches": [{"select": {"index": 1}, "damping_ratio": [[0, -1]]}]})")
                .find("\"damping_ratio\" wants points"),
            std::string::npos);
}

TEST(PatchListing, PartsOfACutPatchKeepItsNumber) {
  importer::SourceModel model;
  model.path = "cap.glb";
  const std::uint32_t node = add_node(model, "Head", importer::kNoIndex, {0, 1.5, 0});
  importer::SourceMesh tail = make_tail(180, 0.4f, 30), cap = make_cap(48, 12, 6.2f);
  for (importer::SourceMesh* mesh : {&tail, &cap}) {
    mesh->node = node;
    model.meshes.push_back(*mesh);
  }
  const CookResult result = cooked(model, "{}");
  ASSERT_EQ(result.patches.patches.size(), 2u);
  EXPECT_GT(result.report.patches, 3u) << "the cap is cut";
  for (const std::uint32_t number : result.patches.number_of_place) EXPECT_LT(number, 2u);
  EXPECT_EQ(std::ranges::count(result.patches.number_of_place, 0u), 1);
}

}  // namespace coif::cook::patch_overrides_test
