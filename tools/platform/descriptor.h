#pragma once

// Inside of this folder only: a descriptor of the system, and writing to one.

#include <unistd.h>
#include <cerrno>
#include <cstddef>
#include <span>
#include <system_error>
#include <utility>

namespace coif::platform {

/// Owns a descriptor and closes it.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(long number) : number_(static_cast<int>(number)) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { (void)close(); }

  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

  /// Returns an error that the disk reports late, for example on a full network share.
  std::error_code close() {
    if (number_ < 0 || ::close(std::exchange(number_, -1)) == 0) return {};
    return {errno, std::generic_category()};
  }

 private:
  int number_ = -1;
};

[[nodiscard]] inline std::error_code last_error() { return {errno, std::generic_category()}; }

/// Writes all of the bytes to an open file or pipe, however often that takes. Returns why it could not, else nothing.
[[nodiscard]] inline std::error_code write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return {written < 0 ? errno : EIO, std::generic_category()};
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace coif::platform
