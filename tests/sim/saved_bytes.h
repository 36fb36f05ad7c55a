#pragma once
// Saved states as bytes that a test changes.

#include "sim/mixer.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace coif {

using SavedState = std::vector<std::byte>;

inline constexpr std::size_t kVersionAt = 8, kHashAt = 24, kContentAt = 32;

[[nodiscard]] inline SavedState saved(const Hair& hair) {
  SavedState bytes(hair.saved_bytes());
  EXPECT_EQ(hair.save(bytes), Status::kOk);
  return bytes;
}

/// As if a crowd had saved what was changed.
inline void hash_anew(SavedState& bytes) {
  std::uint32_t version = 0;
  std::memcpy(&version, &bytes[kVersionAt], sizeof version);
  Mixer mixer(version);
  mixer.add(std::span<const std::byte>(bytes).subspan(kContentAt));
  const std::uint64_t hash = mixer.hash();
  std::memcpy(&bytes[kHashAt], &hash, sizeof hash);
}

}  // namespace coif
