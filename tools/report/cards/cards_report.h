#pragma once

// The results of `coif report cards`: records, measured by measure_cards(), and the columns that show them.
//
// Cards and strands are drawn alike, from directions all around, and compared: coverage by intersection over union, and
// by PSNR the light that pixels send to an eye that carries the light, over pixels that either covers. Cards have mips
// and thresholds of opacity as in an asset.

#include "report/page/report_columns.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::report {

/// One set of cards from one direction.
struct CardsRow {
  std::string baseline;             ///< "none": coif's own; "kmeans", "even": as baseline_cards.h makes them.
  std::uint64_t triangles = 0;      ///< The budget.
  std::uint64_t texels = 0;         ///< The budget.
  std::array<double, 3> direction;  ///< The view direction, unit, in the strands' axes.
  double coverage_iou = 0;          ///< 0..1.
  double psnr_db = 0;
};

[[nodiscard]] inline Columns<CardsRow> cards_columns() {
  return {{"triangles", &CardsRow::triangles, {"triangles allowed"}},
          {"texels", &CardsRow::texels, {"texels allowed"}},
          {"direction", &CardsRow::direction, {"looking along", "{:.3f}"}},
          {"coverage_iou", &CardsRow::coverage_iou, {"coverage IoU", "{:.4f}"}},
          {"psnr_db", &CardsRow::psnr_db, {"PSNR", "{:.2f} dB"}},
          {"baseline", &CardsRow::baseline, {"baseline"}}};
}

/// How near a surface comes to the strands over all directions, and its drawing cost.
struct CardsFigures {
  double mean_iou = 0, worst_iou = 0;
  double mean_psnr_db = 0, worst_psnr_db = 0;
  double mean_error = 0;                  ///< Mean root mean square error of the pictures; 1 is white.
  double close_iou = 0, close_error = 0;  ///< The means of close-ups.
  std::uint64_t vertices = 0;             ///< Vertices that some triangle uses.
  double fragments = 0;                   ///< Per picture, mean: pixels of all triangles, whatever their texels.
  double layers = 0;                      ///< Overlapping fragments per pixel, mean over pixels and pictures.
};

/// The columns of a record's `figures`.
template <typename Row>
[[nodiscard]] Columns<Row> cards_figure_columns() {
  const auto of = [](auto member) { return [member](const Row& row) { return row.figures.*member; }; };
  return {{"mean_coverage_iou", of(&CardsFigures::mean_iou), {"IoU, mean", "{:.4f}"}, {"IoU", 8, "{:.4f}"}},
          {"worst_coverage_iou", of(&CardsFigures::worst_iou), {"worst", "{:.4f}"}, {"worst", 8, "{:.4f}"}},
          {"mean_psnr_db", of(&CardsFigures::mean_psnr_db), {"PSNR, mean", "{:.2f} dB"}, {"PSNR dB", 9, "{:.2f}"}},
          {"worst_psnr_db", of(&CardsFigures::worst_psnr_db), {"worst", "{:.2f} dB"}, {"worst", 7, "{:.2f}"}},
          {"mean_error", of(&CardsFigures::mean_error), {"RMS error", "{:.4f}"}, {"error", 8, "{:.4f}"}},
          {"close_coverage_iou", of(&CardsFigures::close_iou), {"IoU, close up", "{:.4f}"}},
          {"close_error", of(&CardsFigures::close_error), {"RMS error", "{:.4f}"}, {"close up", 10, "{:.4f}"}},
          {"vertices", of(&CardsFigures::vertices), {"vertices"}, {"vertices", 10}},
          {"fragments", of(&CardsFigures::fragments), {"fragments", "{:.0f}"}, {"fragments", 11, "{:.0f}"}},
          {"layers", of(&CardsFigures::layers), {"layers", "{:.2f}"}, {"layers", 8, "{:.2f}"}}};
}

/// One set of cards.
struct CardsSummary {
  std::string baseline;                 ///< As CardsRow::baseline.
  std::uint64_t triangles = 0;          ///< The budget.
  std::uint64_t texels = 0;             ///< The budget.
  std::uint64_t cards = 0;              ///< Cards made.
  std::uint64_t textures = 0;           ///< Different textures of these.
  std::uint64_t made_triangles = 0;     ///< their triangles
  std::uint64_t made_texels = 0;        ///< Texels made, gaps included.
  std::optional<double> segments = {};  ///< Per strip of "even".
  CardsFigures figures{};
  double seconds = 0;  ///< Wall time that making them took.
};

/// The name of a set of cards for people.
[[nodiscard]] std::string cards_name(const std::string& baseline);

[[nodiscard]] inline Columns<CardsSummary> cards_summary_columns() {
  using Row = CardsSummary;
  Columns<Row> columns{{"name", [](const Row& row) { return cards_name(row.baseline); }, {"cards"}, {"cards", -9}},
                       {"triangles", &Row::triangles, {"triangles allowed"}, {"allowed", 8}},
                       {"texels", &Row::texels},
                       {"baseline", &Row::baseline},
                       {"cards", &Row::cards, {"number"}, {"number", 8}},
                       {"textures", &Row::textures, {"textures"}, {"textures", 10}},
                       {"made_triangles", &Row::made_triangles, {"triangles"}, {"triangles", 11}},
                       {"made_texels", &Row::made_texels, {"texels"}},
                       {"segments", &Row::segments, {"segments of each", "{:.0f}"}, {"segments", 10, "{:.0f}"}}};
  columns.append(cards_figure_columns<Row>());
  columns.add({"seconds", &Row::seconds, {"seconds to make", "{:.2f}"}, {"seconds", 9, "{:.2f}"}});
  return columns;
}

/// One set of cards, of the same construction as in the summary, with or without some of what a cook does.
struct CardsAblation {
  std::string baseline;         ///< As CardsRow::baseline.
  std::uint64_t triangles = 0;  ///< The budget.
  bool fitted = true;           ///< The texels' opacity is fitted to pictures of the strands.
  bool caps = true;             ///< Some of the triangles lie on the scalp.
  bool shared = true;           ///< Cards may share textures.
  std::uint64_t cards = 0;      ///< Cards made.
  CardsFigures figures{};
  double seconds = 0;  ///< Wall time that making them took, without the choice of the construction.
};

[[nodiscard]] inline Columns<CardsAblation> cards_ablation_columns() {
  using Row = CardsAblation;
  Columns<Row> columns{{"name", [](const Row& row) { return cards_name(row.baseline); }, {"choice"}, {"choice", -9}},
                       {"triangles", &Row::triangles, {"triangles allowed"}, {"allowed", 8}},
                       {"baseline", &Row::baseline},
                       {"fitted", &Row::fitted, {"opacity fitted"}, {"fitted", 8}},
                       {"caps", &Row::caps, {"cards on the scalp"}, {"caps", 7}},
                       {"shared", &Row::shared, {"textures shared"}, {"shared", 8}},
                       {"cards", &Row::cards, {"number"}, {"number", 8}}};
  columns.append(cards_figure_columns<Row>());
  columns.add({"seconds", &Row::seconds, {"seconds to make", "{:.2f}"}, {"seconds", 9, "{:.2f}"}});
  return columns;
}

/// One level of detail of the asset.
struct CardsAssetLevel {
  std::uint64_t lod = 0;
  std::uint64_t triangles = 0;
  std::uint64_t texels = 0;  ///< Texels of the base colour's largest mip.
  CardsFigures figures{};
};

[[nodiscard]] inline Columns<CardsAssetLevel> cards_asset_columns() {
  using Row = CardsAssetLevel;
  Columns<Row> columns{{"lod", &Row::lod, {"level"}, {"asset's level", -28}},
                       {"triangles", &Row::triangles, {"triangles"}, {"triangles", 8 + 11}},
                       {"texels", &Row::texels, {"texels"}, {"texels", 10}}};
  columns.append(cards_figure_columns<Row>());
  return columns;
}

/// Cards that could not be made.
struct CardsLeftOut {
  std::string baseline;
  std::uint64_t triangles = 0;
  std::string why;
};

[[nodiscard]] inline Columns<CardsLeftOut> cards_left_out_columns() {
  return {{"baseline", &CardsLeftOut::baseline},
          {"name", [](const CardsLeftOut& row) { return cards_name(row.baseline); }},
          {"triangles", &CardsLeftOut::triangles},
          {"why", &CardsLeftOut::why}};
}

struct CardsReport {
  std::string source;         ///< The strands' file, as the user gave it.
  bool is_its_source = true;  ///< The asset was cooked from that file, byte for byte.
  std::uint64_t strands = 0;
  double strand_width = 0;       ///< Metres of the groom, mean.
  std::uint32_t size = 0;        ///< Pixels of a picture from afar, each way.
  std::uint32_t close_size = 0;  ///< The same close up.
  std::uint64_t directions = 0;
  double asset_factor = 1;  ///< The cook's factor on the groom's lengths.
  std::vector<CardsRow> rows;
  std::vector<CardsSummary> summary;
  std::vector<CardsAblation> ablation;  ///< Empty where it was not requested.
  std::vector<CardsAssetLevel> asset;
  std::vector<CardsLeftOut> left_out;
  std::vector<ReportSheet> sheets;  ///< For the page; empty where none were requested.
};

/// `coif report cards`: the heading, then facts about the strands, and `rows`, `summary`, `ablation`, `asset_levels`
/// and `left_out` with the keys of their columns. For the page also sentences under `notes`, and `sheets`, each with a
/// "caption" and the picture, a "png" in base64.
[[nodiscard]] nlohmann::ordered_json cards_json(const ReportHeading& heading, const CardsReport& report);

/// `coif report cards` for a terminal: each set of cards over all directions, and the summary.
[[nodiscard]] std::string cards_text(const ReportHeading& heading, const CardsReport& report);

/// The layout of the page: cards_page.json.
extern "C" const char coif_cards_page[];

/// How much nearer coif's cards are than the baselines, and how much of that the asset has kept, in one or two
/// sentences.
[[nodiscard]] std::string cards_summary(const CardsReport& report);

/// The method of the comparison, in a sentence.
[[nodiscard]] std::string cards_method(const CardsReport& report);

}  // namespace coif::report
