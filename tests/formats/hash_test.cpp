#include "payload_hash.h"

#include <gtest/gtest.h>

#include <string_view>

namespace coif {
namespace {

std::uint64_t hash_of(std::string_view text, std::uint64_t seed = 0) {
  return xxh64(std::as_bytes(std::span(text.data(), text.size())), seed);
}

// Published test vectors of XXH64, covering the empty input, the byte, word and stripe paths.
TEST(PayloadHash, AgreesWithPublishedVectors) {
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999ull);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5Bull);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999ull);
  EXPECT_EQ(hash_of("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1ull);
}

TEST(PayloadHash, DependsOnTheSeed) { EXPECT_NE(hash_of("abc", 0), hash_of("abc", 1)); }

}  // namespace
}  // namespace coif
