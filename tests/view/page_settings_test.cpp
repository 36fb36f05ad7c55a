#include "view/page/view_settings.h"

#include "base/json.h"
#include "cook/recipe/recipe_keys.h"
#include "models/drawn_card.h"
#include "view/page/held_head.h"
#include "view/page/tunable_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace coif::view::page_settings_test {

const Asset& some_asset() {
  static const DrawnAsset asset(card_contents(std::array{DrawnCard{}}));
  return *asset;
}

nlohmann::json controls() { return nlohmann::json::parse(controls_json(some_asset())); }

nlohmann::json control(const std::string& name) {
  const nlohmann::json all = controls();
  const auto found = std::ranges::find_if(all, [&](const auto& row) { return row["name"] == name; });
  return found != all.end() ? *found : nlohmann::json();
}

std::vector<std::string> words_of(const nlohmann::json& row, const char* key = "words") {
  std::istringstream text(row[key].get<std::string>());
  std::vector<std::string> words;
  for (std::string word; std::getline(text, word, '|');) words.push_back(word);
  return words;
}

TEST(ControlTable, HasEachSettingOnceAndNoNameTwice) {
  std::set<std::string> names;
  std::vector<int> covered(kViewSettings, 0);
  for (const auto& row : controls()) {
    EXPECT_TRUE(names.insert(row["name"]).second) << row["name"];
    for (std::size_t i = 0; i < row["count"]; ++i) ++covered.at(row["at"].get<std::size_t>() + i);
    EXPECT_LE(row["low"], row["high"]) << row["name"];
  }
  EXPECT_EQ(covered, std::vector<int>(kViewSettings, 1));
}

TEST(ControlTable, RecipesKnowItsKeysWordsAndRanges) {
  int keys = 0;
  for (const auto& row : controls()) {
    if (row["recipe"] == "") continue;
    ++keys;
    const auto known = cook::recipe_keys();
    const auto key = std::ranges::find_if(known, [&](const cook::RecipeKey& k) { return k.path() == row["recipe"]; });
    ASSERT_NE(key, known.end()) << row["recipe"];
    if (row["kind"] != "choice") {
      EXPECT_GE(row["low"].get<double>(), key->low - 1e-6) << row["recipe"];
      EXPECT_LE(row["high"].get<double>(), key->high + 1e-6) << row["recipe"];
      continue;
    }
    const std::string allowed = std::string("|") + key->choices + "|";
    for (const std::string& word : words_of(row, row["recipe_words"] != "" ? "recipe_words" : "words")) {
      EXPECT_NE(allowed.find("|" + word + "|"), std::string::npos) << row["recipe"] << ": " << word;
    }
  }
  EXPECT_GT(keys, 10);
}

TEST(ControlTable, PresetsAreThoseOfRecipes) {
  const auto words = words_of(control("preset"));
  const auto presets = cook::hair_presets();
  ASSERT_EQ(words.size(), presets.size() + 1);
  for (std::size_t i = 0; i < presets.size(); ++i) {
    ViewSettings settings;
    settings.preset = float(i) + 1;
    EXPECT_EQ(words[i + 1], presets[i].name);
    EXPECT_EQ(tuning_between({}, settings).preset, &presets[i]);
  }
}

TEST(ControlTable, WordsAreWhatTheyChoose) {
  ViewSettings settings;
  const auto modes = words_of(control("transparency"));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    settings.transparency = float(i);
    EXPECT_EQ(name_of(transparency_of(settings)), modes[i]);
  }
  const auto shadows = words_of(control("shadows"));
  ASSERT_EQ(shadows[0], "none");
  for (std::size_t i = 1; i < shadows.size(); ++i) {
    settings.shadows = float(i);
    EXPECT_EQ(name_of(*shadows_of(settings)), shadows[i]);
  }
  const auto solvers = words_of(control("solver")), beside = words_of(control("beside"));
  EXPECT_EQ(std::vector<std::string>(beside.begin() + 1, beside.end()), solvers) << "one number more, for none";
  EXPECT_EQ(&solver_of(float(std::ranges::find(solvers, "thesis") - solvers.begin())), &kThesisSolver);
  EXPECT_EQ(&solver_of(float(std::ranges::find(solvers, "passive") - solvers.begin())), &kPassiveSolver);
}

TEST(ControlTable, MotionsMoveHeadsAsTheyAreCalled) {
  const auto words = words_of(control("motion"));
  for (const motion::MotionInfo& motion : motion::all_motions()) {
    const auto at = float(std::ranges::find(words, motion.name) - words.begin());
    EXPECT_EQ(chosen_path(at)->pose(0.7).position[2], motion::head_pose(motion.motion, 0.7).position[2]) << motion.name;
  }
  const auto down = chosen_path(float(std::ranges::find(words, "look-down") - words.begin()));
  EXPECT_GT(down->pose(2).rotation.x, 0.3f) << "and stays there";
  for (const float number : {-1.0f, 1e9f, float(NAN)}) EXPECT_NE(chosen_path(number), nullptr);
}

TEST(PageSettings, NumbersOutOfRangeChooseSomething) {
  ViewSettings settings;
  for (const float number : {-1.0f, 1e9f, float(NAN)}) {
    settings.transparency = settings.shadows = settings.component = number;
    EXPECT_EQ(&transparency_of(settings), &kBlendMode);
    EXPECT_EQ(component_of(settings), Component::kAll);
    EXPECT_EQ(&solver_of(number), &kCoifSolver);
    (void)shadows_of(settings);
  }
}

TEST(PageSettings, UntouchedOnesAreTheAssetsOwnMaterialToTheBit) {
  AssetContents contents = card_contents(std::array{DrawnCard{}});
  contents.material[0].shading = ShadingModel::kMarschner;
  contents.material[0].tilt = 0.0517f;
  contents.material[0].roughness = 0.1399f;
  contents.material[0].scatter = 0.77f;
  contents.material[0].light_cut = 0.25f;
  const DrawnAsset asset(contents);
  const MaterialRecord material = material_of(*asset, settings_of(*asset));
  EXPECT_EQ(std::memcmp(&material, (*asset).material(), sizeof material), 0);
}

TEST(PageSettings, ChangesReachTheMaterialInItsUnits) {
  ViewSettings settings = settings_of(some_asset());
  settings.shading = 2;
  settings.tilt = 5;
  settings.roughness = 10;
  settings.base_color[1] = 0.5f;
  settings.primary_exponent = 77;
  const MaterialRecord material = material_of(some_asset(), settings);
  EXPECT_EQ(material.shading, ShadingModel::kMarschner);
  EXPECT_NEAR(material.tilt, 0.0872665f, 1e-6);
  EXPECT_NEAR(material.roughness, 0.174533f, 1e-6);
  EXPECT_EQ(material.base_color[1], 0.5f * some_asset().material()->base_color[1]);
  EXPECT_EQ(material.primary_exponent, 77);
}

TEST(PageSettings, ATintThatIsCookedCountsOnce) {
  ViewSettings settings = settings_of(some_asset());
  settings.base_color[0] = settings.cooked_color[0] = 0.5f;
  settings.base_color[1] = settings.cooked_color[1] = 0;  // nothing brings back what was cooked away
  settings.base_color[2] = 0.25f;
  settings.cooked_color[2] = 0.5f;
  const float* const own = some_asset().material()->base_color;
  const MaterialRecord material = material_of(some_asset(), settings);
  EXPECT_EQ(material.base_color[0], own[0]);
  EXPECT_EQ(material.base_color[1], 0);
  EXPECT_EQ(material.base_color[2], 0.5f * own[2]) << "what was changed since is shown at once";
}

TEST(HeldHead, FollowsTheHandWithoutOvershootingAndComesBackToRest) {
  HeldHead head;
  HeadPose pose;
  pose.position[1] = 1.5;
  head.grab();
  head.drag({0.2, 0, 0});
  head.turn({0, 1, 0}, 0.5);
  double farthest = 0;
  for (int i = 0; i < 120; ++i) {
    head.step(1.0 / 60);
    farthest = std::max(farthest, head.offset().x());
  }
  EXPECT_NEAR(head.offset().x(), 0.2, 1e-3);
  EXPECT_LE(farthest, 0.2 + 1e-9);
  const HeadPose moved = head.moved(pose);
  EXPECT_NEAR(moved.position[0], 0.2, 1e-3);
  EXPECT_NEAR(moved.rotation.y, std::sin(0.25), 1e-3);
  head.release();
  for (int i = 0; i < 300; ++i) head.step(1.0 / 60);
  EXPECT_TRUE(head.is_at_rest());
  EXPECT_EQ(head.offset().norm(), 0) << "to the bit, or hair would never fall asleep";
  EXPECT_EQ(head.moved(pose).position[1], 1.5);
}

TEST(HeldHead, PathIsTheSameAtEveryFrameRate) {
  const auto after = [](double rate) {
    HeldHead head;
    head.grab();
    head.drag({0.3, -0.1, 0});
    for (int i = 0; i < int(rate / 10); ++i) head.step(1 / rate);
    return head.offset();
  };
  EXPECT_NEAR((after(20) - after(240)).norm(), 0, 1e-9);
}

}  // namespace coif::view::page_settings_test
