#pragma once

#include <string>
#include <string_view>

namespace coif {

/// `text` as valid UTF-8 of at most `max_bytes`, without control characters: line breaks and tabs become spaces, other
/// control characters and bytes that are not UTF-8 become '?'. Names from files end up in messages and JSON, which
/// must not break on them.
[[nodiscard]] std::string printable_text(std::string_view text, std::size_t max_bytes = 1024);

}  // namespace coif
