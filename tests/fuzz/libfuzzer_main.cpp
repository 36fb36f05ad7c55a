// The program of libFuzzer: COIF_FUZZ_TARGET in the environment names the reader that gets the bytes.
//
// Hashes guard assets and cache entries, so that a plain fuzzer would meet refusals only: those two have mutators that
// change what a hash covers, and then the hash.

#include "fuzz/targets.h"

#include "payload_hash.h"
#include "write/asset_writer.h"

#include <coif/asset_records.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <random>
#include <span>
#include <vector>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed);

namespace coif::fuzz {
namespace {

const Target* chosen = nullptr;

constexpr std::size_t kRoomToGrow = 256;

struct OwnedChunk {
  std::uint32_t id;
  std::uint32_t flags;
  std::vector<std::uint8_t> bytes;
};

/// Those that lie inside the file; none where even the table does not.
std::vector<OwnedChunk> take_apart(std::span<const std::uint8_t> file) {
  FileHeader header;
  std::vector<OwnedChunk> chunks;
  if (file.size() < sizeof header) return chunks;
  std::memcpy(&header, file.data(), sizeof header);
  const std::size_t room = (file.size() - sizeof header) / sizeof(ChunkEntry);
  if (header.chunk_count > std::min<std::size_t>(room, kMaxChunks)) return chunks;
  for (std::size_t i = 0; i < header.chunk_count; ++i) {
    ChunkEntry entry;
    std::memcpy(&entry, file.data() + sizeof header + i * sizeof entry, sizeof entry);
    if (entry.offset > file.size() || entry.bytes > file.size() - entry.offset) continue;
    const auto bytes = file.subspan(entry.offset, entry.bytes);
    chunks.push_back({entry.id, entry.flags, {bytes.begin(), bytes.end()}});
  }
  return chunks;
}

std::vector<std::byte> put_together(const std::vector<OwnedChunk>& chunks) {
  std::vector<PendingChunk> pending;
  for (const OwnedChunk& chunk : chunks) {
    pending.push_back({chunk.id, chunk.flags, std::as_bytes(std::span(chunk.bytes)), chunk_alignment(chunk.id)});
  }
  return write_chunks(pending);
}

/// One field of a record, all of which are multiples of two bytes wide, to what is special about numbers there.
void change_field(std::vector<std::uint8_t>& bytes, std::minstd_rand& random) {
  constexpr std::uint32_t kValues[] = {0,          1,          2,          3,          5,
                                       0xFFFFFFFF, 0x7FFFFFFF, 0x80000000, 0x3F800000, 0xBF800000,
                                       0x7F800000, 0x7FC00000, 0x47C35000, 0xC7C35000, 0x358637BD,
                                       0x00000001, 0x33D6BF95, 0x5368D4A5, 0x38D1B717, 0x40490FDB};
  if (bytes.size() < 4) return;
  const std::uint32_t value = kValues[random() % std::size(kValues)];
  std::memcpy(bytes.data() + random() % (bytes.size() / 4) * 4, &value, sizeof value);
}

/// Records repeated or left out; sizes of records divide 48, 80 or 36, or are small.
void change_count(std::vector<std::uint8_t>& bytes, std::minstd_rand& random) {
  constexpr std::size_t kSizes[] = {1, 4, 12, 16, 20, 32, 36, 40, 48, 80};
  const std::size_t size = kSizes[random() % std::size(kSizes)];
  if (bytes.size() < size) return;
  const auto at = std::ptrdiff_t(random() % (bytes.size() / size) * size);
  const std::vector<std::uint8_t> record(bytes.begin() + at, bytes.begin() + at + std::ptrdiff_t(size));
  if (random() % 2 == 0) {
    bytes.insert(bytes.begin() + at, record.begin(), record.end());
  } else {
    bytes.erase(bytes.begin() + at, bytes.begin() + at + std::ptrdiff_t(size));
  }
}

void change_bytes(std::vector<std::uint8_t>& bytes) {
  const std::size_t size = bytes.size();
  bytes.resize(size + kRoomToGrow);
  bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

void change_chunk(std::vector<OwnedChunk>& chunks, std::minstd_rand& random) {
  const std::size_t at = random() % chunks.size();
  switch (random() % 8) {
    case 0: return void(chunks.erase(chunks.begin() + std::ptrdiff_t(at)));
    case 1: return std::swap(chunks[at], chunks[random() % chunks.size()]);
    case 2: return change_count(chunks[at].bytes, random);
    case 3:
    case 4: return change_field(chunks[at].bytes, random);
    default: return change_bytes(chunks[at].bytes);
  }
}

/// Chunk by chunk: bytes put in anywhere would move all chunks behind them off their places, so the file is taken apart
/// and written anew.
std::size_t mutate_asset(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  std::minstd_rand random(seed);
  std::vector<OwnedChunk> chunks = take_apart({data, size});
  const bool as_bytes = random() % 16 == 0;  // header and table deserve some as well
  if (chunks.empty() || as_bytes) return LLVMFuzzerMutate(data, size, max_size);
  for (unsigned changes = 1 + random() % 2; changes > 0 && !chunks.empty(); --changes) change_chunk(chunks, random);
  const auto file = put_together(chunks);
  if (file.size() > max_size) return size;
  std::memcpy(data, file.data(), file.size());
  return file.size();
}

/// A magic word, the hash of all that follows, the length of the document, the document, other bytes: each 8 bytes wide
/// but the last two.
std::size_t mutate_cache_entry(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  constexpr std::size_t kWord = 8, kHashed = 2 * kWord, kDocument = 3 * kWord;
  if (size < kDocument || seed % 32 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::size_t changed = LLVMFuzzerMutate(data + kDocument, size - kDocument, max_size - kDocument);
  const std::uint64_t document = changed;
  if (seed % 4 != 0) std::memcpy(data + kHashed, &document, sizeof document);  // else some of it may be the asset's
  const std::uint64_t hash = xxh64(std::as_bytes(std::span(data + kHashed, kWord + changed)));
  std::memcpy(data + kWord, &hash, sizeof hash);
  return kDocument + changed;
}

}  // namespace
}  // namespace coif::fuzz

int LLVMFuzzerInitialize(int*, char***) {
  using namespace coif::fuzz;
  const char* const name = std::getenv("COIF_FUZZ_TARGET");
  chosen = find_target(name ? name : "", "COIF_FUZZ_TARGET must name a target");
  if (!chosen) std::exit(2);
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  coif::fuzz::chosen->run({data, size});
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  using namespace coif::fuzz;
  if (chosen->run == try_asset) return mutate_asset(data, size, max_size, seed);
  if (chosen->run == try_cache_entry) return mutate_cache_entry(data, size, max_size, seed);
  return LLVMFuzzerMutate(data, size, max_size);
}
