#pragma once

#include "cook/cook.h"
#include "pipeline/dependency.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace coif {

/// A cook as a cache keeps it: the result, and what it is the result of.
struct CacheEntry {
  std::vector<Dependency> dependencies;
  std::vector<TextureQuestion> questions;
  CookReport report;  ///< As the cook that made it told it, times included.
  std::vector<std::byte> asset;
};

/// One file: a magic word, the hash of all that follows, the length of a MessagePack document, the document, the asset's bytes.
[[nodiscard]] std::vector<std::byte> encode_entry(const CacheEntry& entry);

/// Nothing unless the bytes are those of one entry, to the last bit.
[[nodiscard]] std::optional<CacheEntry> decode_entry(std::span<const std::byte> bytes);

/// What an entry is the result of, as bytes: entries with the same are the same.
[[nodiscard]] std::vector<std::byte> circumstances(const CacheEntry& entry);

}  // namespace coif
