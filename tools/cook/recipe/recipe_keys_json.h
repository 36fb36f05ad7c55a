#pragma once

#include <string>

namespace coif::cook {

/// The table of a recipe's keys, for programs that show them to people: [{"path", "section", "name", "kind", "default",
/// "low", "high", "choices", "unit", "meaning"}]. "kind": "switch", "number", "whole", "choice", or "other" for texts,
/// lists, colours and curves. "default": null where the cook chooses. "choices": separated by '|', null if there are
/// none. "low" and "high" are equal where values are not numbers.
[[nodiscard]] std::string recipe_keys_json();

}  // namespace coif::cook
