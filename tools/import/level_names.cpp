#include "import/level_names.h"

#include "base/side_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>

namespace coif {
namespace {

constexpr std::size_t kMostDigits = 2;

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }
bool is_letter(char letter) { return std::isalpha(static_cast<unsigned char>(letter)) != 0; }
bool is_between(char letter) { return letter == '_' || letter == ' ' || letter == '-' || letter == '.'; }

/// Blender numbers names that are there already: "Hair.001".
std::string_view without_number_of_copy(std::string_view name) {
  const bool is_copy = name.size() > 4 && name[name.size() - 4] == '.' && is_digit(name[name.size() - 3]) &&
                       is_digit(name[name.size() - 2]) && is_digit(name[name.size() - 1]);
  return is_copy ? name.substr(0, name.size() - 4) : name;
}

std::string between_marks(std::string text) {
  const auto is_mark = [](char letter) { return !is_letter(letter) && !is_digit(letter); };
  while (!text.empty() && is_mark(text.back())) text.pop_back();
  text.erase(text.begin(), std::ranges::find_if_not(text, is_mark));
  return text;
}

/// What the mark at `begin`..`end` stands in: before it, else after it.
std::string thing_around(const std::string& low, std::size_t begin, std::size_t end) {
  const std::string before = between_marks(low.substr(0, begin));
  return before.empty() ? between_marks(std::string(
                              without_number_of_copy(low).substr(std::min(end, without_number_of_copy(low).size()))))
                        : before;
}

bool begins_word(std::string_view name, std::size_t at) {
  return at == 0 || !is_letter(name[at - 1]) ||
         (std::isupper(static_cast<unsigned char>(name[at])) != 0 &&
          std::islower(static_cast<unsigned char>(name[at - 1])) != 0);
}

/// "LOD1": the three letters begin a word, and digits follow them.
std::optional<LevelName> level_after_lod(std::string_view name, const std::string& low) {
  for (std::size_t at = low.find("lod"); at != std::string::npos; at = low.find("lod", at + 1)) {
    std::size_t digit = at + 3;
    while (digit < low.size() && is_between(low[digit])) ++digit;
    if (!begins_word(name, at) || digit == low.size() || !is_digit(low[digit])) continue;
    std::size_t end = digit;
    while (end < low.size() && is_digit(low[end])) ++end;
    LevelName found{thing_around(low, at, end), 0, true};
    std::from_chars(&low[digit], low.data() + std::min(digit + kMostDigits, low.size()), found.level);
    return found;
  }
  return std::nullopt;
}

/// Where a letter stands by itself or with digits alone behind it, as a word; none where it does not.
struct Mark {
  std::size_t begin, digits, end;
};
std::optional<Mark> find_mark(std::string_view name, const std::string& low, char letter) {
  for (std::size_t at = low.find(letter); at != std::string::npos; at = low.find(letter, at + 1)) {
    std::size_t end = at + 1;
    while (end < low.size() && is_digit(low[end])) ++end;
    const bool ends_word = end == low.size() || is_between(low[end]);
    if (begins_word(name, at) && ends_word) return Mark{at, at + 1, end};
  }
  return std::nullopt;
}

}  // namespace

std::optional<LevelName> level_in(std::string_view name) {
  const std::string low = lower_case(std::string(name));
  if (auto sure = level_after_lod(name, low)) return sure;
  const auto mark = find_mark(name, low, 'l');
  if (!mark || mark->digits == mark->end || mark->end - mark->digits > kMostDigits) return std::nullopt;
  LevelName found{thing_around(low, mark->begin, mark->end)};
  std::from_chars(&low[mark->digits], low.data() + mark->end, found.level);
  return found;
}

std::optional<std::string> thing_on_the_right(std::string_view name) {
  const std::string low = lower_case(std::string(name));
  const auto mark = find_mark(name, low, 'r');
  return mark ? std::optional(thing_around(low, mark->begin, mark->end)) : std::nullopt;
}

}  // namespace coif
