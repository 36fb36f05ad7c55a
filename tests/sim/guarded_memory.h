#pragma once
// Memory between two pages that nobody may touch.

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace coif {

/// Exactly so many bytes, from a multiple of 64 on. What follows them is a page that faults; up to 63 bytes in front of
/// it, and those on the first page, have a pattern that unharmed() looks for.
class GuardedMemory {
 public:
  explicit GuardedMemory(std::size_t bytes) : page_(std::size_t(sysconf(_SC_PAGESIZE))) {
    const std::size_t room = rounded(bytes == 0 ? 1 : bytes, page_);
    whole_ = room + 2 * page_;
    void* const mapped = mmap(nullptr, whole_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    EXPECT_NE(mapped, MAP_FAILED);
    base_ = static_cast<std::byte*>(mapped);
    EXPECT_EQ(mprotect(base_ + page_, room, PROT_READ | PROT_WRITE), 0);
    room_ = {base_ + page_, room};
    bytes_ = room_.subspan(room - rounded(bytes, 64), bytes);
    std::memset(room_.data(), kPattern, room_.size());
    std::memset(bytes_.data(), 0xFF, bytes_.size());
  }
  ~GuardedMemory() { munmap(base_, whole_); }
  GuardedMemory(const GuardedMemory&) = delete;
  GuardedMemory& operator=(const GuardedMemory&) = delete;

  [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }
  [[nodiscard]] bool unharmed() const {
    for (const std::byte* at = room_.data(); at != room_.data() + room_.size(); ++at) {
      if (at == bytes_.data()) at += bytes_.size();
      if (at == room_.data() + room_.size()) break;
      if (*at != std::byte{kPattern}) return false;
    }
    return true;
  }

 private:
  static constexpr unsigned char kPattern = 0xA5;
  static std::size_t rounded(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

  std::size_t page_, whole_ = 0;
  std::byte* base_ = nullptr;
  std::span<std::byte> room_, bytes_;
};

}  // namespace coif
