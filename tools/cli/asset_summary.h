#pragma once

#include <coif/asset.h>

#include <string>

namespace coif {

/// Counts, chunk sizes and settings of an open asset as JSON; the keys are stable.
[[nodiscard]] std::string asset_json(const Asset& asset);

/// The same as a table for people. `name`: the file's.
[[nodiscard]] std::string asset_text(const std::string& name, const Asset& asset);

}  // namespace coif
