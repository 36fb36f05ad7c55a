#include "cache/cook_cache.h"
#include "cache/small_entry.h"
#include "payload_hash.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>

namespace coif::cache::cache_entry_test {

using nlohmann::json;

TEST(CacheEntry, ComesBackAsItWas) {
  const std::vector<std::byte> bytes = encode_entry(small_entry());
  const auto back = decode_entry(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(encode_entry(*back), bytes);
  EXPECT_EQ(back->dependencies[0].hash, 0xFEDCBA9876543210u);
  EXPECT_FALSE(back->dependencies[1].hash);
  EXPECT_EQ(back->dependencies[1].base, Dependency::Base::kRecipe);
  EXPECT_EQ(back->questions[0].answer, std::vector<std::string>{"hair.png"});
  EXPECT_EQ(back->report.passes[0].ms, 12.5);
  EXPECT_EQ(back->report.warnings, small_entry().report.warnings);
  EXPECT_EQ(back->report.warnings[0].code, "C144");
  EXPECT_EQ(back->report.left_out[0].ns_per_frame, 3.5);
  EXPECT_EQ(back->report.triangles, 7u);
  EXPECT_EQ(back->report.simulated_bones, 9u);
  EXPECT_EQ(back->report.order.added, 5u);
  EXPECT_EQ(back->report.order.cut_gain, 0.25);
  EXPECT_EQ(back->asset, small_entry().asset);
}

TEST(CacheEntry, DecodeRefusesEveryTruncation) {
  const std::vector<std::byte> whole = encode_entry(small_entry());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::byte> cut(whole.begin(), whole.begin() + std::ptrdiff_t(size));
    EXPECT_FALSE(decode_entry(cut)) << size << " of " << whole.size();
  }
}

TEST(CacheEntry, DecodeRefusesEveryFlippedBit) {
  const std::vector<std::byte> good = encode_entry(small_entry());
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::vector<std::byte> bytes = good;
      bytes[at] ^= std::byte(1 << bit);
      EXPECT_FALSE(decode_entry(bytes)) << "byte " << at << " bit " << bit;
    }
  }
}

TEST(CacheEntry, DecodeRefusesWhatFollowsTheEnd) {
  std::vector<std::byte> bytes = encode_entry(small_entry());
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(decode_entry(bytes));
}

/// An entry as it would be written with another document: the hash is right.
std::vector<std::byte> entry_with(const std::vector<std::uint8_t>& document) {
  std::vector<std::byte> bytes = encode_entry(small_entry());
  constexpr std::size_t kHash = 8, kSize = 16, kDocument = 24;
  bytes.resize(kDocument + document.size());
  const std::uint64_t size = document.size();
  std::memcpy(bytes.data() + kSize, &size, sizeof size);
  std::memcpy(bytes.data() + kDocument, document.data(), document.size());
  const std::uint64_t hash = xxh64(std::span(bytes).subspan(kSize));
  std::memcpy(bytes.data() + kHash, &hash, sizeof hash);
  return bytes;
}

/// The document of an entry, which follows three words.
json document_of(const CacheEntry& entry) {
  const std::vector<std::byte> bytes = encode_entry(entry);
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(bytes.data()) + 24;
  return json::from_msgpack(begin, begin + (bytes.size() - 24 - entry.asset.size()));
}

// Bytes that stand for "a list of one" and the like would make a careless reader call itself without end.
TEST(CacheEntry, DecodeRefusesAnyByteRepeatedWithoutEnd) {
  for (unsigned byte = 0; byte < 256; ++byte) {
    EXPECT_FALSE(decode_entry(entry_with(std::vector<std::uint8_t>(300'000, std::uint8_t(byte))))) << byte;
  }
}

TEST(CacheEntry, DecodeRefusesNumbersThatAreNotWhole) {
  const json good = document_of(small_entry());
  ASSERT_TRUE(decode_entry(entry_with(json::to_msgpack(good))));
  for (const char* place : {"/questions/0/0", "/dependencies/0/0", "/dependencies/0/2", "/report/left_out/0/2",
                            "/report/left_out/0/3", "/report/figures/0"}) {
    json document = good;
    document[json::json_pointer(place)] = 1.0e300;
    EXPECT_FALSE(decode_entry(entry_with(json::to_msgpack(document)))) << place;
  }
}

TEST(CacheEntry, CircumstancesAreThoseOfInputsAlone) {
  CacheEntry other = small_entry();
  other.report.passes[0].ms = 99;
  EXPECT_EQ(circumstances(other), circumstances(small_entry()));
  other.dependencies[1].hash = 1;
  EXPECT_NE(circumstances(other), circumstances(small_entry()));
}

}  // namespace coif::cache::cache_entry_test
