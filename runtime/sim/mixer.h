#pragma once
// A hash against accidents, by which saved states are recognised.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace coif {

/// The order and the place of every byte count.
class Mixer {
 public:
  explicit Mixer(std::uint64_t seed) : state_(seed) {}
  void add(const void* data, std::size_t size) {
    const std::byte* bytes = static_cast<const std::byte*>(data);
    for (; size >= sizeof(std::uint64_t); size -= sizeof(std::uint64_t), bytes += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes, sizeof word);
      mix(word);
    }
    std::uint64_t rest = size;
    for (; size > 0; --size, ++bytes) rest = rest << 8 | std::uint64_t(*bytes);
    mix(rest);
  }
  template <typename T>
  void add(std::span<const T> values) {
    add(values.data(), values.size_bytes());
  }
  [[nodiscard]] std::uint64_t hash() const { return state_ ^ state_ >> 32; }

 private:
  void mix(std::uint64_t word) {
    state_ = std::rotl(state_ ^ word * 0x9E37'79B9'7F4A'7C15u, 29) * 0xBF58'476D'1CE4'E5B9u + 1;
  }
  std::uint64_t state_;
};

}  // namespace coif
