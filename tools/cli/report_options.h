#pragma once

#include "base/tool_error.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"
#include "groom/groom.h"
#include "report/accuracy/measure_accuracy.h"
#include "report/cards/measure_cards.h"
#include "report/cost/measure_cost.h"
#include "report/order/measure_order.h"
#include "report/picture/measure_pictures.h"
#include "report/shadow/measure_shadows.h"
#include "report/stability/measure_stability.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif::cli {

/// The settings of `coif report cost`.
struct CostChoice {
  report::CostSettings simulation;          ///< Its time is set from `seconds`.
  std::uint32_t width = 512, height = 384;  ///< Pixels of a drawn frame.
  bool draws = true;
  double seconds = 18;        ///< About, for all but the thesis's table, which takes as long again.
  bool thesis_table = false;  ///< Also the thesis's Table 1.
  std::uint32_t thesis_width = 1024, thesis_height = 768;  ///< Pixels of its frames.
};

/// Measures simulation (tools/report) and drawing (tools/render) in one report. Hair that cannot be drawn is no error:
/// the report says why. Errors: those of measure_cost(), and kBadInput for an asset with neither simulated bones nor a
/// mesh.
tl::expected<report::CostReport, ToolError> measure_all_cost(const Asset& asset, const CostChoice& choice,
                                                             const report::ReportProgress& progress);

/// The settings of `coif report cards`.
struct CardsChoice {
  std::string source;                 ///< The file of the strands.
  std::optional<std::string> recipe;  ///< None: the recipe beside the source, or the defaults.
  report::CardsSettings settings;     ///< Without the recipe's values.
  SourceLimits limits;
};

enum class ReportSubject { kAccuracy, kStability, kOrder, kShadows, kCost, kCards, kPicture };

/// The settings of `coif report picture`.
struct PictureChoice {
  report::PictureReportSettings settings;  ///< Without the body.
  std::string body;                        ///< Its file; empty: the hair's own head.
};

/// Options that only one subject takes; owned by the program.
struct SubjectOptions {
  ReportSubject subject;
  const char* name;
  std::vector<const CLI::Option*> options;
};

struct ReportOptions {
  std::string file;
  ReportSubject subject = ReportSubject::kAccuracy;
  std::string output;  ///< Empty: the terminal only.
  std::string view;    ///< The page of `coif view` to write beside the report and link to; empty: none.
  std::string page;    ///< The template of that page; empty: the installed one.
  OutputFormat format = OutputFormat::kText;
  report::AccuracySettings accuracy;
  std::optional<ClipChoice> clip;  ///< Opened later, as accuracy.clip.
  report::StabilitySettings stability;
  CostChoice cost;              ///< Without the size of its pictures.
  report::OrderSettings order;  ///< Without the size of its pictures, if one was given.
  report::ShadowSettings shadows;
  CardsChoice cards;  ///< Without the size of its pictures, if one was given.
  PictureChoice picture;
  PixelSize size{512, 384};
  std::vector<SubjectOptions> only;          ///< One for each subject that has options of its own.
  const CLI::Option* size_option = nullptr;  ///< Applies to subjects with pictures.
};

/// Declares the options of `coif report`; `options` must outlive the parsing.
void add_report_options(CLI::App& app, ReportOptions& options);

/// Error (kUsage): an option that is not for this subject or this output.
tl::expected<void, ToolError> check_subject(const ReportOptions& options);

/// The strands and the settings of `coif report cards`.
struct ReportStrands {
  groom::Groom groom;
  std::uint64_t hash = 0;          ///< XXH64 of its file.
  report::CardsSettings settings;  ///< The settings of the command line and of the recipe.
};

/// Reads the strands as a cook with the recipe does. Errors: kUsage for a file of a format without strands, or for
/// pictures that are not square; those of choose_recipe() and read_groom(). Blocks; costs a fork.
[[nodiscard]] tl::expected<ReportStrands, ToolError> read_report_strands(const ReportOptions& options,
                                                                         const Messages& messages);

}  // namespace coif::cli
