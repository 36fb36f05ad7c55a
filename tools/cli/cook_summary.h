#pragma once

#include "cook/cook.h"

#include <cstddef>
#include <string>

namespace coif {

/// A cook as it is told to people and programs.
struct CookSummary {
  std::string output;       ///< Path of the asset.
  std::size_t bytes = 0;    ///< Its size.
  CookReport report;        ///< Passes include the import; warnings include the importer's.
  bool from_cache = false;  ///< The report's times are those of the cook that filled the cache.
};

/// The result as JSON; the keys are stable.
[[nodiscard]] std::string cook_json(const CookSummary& summary);

/// A few lines: what was made, what was left out, what to do next.
[[nodiscard]] std::string cook_text(const CookSummary& summary);

}  // namespace coif
