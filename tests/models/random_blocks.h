#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif {

/// Bytes of texture blocks that are the same in every language: of x = 1664525 x + 1013904223 (modulo 2^32, from 1 on)
/// the highest byte. As any bytes are a block of ETC2, a few thousand have all modes. tests/web/three/eac.test.mjs
/// makes the same.
inline std::vector<std::uint8_t> random_blocks(std::size_t count) {
  std::vector<std::uint8_t> bytes(16 * count);
  std::uint32_t x = 1;
  for (std::uint8_t& byte : bytes) {
    x = 1664525u * x + 1013904223u;
    byte = std::uint8_t(x >> 24);
  }
  return bytes;
}

/// FNV-1a of RGBA, rows top to bottom, of random_blocks(4096) as an image of 256 x 256.
inline constexpr std::uint32_t kRandomColors = 958072869;

inline std::uint32_t fnv(const std::vector<std::byte>& bytes) {
  std::uint32_t hash = 2166136261u;
  for (const std::byte byte : bytes) hash = (hash ^ std::uint32_t(byte)) * 16777619u;
  return hash;
}

}  // namespace coif
