#include "payload_hash.h"

#include "chunk_checks.h"

#include <bit>
#include <cstring>

namespace coif {
namespace {

constexpr std::uint64_t kPrime1 = 0x9E3779B185EBCA87ull;
constexpr std::uint64_t kPrime2 = 0xC2B2AE3D27D4EB4Full;
constexpr std::uint64_t kPrime3 = 0x165667B19E3779F9ull;
constexpr std::uint64_t kPrime4 = 0x85EBCA77C2B2AE63ull;
constexpr std::uint64_t kPrime5 = 0x27D4EB2F165667C5ull;

template <typename Word>
std::uint64_t read(const std::byte* at) {
  Word word;
  std::memcpy(&word, at, sizeof word);
  return word;
}

std::uint64_t round(std::uint64_t lane, std::uint64_t word) { return std::rotl(lane + word * kPrime2, 31) * kPrime1; }

std::uint64_t merge(std::uint64_t hash, std::uint64_t lane) { return (hash ^ round(0, lane)) * kPrime1 + kPrime4; }

/// The four lanes over all whole 32-byte stripes; moves `at` behind them.
std::uint64_t hash_stripes(const std::byte*& at, const std::byte* end, std::uint64_t seed) {
  std::uint64_t lane[4] = {seed + kPrime1 + kPrime2, seed + kPrime2, seed, seed - kPrime1};
  for (; end - at >= 32; at += 32) {
    for (int i = 0; i < 4; ++i) lane[i] = round(lane[i], read<std::uint64_t>(at + 8 * i));
  }
  std::uint64_t hash = std::rotl(lane[0], 1) + std::rotl(lane[1], 7) + std::rotl(lane[2], 12) + std::rotl(lane[3], 18);
  for (std::uint64_t value : lane) hash = merge(hash, value);
  return hash;
}

std::uint64_t hash_tail(const std::byte* at, const std::byte* end, std::uint64_t hash) {
  for (; end - at >= 8; at += 8) {
    hash = std::rotl(hash ^ round(0, read<std::uint64_t>(at)), 27) * kPrime1 + kPrime4;
  }
  if (end - at >= 4) {
    hash = std::rotl(hash ^ read<std::uint32_t>(at) * kPrime1, 23) * kPrime2 + kPrime3;
    at += 4;
  }
  for (; at < end; ++at) hash = std::rotl(hash ^ std::uint64_t(*at) * kPrime5, 11) * kPrime1;
  return hash;
}

}  // namespace

std::uint64_t xxh64(std::span<const std::byte> bytes, std::uint64_t seed) {
  const std::byte* at = bytes.data();
  const std::byte* const end = at + bytes.size();
  std::uint64_t hash = bytes.size() >= 32 ? hash_stripes(at, end, seed) : seed + kPrime5;
  hash = hash_tail(at, end, hash + bytes.size());
  hash = (hash ^ hash >> 33) * kPrime2;
  hash = (hash ^ hash >> 29) * kPrime3;
  return hash ^ hash >> 32;
}

std::uint64_t table_hash(std::span<const std::byte> file, std::uint32_t chunk_count) {
  const std::uint64_t seed = xxh64(file.first(offsetof(FileHeader, table_hash)));
  return xxh64(file.subspan(sizeof(FileHeader), chunk_count * sizeof(ChunkEntry)), seed);
}

LoadStatus check_hash(std::span<const std::byte> file, const ChunkEntry& entry) {
  const std::uint64_t hash = xxh64(file.subspan(std::size_t(entry.offset), std::size_t(entry.bytes)));
  return hash == entry.hash ? LoadStatus{} : LoadStatus{LoadCode::kHash, entry.id, 0, entry.hash, hash};
}

LoadStatus Asset::verify_draw_data() const {
  const auto* file = reinterpret_cast<const std::byte*>(header_);
  for (const ChunkEntry& entry : chunks_) {
    if (!is_draw_data(entry.id)) continue;
    if (const LoadStatus status = check_hash({file, std::size_t(total_bytes())}, entry); !status) return status;
  }
  return {};
}

}  // namespace coif
