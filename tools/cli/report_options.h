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
#include "report/shadow/measure_shadows.h"
#include "report/stability/measure_stability.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif::cli {

/// What `coif report cost` measures.
struct CostChoice {
  report::CostSettings simulation;          ///< Its time is set from `seconds`.
  std::uint32_t width = 512, height = 384;  ///< Pixels of a drawn frame.
  bool draws = true;
  double seconds = 18;        ///< About, for all but the thesis's table, which takes as long again.
  bool thesis_table = false;  ///< Also the thesis's Table 1.
  std::uint32_t thesis_width = 1024, thesis_height = 768;  ///< Pixels of its frames.
};

/// Simulation by tools/report and drawing by tools/render as one report. Hair that cannot be drawn, here or at all, is
/// no error: the report says why. Errors: those of measure_cost(), and kBadInput for an asset with neither simulated
/// bones nor a mesh.
tl::expected<report::CostReport, ToolError> measure_all_cost(const Asset& asset, const CostChoice& choice,
                                                             const report::ReportProgress& progress);

/// What `coif report cards` compares with.
struct CardsChoice {
  std::string source;                 ///< The file of the strands.
  std::optional<std::string> recipe;  ///< None: what lies beside the source, or the defaults.
  report::CardsSettings settings;     ///< But for what the recipe says.
  SourceLimits limits;
};

enum class ReportSubject { kAccuracy, kStability, kOrder, kShadows, kCost, kCards };

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
  std::string view;    ///< The page of `coif view` to write beside it and to link to; empty: none.
  std::string page;    ///< What that is made of; empty: as installed.
  OutputFormat format = OutputFormat::kText;
  report::AccuracySettings accuracy;
  std::optional<ClipChoice> clip;  ///< To be opened as accuracy.clip.
  report::StabilitySettings stability;
  CostChoice cost;              ///< But for the size of its pictures.
  report::OrderSettings order;  ///< But for the size of its pictures, where one was asked for.
  report::ShadowSettings shadows;
  CardsChoice cards;  ///< But for the size of its pictures, where one was asked for.
  PixelSize size{512, 384};
  std::vector<SubjectOptions> only;          ///< One for each subject that has options of its own.
  const CLI::Option* size_option = nullptr;  ///< For subjects with pictures.
};

/// Declares the options of `coif report`; `options` must outlive the parsing.
void add_report_options(CLI::App& app, ReportOptions& options);

/// Error (kUsage): an option that is not for this subject or this output.
tl::expected<void, ToolError> check_subject(const ReportOptions& options);

/// What `coif report cards` compares with, and how.
struct ReportStrands {
  groom::Groom groom;
  std::uint64_t hash = 0;          ///< XXH64 of its file.
  report::CardsSettings settings;  ///< Those asked for, with what the recipe says.
};

/// Reads the strands as a cook with the recipe does. Errors: kUsage for a file that is of no format with strands or
/// pictures that are not square; those of choose_recipe() and read_groom(). Blocks; costs a fork.
[[nodiscard]] tl::expected<ReportStrands, ToolError> read_report_strands(const ReportOptions& options,
                                                                         const Messages& messages);

}  // namespace coif::cli
