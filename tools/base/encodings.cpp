#include "base/encodings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <new>

namespace {

/// The encoder does not check for null.
void* block_or_throw(void* block) {
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

}  // namespace

#define STBIW_MALLOC(bytes) block_or_throw(std::malloc(bytes))
#define STBIW_REALLOC(block, bytes) block_or_throw(std::realloc(block, bytes))
#define STBIW_FREE(block) std::free(block)
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace coif {
namespace {

constexpr std::string_view kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The index of each letter in kBase64, or -1.
constexpr std::array<std::int8_t, 256> kBase64Values = [] {
  std::array<std::int8_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < kBase64.size(); ++i) values[std::uint8_t(kBase64[i])] = std::int8_t(i);
  return values;
}();

}  // namespace

std::uint8_t two_sided_byte(double value) {
  return std::uint8_t(std::lround(std::clamp(127 * value, -127.0, 127.0)) + 128);
}

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const auto group = bytes.subspan(at, std::min<std::size_t>(3, bytes.size() - at));
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) bits = bits << 8 | (i < group.size() ? group[i] : 0u);
    for (std::size_t i = 0; i < 4; ++i) text += i <= group.size() ? kBase64[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

std::optional<std::vector<std::byte>> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    const int six = kBase64Values[std::uint8_t(letter)];
    if (six < 0) return std::nullopt;
    bits = bits << 6 | std::uint32_t(six);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(std::byte(bits >> count & 0xFF));
  }
  return bytes;
}

std::string decoded_uri(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    text += coded ? char(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  return text;
}

std::vector<std::uint8_t> encode_png(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height) {
  const auto append = [](void* context, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    auto& png = *static_cast<std::vector<std::uint8_t>*>(context);
    png.insert(png.end(), bytes, bytes + size);
  };
  std::vector<std::uint8_t> png;
  const int columns = static_cast<int>(width), rows = static_cast<int>(height);
  if (stbi_write_png_to_func(append, &png, columns, rows, 4, rgba.data(), 4 * columns) == 0) png.clear();
  return png;
}

}  // namespace coif
