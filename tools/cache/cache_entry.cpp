#include "base/json.h"
#include "cache/cook_cache.h"
#include "cook/cook.h"
#include "payload_hash.h"

#include <algorithm>
#include <cstring>

namespace coif::cache {

// Names in artists' files need not be UTF-8, which MessagePack carries and JSON text would not. CBOR would, too, but
// its strings may be made of strings, for each level of which the library's reader calls itself.
using nlohmann::json;

static void to_json(json& out, const Dependency& d) {
  out = {int(d.base), d.path, d.hash ? json(*d.hash) : json(nullptr)};
}

static void from_json(const json& in, Dependency& d) {
  const bool from_recipe = whole_number<int>(in.at(0)) == int(Dependency::Base::kRecipe);
  d.base = from_recipe ? Dependency::Base::kRecipe : Dependency::Base::kSource;
  d.path = in.at(1).get<std::string>();
  if (!in.at(2).is_null()) d.hash = whole_number<std::uint64_t>(in.at(2));
}

namespace {

constexpr char kMagic[] = "coifent5";
constexpr std::size_t kWord = 8;
constexpr std::size_t kHeader = 3 * kWord;  // magic, hash, length of the document

/// Reads a document without keeping it, and stops where it is nested deeper than an entry is: the library's reader
/// calls itself for each level, and would run out of stack.
class LevelGauge : public json::json_sax_t {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return ++level_ <= kDeepest; }
  bool start_array(std::size_t) override { return ++level_ <= kDeepest; }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

 private:
  static constexpr int kDeepest = 16;
  bool leave() {
    --level_;
    return true;
  }
  int level_ = 0;
};

std::vector<std::byte> bytes_of(const json& document) {
  const std::vector<std::uint8_t> packed = json::to_msgpack(document);
  const auto bytes = std::as_bytes(std::span(packed));
  return {bytes.begin(), bytes.end()};
}

std::uint64_t word_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

}  // namespace

std::vector<std::byte> circumstances(const CacheEntry& entry) {
  return bytes_of({{"dependencies", entry.dependencies}, {"questions", cook::questions_document(entry.questions)}});
}

std::vector<std::byte> encode_entry(const CacheEntry& entry) {
  const std::vector<std::byte> document = bytes_of({{"dependencies", entry.dependencies},
                                                    {"questions", cook::questions_document(entry.questions)},
                                                    {"named", entry.named},
                                                    {"report", cook::report_document(entry.report)}});
  std::vector<std::byte> file(kHeader + document.size() + entry.asset.size());
  std::ranges::copy(document, file.begin() + kHeader);
  std::ranges::copy(entry.asset, file.begin() + std::ptrdiff_t(kHeader + document.size()));
  const std::uint64_t size = document.size();
  std::memcpy(file.data(), kMagic, kWord);
  std::memcpy(file.data() + 2 * kWord, &size, sizeof size);
  const std::uint64_t hash = xxh64(std::span(file).subspan(2 * kWord));
  std::memcpy(file.data() + kWord, &hash, sizeof hash);
  return file;
}

std::optional<CacheEntry> decode_entry(std::span<const std::byte> bytes) try {
  if (bytes.size() < kHeader || std::memcmp(bytes.data(), kMagic, kWord) != 0) return {};
  if (word_at(bytes, kWord) != xxh64(bytes.subspan(2 * kWord))) return {};
  const std::uint64_t size = word_at(bytes, 2 * kWord);
  const auto rest = bytes.subspan(kHeader);
  if (size > rest.size()) return {};
  const auto* const begin = reinterpret_cast<const std::uint8_t*>(rest.data());
  LevelGauge gauge;
  if (!json::sax_parse(begin, begin + size, &gauge, json::input_format_t::msgpack)) return {};
  const json document = json::from_msgpack(begin, begin + size);
  CacheEntry entry;
  document.at("dependencies").get_to(entry.dependencies);
  entry.questions = cook::questions_from(document.at("questions"));
  document.at("named").get_to(entry.named);
  entry.report = cook::report_from(document.at("report"));
  entry.asset.assign(rest.begin() + std::ptrdiff_t(size), rest.end());
  return entry;
} catch (const std::exception&) {
  return {};  // a document of another shape
}

}  // namespace coif::cache
