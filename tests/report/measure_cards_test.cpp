#include "report/cards/measure_cards.h"

#include "cards/made_up_groom.h"
#include "cards/make_cards.h"
#include "lab/rig.h"
#include "report/cards/asset_surface.h"
#include "report/cards_asset.h"
#include "report/made_up_report.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace coif::report::measure_cards_test {

constexpr float kWidth = 0.002f;
constexpr std::size_t kTriangles = 120;

CardsSettings quick() {
  CardsSettings settings;
  settings.budgets = {40, kTriangles};
  settings.directions = 5;
  settings.size = 64;
  settings.texels = std::size_t{1} << 15;
  settings.rounds = 1;
  settings.strand_width = kWidth;
  return settings;
}

/// A groom, an asset that holds what coif makes of it, and what there is to say of both. Making cards takes long.
class CardsReports : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    groom_ = std::make_unique<groom::Groom>(cards::test::groom_of(cards::test::strands_of_a_head(120)));
    groom_->path = "a.hair";
    CardsSettings settings = quick();
    const auto cards = cards::make_cards(*groom_, cards::shape_of(*groom_, kWidth),
                                         {kTriangles, settings.texels, settings.rounds, kWidth}, 2);
    if (!cards) throw std::runtime_error(cards.error().message);
    cards::CardSurface surface = cards::surface_of(*cards);
    cards::draw_as_cooked(surface);
    asset_ =
        std::make_unique<lab::OpenedAsset>(asset_of_surface(surface, {1, Eigen::Matrix3f::Identity(), {0, 0.1f, 0}}));
    settings.sheets = settings.ablation = true;
    auto report = measure(settings);
    if (!report) throw std::runtime_error(report.error().message);
    report_ = std::make_unique<CardsReport>(std::move(*report));
  }
  static void TearDownTestSuite() {
    groom_.reset();
    asset_.reset();
    report_.reset();
  }

  [[nodiscard]] static tl::expected<CardsReport, ToolError> measure(const CardsSettings& settings) {
    return measure_cards(asset_->asset(), *groom_, 0, settings, [](const std::string&) {});
  }

  static inline std::unique_ptr<groom::Groom> groom_;
  static inline std::unique_ptr<lab::OpenedAsset> asset_;
  static inline std::unique_ptr<CardsReport> report_;
};

TEST_F(CardsReports, HaveEachSetOfCardsFromEachDirection) {
  const CardsSettings settings = quick();
  EXPECT_TRUE(report_->left_out.empty());
  ASSERT_EQ(report_->summary.size(), 6u);
  std::set<std::tuple<std::string, std::uint64_t, std::array<double, 3>>> rows;
  for (const CardsRow& row : report_->rows) {
    rows.insert({row.baseline, row.triangles, row.direction});
    EXPECT_GT(row.coverage_iou, 0.1);
    EXPECT_LE(row.coverage_iou, 1);
    EXPECT_GT(row.psnr_db, 0);
    EXPECT_EQ(row.texels, settings.texels);
  }
  EXPECT_EQ(rows.size(), 3 * settings.budgets.size() * settings.directions);
  EXPECT_EQ(report_->rows.size(), rows.size());
  for (const CardsSummary& summary : report_->summary) {
    EXPECT_GT(summary.cards, 0u);
    EXPECT_LE(summary.made_triangles, summary.triangles);
    EXPECT_LE(summary.made_texels, summary.texels);
    EXPECT_LE(summary.figures.worst_iou, summary.figures.mean_iou);
    EXPECT_LE(summary.figures.worst_psnr_db, summary.figures.mean_psnr_db);
    EXPECT_GT(summary.figures.close_iou, 0.1);
    EXPECT_GT(summary.figures.close_error, 0);
    EXPECT_GE(summary.figures.layers, 1);
    EXPECT_GT(summary.figures.vertices, summary.made_triangles / 2);
    EXPECT_EQ(summary.segments.has_value(), summary.baseline == "even");
  }
}

TEST_F(CardsReports, TellWhatFitAndCapsBring) {
  const CardsSettings settings = quick();
  ASSERT_EQ(report_->ablation.size(), 3 * 2 * 2 * settings.budgets.size());
  std::set<std::tuple<std::string, std::uint64_t, bool, bool>> sets;
  for (const CardsAblation& one : report_->ablation) {
    sets.insert({one.baseline, one.triangles, one.fitted, one.caps});
    if (!one.fitted || !one.caps) continue;
    for (const CardsSummary& whole : report_->summary) {
      if (whole.baseline != one.baseline || whole.triangles != one.triangles) continue;
      EXPECT_EQ(one.figures.mean_error, whole.figures.mean_error) << "the whole set is the one of the summary";
      EXPECT_EQ(one.cards, whole.cards);
    }
  }
  EXPECT_EQ(sets.size(), report_->ablation.size());
}

TEST_F(CardsReports, TellWhatSharedTexturesBring) {
  for (const CardsSummary& summary : report_->summary) EXPECT_EQ(summary.textures, summary.cards) << summary.baseline;
  for (const CardsAblation& one : report_->ablation) EXPECT_FALSE(one.shared);
  CardsSettings settings = quick();
  settings.budgets = {kTriangles};
  settings.ablation = true;
  settings.rounds = 0;
  settings.caps = 0;
  settings.wisps = 4;
  const auto report = measure(settings);
  ASSERT_TRUE(report) << report.error().message;
  for (const CardsSummary& summary : report->summary) {
    EXPECT_EQ(summary.textures, 4u) << summary.baseline;
    EXPECT_GT(summary.cards, 4u);
  }
  std::map<std::string, std::set<double>> errors[2];
  for (const CardsAblation& one : report->ablation) errors[one.shared][one.baseline].insert(one.figures.mean_error);
  EXPECT_EQ(errors[true].size(), 3u);
  EXPECT_EQ(errors[false].size(), 3u);
  for (const auto& [baseline, shared] : errors[true]) EXPECT_NE(shared, errors[false][baseline]) << baseline;
}

TEST_F(CardsReports, HaveTheirPictures) {
  ASSERT_EQ(report_->sheets.size(), 4u) << "three sides and the textures";
  const nlohmann::ordered_json json = cards_json(made_up_heading(), *report_);
  ASSERT_EQ(json["sheets"].size(), 4u);
  for (const auto& sheet : json["sheets"]) {
    EXPECT_TRUE(sheet["png"].get<std::string>().starts_with("iVBORw0KGgo")) << "the PNG signature";
    EXPECT_NE(sheet["caption"], "");
  }
}

TEST_F(CardsReports, FindTheAssetAsNearAsTheCardsItIsMadeOf) {
  ASSERT_EQ(report_->asset.size(), 1u);
  const CardsSummary* own = nullptr;
  for (const CardsSummary& summary : report_->summary) {
    if (summary.baseline == "none" && summary.triangles == kTriangles) own = &summary;
  }
  ASSERT_NE(own, nullptr);
  EXPECT_EQ(report_->asset[0].triangles, own->made_triangles);
  EXPECT_NEAR(report_->asset[0].figures.mean_iou, own->figures.mean_iou, 0.003);
  EXPECT_NEAR(report_->asset[0].figures.mean_error, own->figures.mean_error, 0.01);
  EXPECT_NEAR(report_->asset[0].figures.fragments, own->figures.fragments, 0.01 * own->figures.fragments);
  EXPECT_FALSE(report_->is_its_source) << "nothing says what it was cooked from";
  EXPECT_NE(cards_method(*report_).find("another file"), std::string::npos);
}

TEST_F(CardsReports, HaveTheDocumentedKeys) {
  const nlohmann::ordered_json json = cards_json(made_up_heading(), *report_);
  EXPECT_EQ(keys_of(json["rows"][0]),
            (Keys{"triangles", "texels", "direction", "coverage_iou", "psnr_db", "baseline"}));
  EXPECT_EQ(json["rows"][0]["direction"].size(), 3u);
  const Keys figures{"mean_coverage_iou",  "worst_coverage_iou", "mean_psnr_db", "worst_psnr_db", "mean_error",
                     "close_coverage_iou", "close_error",        "vertices",     "fragments",     "layers"};
  Keys summary{"name",     "triangles",      "texels",      "baseline", "cards",
               "textures", "made_triangles", "made_texels", "segments"};
  summary.insert(summary.end(), figures.begin(), figures.end());
  summary.emplace_back("seconds");
  EXPECT_EQ(keys_of(json["summary"][0]), summary);
  Keys ablation{"name", "triangles", "baseline", "fitted", "caps", "shared", "cards"};
  ablation.insert(ablation.end(), figures.begin(), figures.end());
  ablation.emplace_back("seconds");
  EXPECT_EQ(keys_of(json["ablation"][0]), ablation);
  Keys level{"lod", "triangles", "texels"};
  level.insert(level.end(), figures.begin(), figures.end());
  EXPECT_EQ(keys_of(json["asset_levels"][0]), level);
  EXPECT_EQ(json["left_out"].size(), 0u);
  EXPECT_EQ(json["source"], "a.hair");
}

TEST_F(CardsReports, GoOnWithoutCardsThatDoNotFit) {
  groom::Groom groom = cards::test::groom_of(cards::test::strands_of_a_head(300));
  groom.path = "b.hair";
  const auto measure_dense = [&](std::size_t texels) {
    CardsSettings settings = quick();
    settings.budgets = {600};
    settings.texels = texels;
    settings.caps = 0;
    return measure_cards(asset_->asset(), groom, 0, settings, [](const std::string&) {});
  };
  const auto report = measure_dense(4096);  // room for a hundred cards, but not for three hundred
  ASSERT_TRUE(report.has_value()) << report.error().message;
  EXPECT_TRUE(report->sheets.empty() && report->ablation.empty()) << "nobody asked for any";
  ASSERT_EQ(report->summary.size(), 2u);
  EXPECT_EQ(report->summary[0].baseline, "none");
  EXPECT_EQ(report->summary[1].baseline, "even");
  ASSERT_EQ(report->left_out.size(), 1u);
  const std::string text = cards_text(made_up_heading(), *report);
  EXPECT_NE(text.find("left out: kmeans, 600 triangles: b.hair: 300 cards do not fit into 4096 texels"),
            std::string::npos)
      << text;
  const auto none = measure_dense(16);
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().kind, ToolError::Kind::kOverBudget);
}

TEST_F(CardsReports, RefuseSettingsOutOfRange) {
  for (const auto& spoil : std::vector<void (*)(CardsSettings&)>{
           [](CardsSettings& s) { s.budgets.clear(); }, [](CardsSettings& s) { s.budgets = {1}; },
           [](CardsSettings& s) { s.directions = 0; }, [](CardsSettings& s) { s.size = 2000; }}) {
    CardsSettings settings = quick();
    spoil(settings);
    const auto report = measure(settings);
    ASSERT_FALSE(report.has_value());
    EXPECT_EQ(report.error().kind, ToolError::Kind::kUsage);
  }
  const auto without_mesh = measure_cards({}, *groom_, 0, quick(), [](const std::string&) {});
  ASSERT_FALSE(without_mesh.has_value());
  EXPECT_EQ(without_mesh.error().kind, ToolError::Kind::kBadInput);
}

}  // namespace coif::report::measure_cards_test
