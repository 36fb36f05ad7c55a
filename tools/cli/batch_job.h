#pragma once

#include "base/json.h"
#include "cache/manifest.h"
#include "cli/cook_job.h"

#include <optional>
#include <vector>

namespace coif {

/// A key of what cook_each() returns: file_identity() of what a cook read. It is told to nobody.
inline constexpr const char* kInputIdentities = "input_identities";

/// Cooks each source with the options of the command line, in a process of its own, up to options.jobs at once, and
/// writes its asset. Messages go where this process's go, those about a missing sandbox left out. Returns the outcomes
/// in the order of the requests: what `coif cook --format json` says of an asset, or "error", with "source", "output",
/// "status", "exit_code", "ms" and kInputIdentities; nothing for a process that never answered.
[[nodiscard]] std::vector<std::optional<nlohmann::ordered_json>> cook_each(const CookOptions& options,
                                                                           const std::vector<CookRequest>& requests,
                                                                           unsigned threads);

/// The bytes of a PNG for each asset, drawn in a process of its own, up to `jobs` at once; empty where the asset cannot
/// be drawn, or not here.
[[nodiscard]] std::vector<Bytes> thumbnails(const std::vector<std::string>& assets, unsigned jobs);

}  // namespace coif
