#pragma once

// Bytes as other programs and documents want them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// RFC 4648, section 4: letters, digits, + and /, padded with =.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// Decodes base64(); padding may be left out. None where another character occurs.
[[nodiscard]] std::optional<std::vector<std::byte>> from_base64(std::string_view text);

/// "%20" as a space (RFC 3986, section 2.1); a percent sign without two digits stays.
[[nodiscard]] std::string decoded_uri(std::string_view uri);

/// Encodes a number of -1..1 as a map's byte; the formats' two_sided() decodes it.
[[nodiscard]] std::uint8_t two_sided_byte(double value);

/// PNG bytes of a picture: RGBA, sRGB, rows top to bottom. Empty only when out of memory.
[[nodiscard]] std::vector<std::uint8_t> encode_png(std::span<const std::uint8_t> rgba, std::uint32_t width,
                                                   std::uint32_t height);

/// The same pixels in a tenth of that time, for pictures to look at: without alpha where all of it is 255. The bytes
/// also depend on the version of zlib.
[[nodiscard]] std::vector<std::uint8_t> encode_png_quickly(std::span<const std::uint8_t> rgba, std::uint32_t width,
                                                           std::uint32_t height);

}  // namespace coif
