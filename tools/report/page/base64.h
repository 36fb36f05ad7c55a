#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace coif {

/// RFC 4648, section 4: letters, digits, + and /, padded with =.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace coif
