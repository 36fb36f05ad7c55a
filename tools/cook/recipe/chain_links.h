#pragma once

// The recipe's links of chains.

#include <array>
#include <string>
#include <vector>

namespace coif::cook {

/// The chains to link: by a word, or by pairs of names.
struct RecipeLinks {
  std::string word = "none";  ///< "none" or "shared_strips"; "" where there are pairs.
  /// Each pair has a name of bones for either side: patterns with * and ?, ignoring case. Any bone stands for its
  /// chain.
  std::vector<std::array<std::string, 2>> pairs{};
};

}  // namespace coif::cook
