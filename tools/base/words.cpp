#include "base/words.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace coif {
namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

bool matches(std::string_view name, std::string_view pattern) {
  // Greedy with one point of return, so that many stars cost no more than length times length.
  std::size_t n = 0, p = 0, star = std::string_view::npos, star_name = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_name = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || same_letter(pattern[p], name[n]))) {
      ++p;
      ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++star_name;
    } else {
      return false;
    }
  }
  return std::all_of(pattern.begin() + std::ptrdiff_t(p), pattern.end(), [](char c) { return c == '*'; });
}

bool matches_any(std::string_view name, std::span<const std::string> patterns) {
  return std::ranges::any_of(patterns, [&](const std::string& pattern) { return matches(name, pattern); });
}

namespace {

/// Levenshtein distance, one row at a time.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replace, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_word(const std::string& word, std::span<const std::string> words) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : words) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

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
