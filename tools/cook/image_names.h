#pragma once
// What the names of image files say, and how paths are spelt in models.

#include <span>
#include <string>

namespace coif {

/// ASCII letters only; other bytes stay.
[[nodiscard]] std::string lower_case(std::string text);

/// Backslashes become slashes.
[[nodiscard]] std::string with_slashes(std::string path);

/// "%20" becomes a space; what is no two hexadecimal digits stays.
[[nodiscard]] std::string percent_decoded(const std::string& text);

/// What follows the last slash.
[[nodiscard]] std::string last_name(const std::string& path);

/// Ends in the suffix of a format that the cooker reads, in letters of either case.
[[nodiscard]] bool is_image_name(const std::string& file);

/// The name without the suffix of an image or picture editor's format (psd, dds ...). Other dots belong to the name.
[[nodiscard]] std::string stem_of_image(const std::string& file);

/// False where a word in the name says that the image is something else than colour: a normal map, a mask, a thumbnail.
[[nodiscard]] bool names_color(const std::string& stem);

/// True where the name holds "hair" or one of `names`. Letters and digits count alone; names that every program gives
/// ("Material.001", "defaultobject") and those of one or two letters do not count.
[[nodiscard]] bool names_any(const std::string& stem, std::span<const std::string> names);

}  // namespace coif
