#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace coif {

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

/// {"asked", "cooked", "from_cache", "failed", "files": the outcomes}; the keys are stable.
[[nodiscard]] std::string batch_json(const Outcomes& outcomes);

/// A line a source, and the sum.
[[nodiscard]] std::string batch_text(const Outcomes& outcomes);

}  // namespace coif
