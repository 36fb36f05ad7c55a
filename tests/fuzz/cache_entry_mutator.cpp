// Changes what an entry's hash covers and then the hash, without which every change would be refused for that reason.

#include "payload_hash.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed);

// A magic word, the hash of all that follows, the length of the document, the document, other bytes: each 8 bytes wide
// but the last two.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  constexpr std::size_t kWord = 8, kHashed = 2 * kWord, kDocument = 3 * kWord;
  if (size < kDocument || seed % 32 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::size_t changed = LLVMFuzzerMutate(data + kDocument, size - kDocument, max_size - kDocument);
  const std::uint64_t document = changed;
  if (seed % 4 != 0) std::memcpy(data + kHashed, &document, sizeof document);  // else some of it may be the asset's
  const std::uint64_t hash = coif::xxh64(std::as_bytes(std::span(data + kHashed, kWord + changed)));
  std::memcpy(data + kWord, &hash, sizeof hash);
  return kDocument + changed;
}
