#include "cook/recipe/recipe.h"

#include "base/text.h"
#include "base/words.h"
#include "cook/recipe/recipe_keys.h"
#include "cook/recipe/recipe_keys_json.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

namespace coif::cook::recipe_test {

std::string message_of(const std::string& text) {
  const auto recipe = parse_recipe(text, "r.json");
  return recipe ? "" : recipe.error().message;
}

// Keys, defaults and ranges are what recipes that lie in a studio's store rely on.
TEST(Recipe, IsAsItWasPrinted) {
  std::ifstream file(COIF_GOLDEN_FOLDER "/recipe.json");
  const std::string kept(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(print_recipe(default_recipe()), kept) << "where that is meant: tests/golden/renew.sh BUILD_FOLDER";
}

TEST(Recipe, EveryDefaultIsWithinItsOwnRange) {
  for (const RecipeKey& key : recipe_keys()) {
    Recipe recipe;
    const auto outcome = read_value(key, nlohmann::json::parse(key.default_json), recipe);
    EXPECT_TRUE(outcome) << key.path() << ": " << (outcome ? "" : outcome.error());
    EXPECT_EQ(write_value(key, recipe), nlohmann::json::parse(key.default_json)) << key.path();
  }
  EXPECT_GE(recipe_keys().size(), 30u);
}

TEST(Recipe, KeysAreTheSameAsJson) {
  const auto all = nlohmann::json::parse(recipe_keys_json());
  ASSERT_EQ(all.size(), recipe_keys().size());
  std::map<std::string, nlohmann::json> by_path;
  for (const auto& key : all) by_path[key["path"]] = key;
  const auto kind = [&](const char* path) { return by_path.at(path)["kind"].get<std::string>(); };
  EXPECT_EQ(kind("scene.draw"), "switch");
  EXPECT_EQ(kind("dynamics.gravity_scale"), "number");
  EXPECT_EQ(kind("dynamics.torsion"), "number");
  EXPECT_EQ(by_path.at("dynamics.torsion")["default"], nullptr);
  EXPECT_EQ(kind("lods.levels"), "whole");
  EXPECT_EQ(kind("dynamics.model"), "choice");
  EXPECT_EQ(by_path.at("dynamics.model")["choices"], "auto|cascade|passive");
  for (const char* path :
       {"textures.shift", "hair.meshes", "dynamics.resistance", "dynamics.damping_ratio", "material.ambient"}) {
    EXPECT_EQ(kind(path), "other") << path;
  }
  for (const auto& [path, key] : by_path) {
    const bool is_number = key["kind"] == "number" || key["kind"] == "whole";
    EXPECT_TRUE(!is_number || key["low"] < key["high"]) << path;
  }
}

TEST(Recipe, EmptyObjectGivesTheDefaults) {
  const auto recipe = parse_recipe("{}", "r.json");
  ASSERT_TRUE(recipe);
  EXPECT_EQ(print_recipe(*recipe), print_recipe(default_recipe()));
}

TEST(Recipe, PrintedRecipeReadsBackWithEveryValue) {
  Recipe recipe = default_recipe();
  recipe.friction = 1.0 / 3;
  recipe.hair_meshes = {"hair*", "Zöpfe \"links\""};
  recipe.resistance = {{0, 0.5}, {0.25, 0.125}, {1, 0}};
  recipe.head_center = {0, 1.7, 0.01};
  recipe.head_radii = {0.08, 0.12, 0.1};
  recipe.texture_seed = 4294967295u;
  recipe.scene_names = false;
  const auto again = parse_recipe(print_recipe(recipe), "r.json");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(print_recipe(*again), print_recipe(recipe));
  EXPECT_EQ(again->friction, recipe.friction);
}

TEST(Recipe, TheDampingRatioIsANumberOrACurve) {
  const auto read = [](const std::string& value) {
    const auto recipe = parse_recipe(R"({"dynamics": {"damping_ratio": )" + value + "}}", "r.json");
    EXPECT_TRUE(recipe) << recipe.error().message;
    return recipe ? recipe->damping_ratio : std::nullopt;
  };
  using Curve = std::vector<CurvePoint>;
  EXPECT_EQ(read("null"), std::nullopt);
  EXPECT_EQ(read("0.3"), NumberOrCurve(0.3)) << "a number stays one, and the recipe's hash what it was";
  EXPECT_EQ(read("[[0, 0.5], [1, 0.1]]"), NumberOrCurve(Curve{{0, 0.5}, {1, 0.1}}));
  for (const char* value : {"0.3", "[[0.25, 10]]"}) {
    Recipe recipe = default_recipe();
    recipe.damping_ratio = read(value);
    const auto again = parse_recipe(print_recipe(recipe), "r.json");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->damping_ratio, recipe.damping_ratio);
  }
}

TEST(Recipe, ACurveOfDampingIsRefusedWithWhatItHasToBe) {
  const auto refused = [](const std::string& value) {
    return message_of(R"({"dynamics": {"damping_ratio": )" + value + "}}");
  };
  EXPECT_NE(refused("\"much\"").find("\"dynamics.damping_ratio\" wants a number from 0 to 10, or points"),
            std::string::npos);
  EXPECT_NE(refused("11").find("wants a number from 0 to 10"), std::string::npos);
  EXPECT_NE(refused("[]").find("wants at least one point"), std::string::npos);
  EXPECT_NE(refused("[[0, 11]]").find("value from 0 to 10] with ascending places, found [0,11]"), std::string::npos);
  EXPECT_NE(refused("[[0.5, 1], [0.5, 2]]").find("ascending places, found [0.5,2]"), std::string::npos);
  EXPECT_NE(refused("[[-0.1, 1]]").find("place 0..1"), std::string::npos);
}

TEST(Recipe, WhatCommentsSayMoreIsNotHashed) {
  const Recipe recipe = default_recipe();
  EXPECT_NE(print_recipe(recipe).find("one number, or points"), std::string::npos);
  EXPECT_EQ(canonical_recipe(recipe).find("one number, or points"), std::string::npos);
}

TEST(Recipe, TorsionIsANumberOrLeftToTheCooker) {
  EXPECT_FALSE(default_recipe().torsion);
  const auto given = parse_recipe(R"({"dynamics": {"torsion": 0}})", "r.json");
  ASSERT_TRUE(given) << given.error().message;
  EXPECT_EQ(given->torsion, 0.0) << "none goes back, which is not the same as left open";
  const auto again = parse_recipe(print_recipe(*given), "r.json");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->torsion, 0.0);
  EXPECT_FALSE(parse_recipe(R"({"dynamics": {"torsion": null}})", "r.json")->torsion);
  EXPECT_EQ(message_of(R"({"dynamics": {"torsion": 1e7}})"),
            "r.json: \"dynamics.torsion\" wants a number from 0 to 1000000 1/s, found 10000000.0");
}

TEST(Recipe, CommentsAreAllowed) {
  EXPECT_TRUE(parse_recipe("{ // mine\n \"dynamics\": {\"friction\": 3} }", "r.json"));
}

TEST(Recipe, UnknownKeyIsAnErrorWithASuggestion) {
  EXPECT_EQ(message_of(R"({"dynamics": {"resistence": []}})"),
            "r.json: \"dynamics.resistence\" is not a key; did you mean \"dynamics.resistance\"?");
  EXPECT_NE(message_of(R"({"nonsense": 3})").find("--print-recipe"), std::string::npos);
}

TEST(Recipe, ValuesOutOfRangeNameTheRange) {
  EXPECT_EQ(message_of(R"({"dynamics": {"friction": -1}})"),
            "r.json: \"dynamics.friction\" wants a number from 0 to 10000 1/s, found -1");
  EXPECT_NE(message_of(R"({"head": {"shape": "cube"}})").find("auto|ellipsoid|sphere|capsule|none"), std::string::npos);
  EXPECT_NE(message_of(R"({"textures": {"max_size": 1.5}})").find("whole number"), std::string::npos);
  EXPECT_NE(message_of(R"({"dynamics": {"resistance": [[0.5, 0.1], [0.5, 0.2]]}})").find("ascending"),
            std::string::npos);
  EXPECT_NE(message_of(R"({"dynamics": {"resistance": [[0, 1.5]]}})").find("from 0 to 1"), std::string::npos);
  EXPECT_EQ(message_of(R"({"scene": {"draw": 0}})"), "r.json: \"scene.draw\" wants true or false, found 0");
  EXPECT_NE(message_of(R"({"material": {"ambient": [1, 2]}})").find("3 numbers"), std::string::npos);
}

TEST(Recipe, BodyCollidersReadBackAsPrinted) {
  const std::string text = R"({"body": {"from_file": false, "colliders": [
    {"bone": "Hips", "radius": 0.1, "inside": true, "hair": ["braid*"]}, {"bone": "Chest", "normal": [0, 0, 1]},
    {"bone": "Arm", "center": [0, 1, 0], "tail": [0.3, 1, 0], "radius": 0.05, "tail_radius": 0.04}]}})";
  const auto recipe = parse_recipe(text, "r.json");
  ASSERT_TRUE(recipe) << recipe.error().message;
  EXPECT_FALSE(recipe->body_from_file);
  ASSERT_EQ(recipe->body_colliders.size(), 3u);
  EXPECT_EQ(recipe->body_colliders[2].tail_radius, 0.04);
  const auto again = parse_recipe(print_recipe(*recipe), "r.json");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(print_recipe(*again), print_recipe(*recipe));
}

TEST(Recipe, BodyCollidersThatDoNotHoldTogetherAreRefused) {
  const auto said = [](const std::string& entry) { return message_of(R"({"body": {"colliders": [)" + entry + "]}}"); };
  EXPECT_EQ(said(R"({"radius": 0.1})"), "r.json: \"body.colliders\" [0]: has no \"bone\"");
  EXPECT_NE(said(R"({"bone": "Hips"})").find("has no \"radius\""), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "radius": 0})").find("\"radius\" wants a number from 0.0001"), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "radius": 1, "offset": 1})").find("there are bone, center"), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "radius": 1, "tail_radius": 1})").find("no \"tail\""), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "normal": [0, 0, 0]})").find("without direction"), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "normal": [0, 0, 1], "radius": 1})").find("a plane"), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "radius": 1, "center": [1, 2]})").find("a point [x, y, z]"), std::string::npos);
  EXPECT_NE(said(R"({"bone": "Hips", "radius": 1, "hair": []})").find("names"), std::string::npos);
  EXPECT_NE(said("3").find("an object of bone"), std::string::npos);
  EXPECT_NE(message_of(R"({"body": {"colliders": {}}})").find("wants a list"), std::string::npos);
}

TEST(Recipe, LimitsReadBackAsPrintedAndSayWhatTheyLack) {
  const auto recipe = parse_recipe(R"({"dynamics": {"limits": [{"bones": "a*", "kind": "cone", "angle": 30},
    {"bones": ["b", "c"], "kind": "spherical", "angle": 180, "yaw": 90, "axis": [0, 0, 1]}, {"bones": "d", "kind": "none"}]}})",
                                   "r.json");
  ASSERT_TRUE(recipe) << recipe.error().message;
  const auto again = parse_recipe(print_recipe(*recipe), "r.json");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(print_recipe(*again), print_recipe(*recipe));
  ASSERT_EQ(again->limits.size(), 3u);
  EXPECT_EQ(again->limits[1].axis[2], 1);
  const auto said = [](const std::string& entry) { return message_of(R"({"dynamics": {"limits": [)" + entry + "]}}"); };
  EXPECT_NE(said(R"({"kind": "cone", "angle": 3})").find("[0]: has no \"bones\""), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "angle": 3})").find("has no \"kind\""), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "ball", "angle": 3})").find("cone|hinge|spherical|none"), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "cone"})").find("has no \"angle\""), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "cone", "angle": 181})").find("from 0 to 180 degrees"), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "hinge", "angle": 1, "yaw": 1})").find("belongs to a spherical"),
            std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "spherical", "angle": 1})").find("no \"yaw\""), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "none", "angle": 1})").find("is none"), std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "cone", "angle": 1, "axis": [0, 0, 0]})").find("a direction"),
            std::string::npos);
  EXPECT_NE(said(R"({"bones": "a", "kind": "cone", "angle": 1, "roll": 1})").find("there are bones"),
            std::string::npos);
}

TEST(Recipe, LinksAreAWordOrPairsOfNames) {
  EXPECT_EQ(default_recipe().links.word, "none");
  EXPECT_EQ(default_recipe().link_stretch, 0.1);
  EXPECT_EQ(default_recipe().link_shrink, 0.5);
  const auto again = [](const std::string& links) {
    const auto recipe = parse_recipe(R"({"dynamics": {"links": )" + links + "}}", "r.json");
    EXPECT_TRUE(recipe) << (recipe ? "" : recipe.error().message);
    return parse_recipe(recipe ? print_recipe(*recipe) : "", "r.json").value_or(default_recipe()).links;
  };
  EXPECT_EQ(again(R"("shared_strips")").word, "shared_strips");
  EXPECT_EQ(again("[]").word, "none");
  const RecipeLinks pairs = again(R"([["skirt_1", "skirt_2"], ["a*", "b?"]])");
  EXPECT_EQ(pairs.word, "");
  EXPECT_EQ(pairs.pairs, (std::vector<std::array<std::string, 2>>{{"skirt_1", "skirt_2"}, {"a*", "b?"}}));
  const auto said = [](const std::string& links) { return message_of(R"({"dynamics": {"links": )" + links + "}}"); };
  EXPECT_EQ(said(R"("all")"),
            "r.json: \"dynamics.links\" wants \"none\", \"shared_strips\" or a list of [\"bone of one chain\", \"bone "
            "of another\"],"
            " found \"all\"");
  EXPECT_EQ(said(R"([["a", "b"], ["a"]])"),
            "r.json: \"dynamics.links\" [1]: wants two names of bones, * and ? are wildcards, found [\"a\"]");
  EXPECT_NE(said(R"([["a", ""]])").find("two names"), std::string::npos);
  EXPECT_NE(said(R"([["a", 3]])").find("two names"), std::string::npos);
  EXPECT_NE(said("3").find("\"shared_strips\""), std::string::npos);
  EXPECT_EQ(message_of(R"({"dynamics": {"link_shrink": 1.5}})"),
            "r.json: \"dynamics.link_shrink\" wants a number from 0 to 1, found 1.5");
  EXPECT_NE(message_of(R"({"dynamics": {"link_stretch": -1}})").find("from 0 to 1"), std::string::npos);
}

TEST(Recipe, HalfAHeadIsRefused) {
  EXPECT_NE(message_of(R"({"head": {"center": [0, 1.6, 0]}})").find("come together"), std::string::npos);
}

TEST(Recipe, WhatIsNotJsonIsRefusedWithItsPlace) {
  EXPECT_NE(message_of("{\"hair\": ").find("r.json: not JSON: parse error at line 1"), std::string::npos);
  EXPECT_NE(message_of("[]").find("JSON object"), std::string::npos);
}

TEST(Recipe, EndlessNestingIsRefused) {
  const std::string deep = std::string(500'000, '[') + std::string(500'000, ']');
  for (const std::string& text : {deep, "{\"dynamics\": {\"friction\": " + deep + "}}", std::string(500'000, '[')}) {
    EXPECT_NE(message_of(text).find("nested more than 32 levels deep"), std::string::npos) << message_of(text);
  }
}

TEST(Recipe, RefusalsQuoteNoMoreThanABeginning) {
  const std::string long_text(1 << 19, 'x');
  for (const std::string& text : {"{\"" + long_text + "\": 1}", "{\"dynamics\": {\"friction\": \"" + long_text + "\"}}",
                                  long_text, "{\"dynamics\": {\"" + long_text + "\": 1}}"}) {
    EXPECT_FALSE(message_of(text).empty());
    EXPECT_LT(message_of(text).size(), 1000u);
  }
}

TEST(Recipe, AbsentFileIsAFileAccessError) {
  const auto recipe = read_recipe("/nowhere/r.json");
  ASSERT_FALSE(recipe);
  EXPECT_EQ(recipe.error().kind, ToolError::Kind::kFileAccess);
  EXPECT_EQ(recipe.error().message, "/nowhere/r.json: cannot open: No such file or directory");
}

TEST(NamePattern, KnowsStarsQuestionMarksAndEitherCase) {
  EXPECT_TRUE(matches("J_L_HairTail_03", "j_?_hair*_03"));
  EXPECT_TRUE(matches("", "*"));
  EXPECT_TRUE(matches("aXbXc", "a*b*c"));
  EXPECT_FALSE(matches("hair", "hai"));
  EXPECT_FALSE(matches("hair", "?hair"));
  EXPECT_FALSE(matches("abc", "a*d"));
}

TEST(NamePattern, ManyStarsStayFast) {
  // Exponential without a single point of return: the test would not end.
  EXPECT_FALSE(matches(std::string(5000, 'a'), std::string("*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*b")));
}

TEST(Recipe, ATextureIsAPathOrAFileWithAChannel) {
  const auto opacity_of = [](const std::string& json) {
    return parse_recipe(R"({"textures": {"opacity": )" + json + "}}", "r.json");
  };
  const auto path = opacity_of(R"("a.png")");
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(path->opacity_texture.file, "a.png");
  EXPECT_EQ(path->opacity_texture.channel, TextureChannel::kAuto);
  const auto chosen = opacity_of(R"({"file": "a.png", "channel": "g", "invert": true})");
  ASSERT_TRUE(chosen) << chosen.error().message;
  EXPECT_EQ(chosen->opacity_texture.channel, TextureChannel::kGreen);
  EXPECT_TRUE(chosen->opacity_texture.is_inverted);
  const auto again = parse_recipe(print_recipe(*chosen), "r.json");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->opacity_texture.channel, TextureChannel::kGreen);
  EXPECT_TRUE(again->opacity_texture.is_inverted);
  for (const char* wrong :
       {R"({"channel": "g"})", R"({"file": "a.png", "channel": "x"})", R"({"file": "a.png", "chanel": "g"})",
        R"({"file": 3})", "7", R"({"file": "a.png", "invert": 1})"}) {
    const auto refused = opacity_of(wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_NE(refused.error().message.find("\"textures.opacity\" wants a path, or {\"file\""), std::string::npos)
        << refused.error().message;
  }
}

TEST(Recipe, KeysOfLaterVersionsChangeNoHashUnlessTheySaySomething) {
  Recipe recipe = default_recipe();
  EXPECT_EQ(canonical_recipe(recipe).find("\"opacity\""), std::string::npos);
  EXPECT_NE(print_recipe(recipe).find("\"opacity\""), std::string::npos);
  recipe.opacity_texture.file = "a.png";
  EXPECT_NE(canonical_recipe(recipe).find("\"opacity\": \"a.png\""), std::string::npos);
}

}  // namespace coif::cook::recipe_test
