#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>

namespace coif {

/// A heap block of exactly the size asked for, aligned to 64 bytes: AddressSanitizer sees one byte too far.
class AlignedBytes {
 public:
  explicit AlignedBytes(std::span<const std::byte> bytes) : size_(bytes.size()) {
    void* memory = nullptr;
    if (posix_memalign(&memory, 64, size_ == 0 ? 1 : size_) == 0) data_ = static_cast<std::byte*>(memory);
    if (data_ != nullptr && size_ > 0) std::memcpy(data_, bytes.data(), size_);
  }
  ~AlignedBytes() { std::free(data_); }
  AlignedBytes(const AlignedBytes&) = delete;
  AlignedBytes& operator=(const AlignedBytes&) = delete;

  [[nodiscard]] std::span<std::byte> bytes() { return {data_, size_}; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_;
};

}  // namespace coif
