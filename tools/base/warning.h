#pragma once

#include <string>
#include <utility>

namespace coif {

/// A sentence of what the artist may not have meant, with its code in the table of issues (tools/validate), by which
/// one kind of warning can be acknowledged. Whoever only tells it takes it for the sentence that it is.
struct Warning : std::string {
  Warning() = default;
  Warning(std::string of_code, std::string text) : std::string(std::move(text)), code(std::move(of_code)) {}
  std::string code;  ///< "C144"
};

}  // namespace coif
