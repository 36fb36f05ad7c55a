#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace coif {

/// "1 patch", "2 patches".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// "3", "3 and 12", "3, 12, 40 and 7 more": numbers (not empty) that a message names, the first few of many.
[[nodiscard]] std::string numbers_text(std::span<const std::uint32_t> numbers, std::size_t most = 6);

/// `text` as valid UTF-8 of at most `max_bytes`, without control characters: line breaks and tabs become spaces, other
/// control characters and bytes that are not UTF-8 become '?'. Names from files end up in messages and JSON, which
/// must not break on them.
[[nodiscard]] std::string printable_text(std::string_view text, std::size_t max_bytes = 1024);

/// The text with a '?' for each character that is not ASCII and each byte that is not UTF-8: the part of a name that
/// does not depend on a program's encoding.
[[nodiscard]] std::string ascii_shape(std::string_view text);

/// Text that may be of an old program: bytes that are no UTF-8 are taken for Latin-1; where it is UTF-8 it stays.
[[nodiscard]] std::string utf8_of(std::string_view text);

/// ASCII letters only; other bytes stay.
[[nodiscard]] std::string lower_case(std::string text);

/// The text where only ASCII can be drawn: other bytes and control characters become '?'.
[[nodiscard]] std::string printable_ascii(std::string text);

/// Text that any document takes: bytes that are no UTF-8 become U+FFFD, control characters and line ends a blank.
/// Names from artists' files are neither checked nor short of surprises.
[[nodiscard]] std::string clean_text(std::string_view text);

/// Text as HTML and XML take it between tags and within quotes.
[[nodiscard]] std::string markup_text(std::string_view text);

/// The text, or as much of its beginning as a message has room for, whole characters of UTF-8.
[[nodiscard]] std::string excerpt(std::string text, std::size_t most = 100);

/// Two or three digits, more if they stand before the point: "0.0123", "4.57", "13240", "2.1e+09". "<0.0001" for
/// numbers closer to 0, which in a percentage are rounding noise; "-" for numbers that are not finite.
[[nodiscard]] std::string number_text(double number);

/// number_text() with " %" behind it, or "-".
[[nodiscard]] std::string percent_text(double percent);

/// Nanoseconds as the unit that needs the fewest digits: "840 ns", "12.3 us", "4.57 ms".
[[nodiscard]] std::string time_text(double nanoseconds);

/// "840 bytes", "12.3 kB", "4.57 MB"; 1 kB is 1000 bytes.
[[nodiscard]] std::string bytes_text(double bytes);

}  // namespace coif
