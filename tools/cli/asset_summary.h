#pragma once

#include <coif/asset.h>

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// Counts, chunk sizes and settings of an open asset; the keys are the stable ones of `coif info`.
[[nodiscard]] nlohmann::ordered_json summarize(const Asset& asset);

/// The same as a table for people. `name`: the file's.
[[nodiscard]] std::string summary_text(const std::string& name, const nlohmann::ordered_json& summary);

}  // namespace coif
