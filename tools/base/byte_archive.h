#pragma once

// Values as bytes on their way from a child process, and back. Private to the two ends of one pipe of one program, so
// it has no version. The sender may have been taken over by its input, so the receiver trusts no count.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace coif {

/// Types that may be copied as bytes: no padding, no invalid value. A user adds its own types.
template <class T>
inline constexpr bool kIsPlain = std::is_arithmetic_v<T>;

/// Takes values in one after the other.
class ByteEncoder {
 public:
  bool raw(const void* data, std::size_t size) {
    const std::size_t start = bytes.size();
    bytes.resize(start + size);
    if (size != 0) std::memcpy(bytes.data() + start, data, size);
    return true;
  }
  template <class T>
  requires kIsPlain<T>
  bool plain(const T& value) { return raw(&value, sizeof value); }
  template <class Container>
  bool sequence(const Container& items) {
    return plain(std::uint64_t{items.size()}) && raw(items.data(), items.size() * sizeof *items.data());
  }
  template <class Item, class Transfer>
  bool list(const std::vector<Item>& items, std::size_t, Transfer transfer) {
    plain(std::uint64_t{items.size()});
    for (const Item& item : items) transfer(*this, item);
    return true;
  }

  std::vector<std::uint8_t> bytes;
};

/// Reads the values in the same order. Returns false where bytes are missing; the value is then undefined.
class ByteDecoder {
 public:
  explicit ByteDecoder(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  bool raw(void* data, std::size_t size) {
    if (size > left_.size()) return false;
    if (size != 0) std::memcpy(data, left_.data(), size);
    left_ = left_.subspan(size);
    return true;
  }
  template <class T>
  requires kIsPlain<T>
  bool plain(T& value) { return raw(&value, sizeof value); }
  template <class Container>
  bool sequence(Container& items) {
    std::uint64_t count = 0;
    if (!plain(count) || count > left_.size() / sizeof *items.data()) return false;
    items.resize(static_cast<std::size_t>(count));
    return raw(items.data(), items.size() * sizeof *items.data());
  }
  // `least`: the fewest bytes that an item takes, so that a count cannot promise more items than there are bytes.
  template <class Item, class Transfer>
  bool list(std::vector<Item>& items, std::size_t least, Transfer transfer) {
    std::uint64_t count = 0;
    if (!plain(count) || count > left_.size() / least) return false;
    items.resize(static_cast<std::size_t>(count));
    for (Item& item : items) {
      if (!transfer(*this, item)) return false;
    }
    return true;
  }
  [[nodiscard]] bool at_end() const { return left_.empty(); }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace coif
