#include "view/server/live_cook.h"
#include "cook/recipe/recipe.h"

#include "import/reader_process.h"
#include "platform/stop.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>

namespace coif::view::live_cook_test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* kTriangle = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n";

/// Cooks are noted, not made.
class LiveCookTest : public testing::Test {
 protected:
  LiveCookTest() {
    fs::create_directories(folder_);
    write("hair.obj", kTriangle);
  }
  ~LiveCookTest() override { fs::remove_all(folder_); }

  void write(const char* name, const std::string& text) const {
    const bool is_new = !fs::exists(folder_ / name);
    const auto before = is_new ? fs::file_time_type() : fs::last_write_time(folder_ / name);
    std::ofstream(folder_ / name) << text;
    if (!is_new) fs::last_write_time(folder_ / name, before + 1s);
  }

  LiveCooking cooking() {
    LiveCooking cooking;
    cooking.import_settings = [](const cook::Recipe& recipe, const std::vector<fs::path>& roots) {
      importer::ImportSettings settings;
      settings.roots = roots;
      if (recipe.metres_per_unit > 0) settings.metres_per_unit = recipe.metres_per_unit;
      return settings;
    };
    cooking.cook = [this](const LiveOrder& order, const std::stop_token& stop) -> tl::expected<LiveCooked, ToolError> {
      platform::throw_if_stopped(stop);
      LiveCooked cooked;
      importer::ImportOutcome model;
      if (order.model.empty()) {
        ++imports_;
        model = importer::import_model(order.source, order.import);
        if (!model) return tl::unexpected(model.error());
        cooked.model = importer::encode_model(model);
      } else if (!importer::decode_model(order.model, model)) {
        return failure(ToolError::Kind::kInternal, "not the model that was given");
      }
      width_ = model->meshes.at(0).positions[1].x();
      shift_ = order.recipe.primary_shift;
      cooked.result.asset.assign(model->meshes.at(0).triangles.size(), std::byte{});
      cooked.result.inputs.source_files = {folder_ / "hair.png"};
      return cooked;
    };
    cooking.cooked = [this](const LiveResult&) { ++cooked_; };
    cooking.failed = [this](const std::string& problem) { problem_ = problem; };
    return cooking;
  }

  void run(LiveCook& cook, bool is_obsolete = false) {
    std::stop_source stop;
    if (is_obsolete) stop.request_stop();
    cook.run(++number_, stop.get_token());
  }
  [[nodiscard]] nlohmann::json state() { return nlohmann::json::parse(state_.wait(0, 0ms).json); }

  fs::path folder_ = fs::temp_directory_path() / ("coif_live_cook_test." + std::to_string(getpid()));
  LiveState state_{"draft"};
  int imports_ = 0;
  float width_ = 0;
  double shift_ = 0;
  int cooked_ = 0;
  std::uint64_t number_ = 0;
  std::string problem_;
};

TEST_F(LiveCookTest, SlidersCookWithoutImportingAgain) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  run(cook);
  ASSERT_EQ(cooked_, 1) << problem_;
  ASSERT_TRUE(cook.change("{\"material\": {\"primary_shift\": 1.25}}"));
  fs::rename(folder_ / "hair.obj", folder_ / "away.obj");
  run(cook);
  EXPECT_EQ(cooked_, 2) << problem_;
  EXPECT_EQ(imports_, 1);
  EXPECT_EQ(shift_, 1.25);
  EXPECT_EQ(state()["revision"], 2);
  EXPECT_EQ(state()["changes"]["material"]["primary_shift"], 1.25);
  EXPECT_EQ(state_.asset()->bytes.size(), 3u);
}

TEST_F(LiveCookTest, ChangedSourcesAreImportedAgain) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  run(cook);
  EXPECT_FALSE(cook.files_changed());
  write("hair.obj", std::string(kTriangle) + "v 0.1 0.1 0\nf 2 4 3\n");
  EXPECT_TRUE(cook.files_changed());
  run(cook);
  EXPECT_EQ(state_.asset()->bytes.size(), 6u);

  write("hair.png", "appears, of which the source speaks");
  EXPECT_TRUE(cook.files_changed());
  EXPECT_FALSE(cook.files_changed());
}

TEST_F(LiveCookTest, UnitsOfTheRecipeImportAgain) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  run(cook);
  ASSERT_TRUE(cook.change("{\"source\": {\"metres_per_unit\": 2}}"));
  run(cook);
  ASSERT_EQ(cooked_, 2) << problem_;
  EXPECT_EQ(imports_, 2);
  EXPECT_FLOAT_EQ(width_, 0.2f);
}

TEST_F(LiveCookTest, RecipesBesideTheSourceAreFoundOnceTheyAppear) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  run(cook);
  const double by_default = shift_;
  write("hair.recipe.json", "{\"material\": {\"primary_shift\": 1.75}}");
  EXPECT_TRUE(cook.files_changed());
  run(cook);
  EXPECT_EQ(shift_, 1.75);
  EXPECT_EQ(state()["recipe_file"]["material"]["primary_shift"], 1.75);
  fs::remove(folder_ / "hair.recipe.json");
  EXPECT_TRUE(cook.files_changed());
  run(cook);
  EXPECT_EQ(shift_, by_default);
}

TEST_F(LiveCookTest, FailuresAreToldAndLoseNothing) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  run(cook);
  write("hair.obj", "no model");
  EXPECT_TRUE(cook.files_changed());
  run(cook);
  EXPECT_EQ(problem_, importer::import_model(folder_ / "hair.obj").error().message);
  EXPECT_EQ(state()["problem"], problem_);
  EXPECT_EQ(state()["revision"], 1);
  write("hair.obj", kTriangle);
  EXPECT_TRUE(cook.files_changed());
  run(cook);
  EXPECT_EQ(state()["problem"], "");
  EXPECT_EQ(state()["revision"], 2);
}

TEST_F(LiveCookTest, RefusedChangesAreNotKept) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  ASSERT_TRUE(cook.change("{\"material\": {\"primary_shift\": 1.25}}"));
  const auto refused = cook.change("{\"material\": {\"primary_shift\": 1e9}}");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            cook::parse_recipe("{\"material\": {\"primary_shift\": 1e9}}", "changes of the page").error().message);
  run(cook);
  EXPECT_EQ(shift_, 1.25);
}

TEST_F(LiveCookTest, ObsoleteWorkTellsNobody) {
  LiveCook cook(cooking(), folder_ / "hair.obj", {}, state_);
  run(cook, true);
  EXPECT_EQ(cooked_, 0);
  EXPECT_EQ(problem_, "");
  EXPECT_EQ(state()["revision"], 0);
  run(cook);
  EXPECT_EQ(cooked_, 1) << problem_;
}

TEST_F(LiveCookTest, OtherSourcesTakeThePlace) {
  LiveCook cook(cooking(), folder_ / "absent.obj", {}, state_);
  run(cook);
  EXPECT_NE(problem_.find("absent.obj: cannot open"), std::string::npos) << problem_;
  write("hair.recipe.json", "{\"material\": {\"primary_shift\": 1.75}}");
  cook.take_source(folder_ / "hair.obj", "dropped.obj");
  run(cook);
  EXPECT_EQ(cooked_, 1) << problem_;
  EXPECT_NE(shift_, 1.75) << "what lies beside it is not its recipe";
  EXPECT_EQ(state()["name"], "dropped.obj");
  cook.take_source(folder_ / "gone.obj", "their.obj");
  run(cook);
  EXPECT_TRUE(problem_.starts_with("their.obj: ")) << problem_;
}

}  // namespace
}  // namespace coif::view::live_cook_test
