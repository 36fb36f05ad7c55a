#pragma once

#include <string>
#include <string_view>

namespace coif {

/// Text that any document takes: bytes that are no UTF-8 become U+FFFD, control characters and line ends a blank.
/// Names from artists' files are neither checked nor short of surprises.
[[nodiscard]] std::string clean_text(std::string_view text);

}  // namespace coif
