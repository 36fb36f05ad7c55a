#pragma once

// What a recipe says of chains that stay together.

#include <array>
#include <string>
#include <vector>

namespace coif::cook {

/// Which chains are linked: by a word, or by pairs of names.
struct RecipeLinks {
  std::string word = "none";  ///< "none" or "shared_strips"; "" where there are pairs.
  /// Each a name of bones of either side: patterns with * and ?, letters of either case. Any bone stands for its chain.
  std::vector<std::array<std::string, 2>> pairs{};
};

}  // namespace coif::cook
