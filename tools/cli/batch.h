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

/// What became of each source of a batch: one object a source with "source", "output", "status", "exit_code", "ms", and
/// what `coif cook --format json` says of an asset, or "error".
using Outcomes = nlohmann::ordered_json;

[[nodiscard]] bool is_cooked(const nlohmann::ordered_json& outcome);

struct BatchCounts {
  std::size_t asked = 0;
  std::size_t cooked = 0;
  std::size_t from_cache = 0;  ///< Of those that were cooked.
  std::size_t failed = 0;
};

[[nodiscard]] BatchCounts count(const Outcomes& outcomes);

/// "9 asked, 8 cooked (6 from the cache), 1 failed"
[[nodiscard]] std::string sentence(const BatchCounts& counts);

/// Cooks several sources, or a manifest's, into a folder, each for itself, in processes of their own; one that fails or
/// crashes stops no other. Prints a table or JSON, writes that or a page with pictures to --report, and returns the
/// highest exit code of all. Errors, before anything is cooked: those of read_manifest(), and options that do not go
/// with many sources; and a report that cannot be written.
tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages);

/// The outcomes as an HTML page, failures first, with a picture of each asset that can be drawn. Draws up to `jobs` at
/// once, each in a process of its own.
[[nodiscard]] std::string batch_page(const Outcomes& outcomes, unsigned jobs);

// What they do in processes of their own.

/// A key of what cook_each() returns: file_identity() of what a cook read. It is told to nobody.
inline constexpr const char* kInputIdentities = "input_identities";

/// Cooks each source with the options of the command line, in a process of its own, up to options.jobs at once, and
/// writes its asset. Messages go where this process's go, those about a missing sandbox left out. Returns the outcomes
/// in the order of the requests: what `coif cook --format json` says of an asset, or "error", with "source", "output",
/// "status", "exit_code", "ms" and kInputIdentities; nothing for a process that never answered.
[[nodiscard]] std::vector<std::optional<nlohmann::ordered_json>> cook_each(
    const CookOptions& options, const std::vector<cache::CookRequest>& requests, unsigned threads);

/// The bytes of a PNG for each asset, drawn in a process of its own, up to `jobs` at once; empty where the asset cannot
/// be drawn, or not here.
[[nodiscard]] std::vector<platform::Bytes> thumbnails(const std::vector<std::string>& assets, unsigned jobs);

}  // namespace coif::cli
