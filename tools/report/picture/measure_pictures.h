#pragma once

#include "base/tool_error.h"
#include "import/source_model.h"
#include "report/page/report_heading.h"
#include "report/picture/picture_report.h"

#include <coif/asset.h>
#include <coif/shading_models.h>

#include <tl/expected.hpp>

#include <filesystem>
#include <optional>

namespace coif::report {

struct PictureReportSettings {
  std::filesystem::path truth;                  ///< The folder of true pictures (truth_folder.h).
  const importer::SourceModel* body = nullptr;  ///< What hides and shades the hair there; null: its own head.
  std::optional<ShadingModel> shading;          ///< Instead of the asset's.
  std::uint32_t lod = 0;
  bool sheets = false;  ///< Also pictures side by side.
};

/// Draws each true picture's scene, at its own size and at a quarter of it each way. Errors: those of read_truth_list()
/// and read_truth(), and of PictureMaker.
[[nodiscard]] tl::expected<PictureReport, ToolError> measure_pictures(const Asset& asset,
                                                                      const PictureReportSettings& settings,
                                                                      const ReportProgress& progress);

}  // namespace coif::report
