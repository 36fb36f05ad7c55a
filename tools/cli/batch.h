#pragma once

#include "base/json.h"
#include "cache/manifest.h"
#include "cli/command.h"
#include "cli/cook_job.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coif::cli {

/// The outcome of each source of a batch: one object per source with "source", "output", "status", "exit_code", "ms",
/// and the members that `coif cook --format json` prints for an asset, or "error".
using Outcomes = nlohmann::ordered_json;

[[nodiscard]] bool is_cooked(const nlohmann::ordered_json& outcome);

struct BatchCounts {
  std::size_t asked = 0;
  std::size_t cooked = 0;
  std::size_t from_cache = 0;  ///< How many of the cooked ones came from the cache.
  std::size_t failed = 0;
};

[[nodiscard]] BatchCounts count(const Outcomes& outcomes);

/// "9 asked, 8 cooked (6 from the cache), 1 failed"
[[nodiscard]] std::string sentence(const BatchCounts& counts);

/// Cooks several sources, or a manifest's, into a folder, each in a process of its own; one that fails or crashes stops
/// no other. Prints a table or JSON, writes that or a page with pictures to --report, and returns the highest exit
/// code. Errors before anything is cooked: those of read_manifest(), and options that do not go with many sources. Also
/// a report that cannot be written.
tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages);

/// The outcomes as an HTML page, failures first, with a picture of each asset that can be drawn. Draws up to `jobs` at
/// once, each in a process of its own.
[[nodiscard]] std::string batch_page(const Outcomes& outcomes, unsigned jobs);

// Work in processes of their own.

/// A key in the results of cook_each(): file_identity() of the files that a cook read. It is not printed.
inline constexpr const char* kInputIdentities = "input_identities";

/// Cooks each source with the options of the command line, in a process of its own, up to options.jobs at once, and
/// writes its asset. Messages go to this process's standard error, except those about a missing sandbox. Returns the
/// outcomes in the order of the requests: the members that `coif cook --format json` prints for an asset, or "error",
/// with "source", "output", "status", "exit_code", "ms" and kInputIdentities; none for a process that gave no answer.
[[nodiscard]] std::vector<std::optional<nlohmann::ordered_json>> cook_each(
    const CookOptions& options, const std::vector<cache::CookRequest>& requests, unsigned threads);

/// The bytes of a PNG for each asset, drawn in a process of its own, up to `jobs` at once; empty where the asset cannot
/// be drawn.
[[nodiscard]] std::vector<platform::Bytes> thumbnails(const std::vector<std::string>& assets, unsigned jobs);

}  // namespace coif::cli
