#pragma once

#include <span>
#include <string>

namespace coif {

/// The word with the smallest edit distance to `word` (insert, delete, replace), or "" where even that one differs in
/// more than a third of its letters.
[[nodiscard]] std::string nearest_word(const std::string& word, std::span<const std::string> words);

}  // namespace coif
