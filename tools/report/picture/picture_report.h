#pragma once

// The results of `coif report picture`: records, measured by measure_pictures(), and the columns that show them.

#include "report/page/report_columns.h"
#include "report/picture/light_measures.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coif::report {

/// One scene at one size; or, in a total, the root mean square (tone), mean of ratios (grain) or mean (others) over all
/// scenes that share what is named.
struct PictureRow {
  std::string view, color, light;  ///< Names of the scene.
  std::uint32_t size = 0;          ///< Pixels of the shorter side.
  bool is_full_size = true;        ///< The true picture's own; otherwise a quarter of it each way.
  LightFigures figures;
};

[[nodiscard]] Columns<PictureRow> picture_columns();

struct PictureReport {
  std::string truth;   ///< The folder, as the user gave it.
  std::string device;  ///< GL_RENDERER.
  std::string shading;
  std::vector<PictureRow> rows;
  std::vector<PictureRow> totals;   ///< Over all scenes, then by light, by colour: "all" where a name says nothing.
  std::vector<ReportSheet> sheets;  ///< For the page; empty where none were requested.
};

/// Totals of rows at their full sizes and of those at a quarter.
[[nodiscard]] std::vector<PictureRow> picture_totals(const std::vector<PictureRow>& rows);

/// `coif report picture`: the heading, `truth`, `device`, `shading`, and `rows` and `totals` with their columns' keys.
[[nodiscard]] nlohmann::ordered_json picture_json(const ReportHeading& heading, const PictureReport& report);

/// For a terminal: the totals, each scene, and the summary.
[[nodiscard]] std::string picture_text(const ReportHeading& heading, const PictureReport& report);

/// The layout of the page: picture_page.json.
extern "C" const char coif_picture_page[];

}  // namespace coif::report
