#include "pipeline/cache_entry.h"

#include "payload_hash.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

namespace coif {

// Names in artists' files need not be UTF-8, which CBOR carries and JSON text would not.
using nlohmann::json;

static void to_json(json& out, const Dependency& d) {
  out = {int(d.base), d.path, d.hash ? json(*d.hash) : json(nullptr)};
}

static void from_json(const json& in, Dependency& d) {
  d.base =
      in.at(0).get<int>() == int(Dependency::Base::kRecipe) ? Dependency::Base::kRecipe : Dependency::Base::kSource;
  d.path = in.at(1).get<std::string>();
  if (!in.at(2).is_null()) d.hash = in.at(2).get<std::uint64_t>();
}

static void to_json(json& out, const TextureQuestion& q) { out = {int(q.kind), q.words, q.answer}; }

static void from_json(const json& in, TextureQuestion& q) {
  q.kind = TextureQuestion::Kind(in.at(0).get<int>());
  in.at(1).get_to(q.words);
  in.at(2).get_to(q.answer);
}

static void to_json(json& out, const PassTime& p) { out = {p.name, p.ms}; }

static void from_json(const json& in, PassTime& p) {
  in.at(0).get_to(p.name);
  in.at(1).get_to(p.ms);
}

static void to_json(json& out, const LeftOut& l) { out = {l.what, l.why, l.bytes, l.bytes_per_head, l.ns_per_frame}; }

static void from_json(const json& in, LeftOut& l) {
  in.at(0).get_to(l.what);
  in.at(1).get_to(l.why);
  in.at(2).get_to(l.bytes);
  in.at(3).get_to(l.bytes_per_head);
  in.at(4).get_to(l.ns_per_frame);
}

namespace {

constexpr char kMagic[] = "coifent1";
constexpr std::size_t kWord = 8;
constexpr std::size_t kHeader = 3 * kWord;  // magic, hash, length of the document

json report_document(const CookReport& r) {
  return {{"passes", r.passes},
          {"warnings", r.warnings},
          {"notes", r.notes},
          {"left_out", r.left_out},
          {"figures",
           {r.triangles, r.vertices, r.patches, r.patches_by_index, r.patches_by_position, r.chains, r.bones,
            r.simulated_bones}}};
}

CookReport report_from(const json& in) {
  CookReport r;
  in.at("passes").get_to(r.passes);
  in.at("warnings").get_to(r.warnings);
  in.at("notes").get_to(r.notes);
  in.at("left_out").get_to(r.left_out);
  std::uint32_t* const figures[] = {&r.triangles,           &r.vertices, &r.patches, &r.patches_by_index,
                                    &r.patches_by_position, &r.chains,   &r.bones,   &r.simulated_bones};
  for (std::size_t i = 0; i < std::size(figures); ++i) in.at("figures").at(i).get_to(*figures[i]);
  return r;
}

std::vector<std::byte> bytes_of(const json& document) {
  const std::vector<std::uint8_t> cbor = json::to_cbor(document);
  const auto bytes = std::as_bytes(std::span(cbor));
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
  const json document = json::from_cbor(begin, begin + size);
  CacheEntry entry;
  document.at("dependencies").get_to(entry.dependencies);
  document.at("questions").get_to(entry.questions);
  entry.report = report_from(document.at("report"));
  entry.asset.assign(rest.begin() + std::ptrdiff_t(size), rest.end());
  return entry;
} catch (const std::exception&) {
  return {};  // a document of another shape
}

}  // namespace coif
