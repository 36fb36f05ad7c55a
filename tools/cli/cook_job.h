#pragma once

#include "base/parallel_for.h"
#include "base/tool_error.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"
#include "cook/cook.h"
#include "import/import.h"
#include "validate/issue_codes.h"

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coif::cli {

/// A cook's result for people and programs.
struct CookSummary {
  std::string output;                        ///< Path of the asset.
  std::size_t bytes = 0;                     ///< Its size.
  cook::CookReport report;                   ///< Passes include the import; warnings include the importer's.
  bool draft = false;                        ///< CookSettings::draft.
  bool from_cache = false;                   ///< The report's times are then those of the cook that filled the cache.
  std::vector<std::filesystem::path> files;  ///< Files that were read besides the source, or looked for in vain.
  std::vector<std::filesystem::path> named;  ///< CookInputs::named_files.
};

/// The result as JSON; the keys are stable.
[[nodiscard]] nlohmann::ordered_json cook_json(const CookSummary& summary);

/// The result and the next command to use. `in_full`: also all notes, what was left out, the passes' times and the
/// files.
[[nodiscard]] std::string cook_text(const CookSummary& summary, bool in_full);

/// The command line of `coif cook`.
struct CookOptions {
  std::vector<std::string> sources;
  std::string output;  ///< A file for one source, a folder for several.
  std::optional<std::string> recipe;
  const char* preset = "";    ///< Overrides the recipe's "look.preset".
  std::string body;           ///< Overrides the recipe's "cards.body".
  std::string manifest;       ///< Instead of sources.
  std::string share = "1/1";  ///< The batch of the manifest that is cooked here, as K/N.
  std::string report;
  std::string depfile;
  std::string cache;  ///< A folder; empty: none.
  std::vector<std::filesystem::path> roots;
  bool print_recipe = false;
  bool list_presets = false;
  std::optional<std::string> list;  ///< "source", "candidates" or "patches": print it, and cook nothing.
  unsigned jobs = platform::all_threads();
  std::optional<unsigned> threads;  ///< Threads of each cook.
  SourceLimits limits;
  OutputFormat format = OutputFormat::kText;
  bool shows_progress = true;
  bool quiet = false;  ///< Print only errors, warnings, and requested JSON.
  bool verbose = false;
  bool durable = false;
  bool draft = false;         ///< CookSettings::draft.
  bool list_patches = false;  ///< CookSettings::list_patches.
  bool warnings_as_errors = false;
  std::vector<std::string> ignored;  ///< Codes in addition to the recipe's "warnings.acknowledged".

  [[nodiscard]] const std::string& source() const { return sources.front(); }
};

/// The reason for a failed cook, with the issues that `coif validate` has for the same source. They include warnings
/// that were found before.
struct FailedCook : ToolError {
  /// For a source that cannot be read or takes too much; and, without issues, for a wrong command line or output.
  FailedCook(ToolError error);
  FailedCook(ToolError error, Diagnostics found) : ToolError(std::move(error)), issues(std::move(found)) {}

  Diagnostics issues;
};

/// A failure because of a recipe's value, or of its file.
[[nodiscard]] FailedCook failed_by_recipe(const ToolError& error);

/// A cook that failed as JSON: source, output, status, exit_code, error, issues; the keys are stable.
[[nodiscard]] nlohmann::ordered_json failed_cook_json(const CookOptions& options, const FailedCook& failed);

/// Writes the failure to --report, if requested: over an earlier report or a new file, and never over anything else,
/// since a failed cook does not know all files that its source names.
void report_failed_cook(const CookOptions& options, const FailedCook& failed, const Messages& messages);

struct CookAnswer;
struct CookOrder;

/// The order to a child process that cooks the first of `options.sources`, without its hash. Prints once per process
/// that models are read without a sandbox, where that is so.
[[nodiscard]] CookOrder order_of(const CookOptions& options, const RecipeChoice& choice, const Messages& messages);
/// The limits of that child process.
[[nodiscard]] LimitedCall limited_call(const CookOptions& options);

/// Adds the codes that the command line ignores to the recipe's. Error (kUsage, kBadInput): a code is not that of a
/// warning.
tl::expected<void, ToolError> acknowledge(const CookOptions& options, RecipeChoice& choice);

/// Cooks the first of `options.sources` within the limits, without a cache, and writes nothing.
tl::expected<cook::CookResult, ToolError> cook_alone(const CookOptions& options, const RecipeChoice& choice,
                                                     const Messages& messages);

/// The same; the answer brings the model along.
tl::expected<CookAnswer, ToolError> cook_with_model(const CookOptions& options, const RecipeChoice& choice,
                                                    const Messages& messages);

/// Cooks the first of `options.sources` or takes the result from the cache, prints the warnings, and writes asset,
/// report and depfile. Each file is written whole or not at all, and none without the asset.
tl::expected<CookSummary, FailedCook> run_cook_job(const CookOptions& options, const RecipeChoice& choice,
                                                   const Messages& messages);

/// `coif cook SOURCE --list patches [-o PICTURE.png]`: cooks a draft, prints its patches with their numbers, and draws
/// them.
tl::expected<Exit, ToolError> list_patches_of(const CookOptions& options, const RecipeChoice& choice,
                                              const Messages& messages);

}  // namespace coif::cli
