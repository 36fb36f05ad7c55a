#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

// Names that other people wrote, compared.

/// True where `name` matches `pattern`: * stands for any run of characters, ? for one, letters match in either case.
[[nodiscard]] bool matches(std::string_view name, std::string_view pattern);
[[nodiscard]] bool matches_any(std::string_view name, std::span<const std::string> patterns);

/// The word with the smallest edit distance to `word` (insert, delete, replace), or "" where even that one differs in
/// more than a third of its letters.
[[nodiscard]] std::string nearest_word(const std::string& word, std::span<const std::string> words);

/// The words of a name as modellers write them, in lower case: "mixamorig:LeftEye_01" is mixamorig, left, eye. A word
/// ends where a letter is followed by anything else, before a capital behind a small letter ("HairCap"), and before the
/// last of several capitals ("REye" is r, eye). Digits belong to no word; bytes beyond ASCII are letters.
[[nodiscard]] std::vector<std::string> words_of(std::string_view name);

/// Whether `name` has one of `patterns` as a word, or as up to three neighbouring words run together: "ponytail" is in
/// "pony_tail", "PonyTail" and "ponytail02", and "brow" is not in "Hair_Brown". A pattern is lower case and may have a
/// star at either end, which stands for more letters of one word; run together, words must be the pattern without
/// stars, so that "basic_hair" has no "*chair".
[[nodiscard]] bool has_word(std::string_view name, std::span<const std::string_view> patterns);

}  // namespace coif
