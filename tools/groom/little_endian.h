#pragma once

// Arrays in a binary file of little-endian numbers, as this machine has them.

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace coif::groom {

/// The number at a place that is known to be in the file.
template <class Number>
[[nodiscard]] Number number_at(std::span<const std::byte> bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// `count` numbers from the byte `at` on; `what` they are is named where the file ends before they do.
template <class Number>
[[nodiscard]] tl::expected<std::vector<Number>, std::string> numbers_at(std::span<const std::byte> bytes,
                                                                        std::uint64_t at, std::uint64_t count,
                                                                        const char* what) {
  if (at > bytes.size() || count > (bytes.size() - at) / sizeof(Number)) {
    return tl::unexpected(fmt::format("cut off in the {}: {} of {} bytes from byte {} on", what,
                                      at > bytes.size() ? 0 : bytes.size() - at, count * sizeof(Number), at));
  }
  std::vector<Number> numbers(static_cast<std::size_t>(count));
  if (count != 0) std::memcpy(numbers.data(), bytes.data() + at, numbers.size() * sizeof(Number));
  return numbers;
}

}  // namespace coif::groom
