#include "base/words.h"

#include "base/text.h"

#include <algorithm>
#include <cstddef>

namespace coif {
namespace {

constexpr std::size_t kMostWordsRunTogether = 3;

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter(char c) { return is_capital(c) || is_small(c) || static_cast<unsigned char>(c) >= 0x80; }

/// Whether a word begins at the letter `i`, behind another letter.
bool begins_word(std::string_view name, std::size_t i) {
  if (!is_capital(name[i])) return false;
  const bool ends_capitals = is_capital(name[i - 1]) && i + 1 < name.size() && is_small(name[i + 1]);
  return is_small(name[i - 1]) || ends_capitals;
}

std::string_view without_stars(std::string_view pattern) {
  if (pattern.starts_with('*')) pattern.remove_prefix(1);
  if (pattern.ends_with('*')) pattern.remove_suffix(1);
  return pattern;
}

}  // namespace

std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i])) continue;
    if (i == 0 || !is_letter(name[i - 1]) || begins_word(name, i)) words.emplace_back();
    words.back() += is_capital(name[i]) ? char(name[i] - 'A' + 'a') : name[i];
  }
  return words;
}

bool has_word(std::string_view name, std::span<const std::string_view> patterns) {
  const std::vector<std::string> words = words_of(name);
  for (std::size_t first = 0; first < words.size(); ++first) {
    const auto is_word = [&](std::string_view pattern) { return matches(words[first], pattern); };
    if (std::ranges::any_of(patterns, is_word)) return true;
    std::string together = words[first];
    for (std::size_t w = first + 1; w < std::min(words.size(), first + kMostWordsRunTogether); ++w) {
      together += words[w];
      const auto is_run = [&](std::string_view pattern) { return together == without_stars(pattern); };
      if (std::ranges::any_of(patterns, is_run)) return true;
    }
  }
  return false;
}

}  // namespace coif
