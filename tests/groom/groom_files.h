#pragma once

// Files of strands that tests write for themselves.

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace coif::groom::test {

/// Little-endian numbers one after the other.
class Bytes {
 public:
  template <class Number>
  Bytes& add(Number number) {
    const std::size_t end = bytes.size();
    bytes.resize(end + sizeof number);
    std::memcpy(&bytes[end], &number, sizeof number);
    return *this;
  }
  template <class Number>
  Bytes& add_all(const std::vector<Number>& numbers) {
    for (const Number number : numbers) add(number);
    return *this;
  }
  /// Overwrites what stands there.
  template <class Number>
  Bytes& set(std::size_t at, Number number) {
    std::memcpy(&bytes[at], &number, sizeof number);
    return *this;
  }
  Bytes& fill_to(std::size_t size) {
    bytes.resize(size, '\0');
    return *this;
  }
  [[nodiscard]] std::span<const std::byte> span() const { return std::as_bytes(std::span(bytes)); }

  std::string bytes;
};

/// Two strands, of three points and of two, as .hair has them, with all of its arrays.
inline Bytes small_hair(std::uint32_t arrays = 31) {
  Bytes file;
  file.bytes = "HAIR";
  file.add(2u).add(5u).add(arrays).add(1u).add(0.5f).add(0.25f).add(1.0f).add(0.5f).add(0.25f).fill_to(128);
  if ((arrays & 1) != 0) file.add_all<std::uint16_t>({2, 1});
  file.add_all<float>({0, 0, 0, 0, 0, 1, 0, 0, 2, /**/ 5, 0, 0, 5, 1, 0});
  if ((arrays & 4) != 0) file.add_all<float>({0.1f, 0.2f, 0.3f, 0.4f, 0.5f});
  if ((arrays & 8) != 0) file.add_all<float>({0, 0.25f, 0.5f, 0.75f, 1});
  if ((arrays & 16) != 0) file.add_all<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 1, 1});
  return file;
}

/// Two strands of three points as TressFX 3 has them: the header's 74 words, then the points.
inline Bytes small_tfx_3() {
  Bytes file;
  file.add(3.0f).add(2u).add(3u).add(4u).add(0u).fill_to(144).add(296u).fill_to(296);
  return file.add_all<float>({0, 0, 0, 0, 1, 0, 0, 2, 0, /**/ 1, 0, 0, 1, 1, 0, 1, 2, 0.5f});
}

/// These with a width for each strand and a colour for each point.
inline Bytes small_tfx_3_with_widths() {
  Bytes file = small_tfx_3().set(148, 368u).set(156, 376u);
  file.add_all<float>({0.01f, 0.02f});
  for (int i = 0; i < 6; ++i) file.add_all<float>({0.1f * float(i), 0.5f, 2.0f, 1});
  return file;
}

/// The same as TressFX 4 has them, with a width for each strand and a colour for each point.
inline Bytes small_tfx_4() {
  Bytes file;
  file.add(4.0f).add(2u).add(3u).add(160u).add(0u).add(0u).add(256u).add(264u).fill_to(160);
  file.add_all<float>({0, 0, 0, 0, 0, 1, 0, 1, 0, 2, 0, 1, /**/ 1, 0, 0, 0, 1, 1, 0, 1, 1, 2, 0.5f, 1});
  file.add_all<float>({0.01f, 0.02f});
  for (int i = 0; i < 6; ++i) file.add_all<float>({0.1f * float(i), 0.5f, 2.0f, 1});
  return file;
}

}  // namespace coif::groom::test
