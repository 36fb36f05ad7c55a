#include "base/json.h"
#include "cache/cook_cache.h"
#include "payload_hash.h"

#include <algorithm>
#include <cstring>

namespace coif {

// Names in artists' files need not be UTF-8, which MessagePack carries and JSON text would not. CBOR would, too, but
// its strings may be made of strings, for each level of which the library's reader calls itself.
using nlohmann::json;

/// The library would convert any number, also those that are none of the type: a whole one, or an exception.
template <class Whole>
static Whole whole(const json& in) {
  return static_cast<Whole>(in.get_ref<const json::number_integer_t&>());
}

static void to_json(json& out, const Dependency& d) {
  out = {int(d.base), d.path, d.hash ? json(*d.hash) : json(nullptr)};
}

static void from_json(const json& in, Dependency& d) {
  const bool from_recipe = whole<int>(in.at(0)) == int(Dependency::Base::kRecipe);
  d.base = from_recipe ? Dependency::Base::kRecipe : Dependency::Base::kSource;
  d.path = in.at(1).get<std::string>();
  if (!in.at(2).is_null()) d.hash = whole<std::uint64_t>(in.at(2));
}

static void to_json(json& out, const TextureQuestion& q) { out = {int(q.kind), q.words, q.answer}; }

static void from_json(const json& in, TextureQuestion& q) {
  q.kind = TextureQuestion::Kind(whole<int>(in.at(0)));
  in.at(1).get_to(q.words);
  in.at(2).get_to(q.answer);
}

static void to_json(json& out, const PassTime& p) { out = {p.name, p.ms}; }

static void from_json(const json& in, PassTime& p) {
  in.at(0).get_to(p.name);
  in.at(1).get_to(p.ms);
}

static void to_json(json& out, const Warning& w) { out = {w.code, std::string(w)}; }

static void from_json(const json& in, Warning& w) {
  w = Warning(in.at(0).get<std::string>(), in.at(1).get<std::string>());
}

static void to_json(json& out, const LeftOut& l) { out = {l.what, l.why, l.bytes, l.bytes_per_head, l.ns_per_frame}; }

static void from_json(const json& in, LeftOut& l) {
  in.at(0).get_to(l.what);
  in.at(1).get_to(l.why);
  l.bytes = whole<decltype(l.bytes)>(in.at(2));
  l.bytes_per_head = whole<decltype(l.bytes_per_head)>(in.at(3));
  in.at(4).get_to(l.ns_per_frame);
}

static void to_json(json& out, const OrderFigures& o) {
  out = {o.orders, o.psnr, o.median, o.worst, o.moving, o.crossings, o.cuts, o.added, o.cut_gain};
}

static void from_json(const json& in, OrderFigures& o) {
  std::uint32_t* const counts[] = {&o.orders, &o.crossings, &o.cuts, &o.added};
  constexpr std::size_t kPlaces[] = {0, 5, 6, 7};
  for (std::size_t i = 0; i < std::size(counts); ++i) *counts[i] = whole<std::uint32_t>(in.at(kPlaces[i]));
  in.at(1).get_to(o.psnr);
  in.at(2).get_to(o.median);
  in.at(3).get_to(o.worst);
  in.at(4).get_to(o.moving);
  in.at(8).get_to(o.cut_gain);
}

namespace {

constexpr char kMagic[] = "coifent4";
constexpr std::size_t kWord = 8;
constexpr std::size_t kHeader = 3 * kWord;  // magic, hash, length of the document

json warning_list(const std::vector<Warning>& warnings) {
  json list = json::array();
  for (const Warning& warning : warnings) to_json(list.emplace_back(), warning);
  return list;
}

json report_document(const CookReport& r) {
  return {{"passes", r.passes},
          {"warnings", warning_list(r.warnings)},
          {"notes", r.notes},
          {"left_out", r.left_out},
          {"figures",
           {r.triangles, r.vertices, r.patches, r.patches_by_index, r.patches_by_position, r.chains, r.bones,
            r.simulated_bones}},
          {"order", r.order}};
}

CookReport report_from(const json& in) {
  CookReport r;
  in.at("passes").get_to(r.passes);
  for (const json& warning : in.at("warnings")) from_json(warning, r.warnings.emplace_back());
  in.at("notes").get_to(r.notes);
  in.at("left_out").get_to(r.left_out);
  std::uint32_t* const figures[] = {&r.triangles,           &r.vertices, &r.patches, &r.patches_by_index,
                                    &r.patches_by_position, &r.chains,   &r.bones,   &r.simulated_bones};
  for (std::size_t i = 0; i < std::size(figures); ++i) *figures[i] = whole<std::uint32_t>(in.at("figures").at(i));
  in.at("order").get_to(r.order);
  return r;
}

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
  return bytes_of({{"dependencies", entry.dependencies}, {"questions", entry.questions}});
}

std::vector<std::byte> encode_entry(const CacheEntry& entry) {
  const std::vector<std::byte> document = bytes_of({{"dependencies", entry.dependencies},
                                                    {"questions", entry.questions},
                                                    {"named", entry.named},
                                                    {"report", report_document(entry.report)}});
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
  document.at("questions").get_to(entry.questions);
  document.at("named").get_to(entry.named);
  entry.report = report_from(document.at("report"));
  entry.asset.assign(rest.begin() + std::ptrdiff_t(size), rest.end());
  return entry;
} catch (const std::exception&) {
  return {};  // a document of another shape
}

}  // namespace coif
