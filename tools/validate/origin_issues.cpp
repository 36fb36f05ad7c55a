#include "validate/origin_issues.h"

#include "write/chunk_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

using Version = std::uint16_t[3];

std::string text(const Version& v) { return fmt::format("{}.{}.{}", v[0], v[1], v[2]); }

void compare_hashes(const char* code, const char* what, std::uint64_t then, std::uint64_t now,
                    std::vector<Issue>& issues) {
  if (then == now) return;
  issues.push_back(make_issue(
      code, fmt::format("cooked from {} with the hash {:016x}; it now is {:016x}: cook again", what, then, now),
      "chunk PROV"));
}

void compare_versions(const char* code, const char* what, const Version& then, const Version& now,
                      std::vector<Issue>& issues) {
  if (std::ranges::equal(then, now)) return;
  issues.push_back(
      make_issue(code, fmt::format("cooked by {} {}; this is {}", what, text(then), text(now)), "chunk PROV"));
}

const ChunkEntry* find_chunk(const Asset& asset, std::uint32_t id) {
  const auto found = std::ranges::find(asset.chunks(), id, &ChunkEntry::id);
  return found == asset.chunks().end() ? nullptr : &*found;
}

bool same_chunk(const Asset& a, const Asset& b, std::uint32_t id) {
  const ChunkEntry* in_a = find_chunk(a, id);
  const ChunkEntry* in_b = find_chunk(b, id);
  return in_a != nullptr && in_b != nullptr && in_a->bytes == in_b->bytes && in_a->hash == in_b->hash;
}

}  // namespace

std::vector<Issue> find_origin_issues(const Asset& asset, const ProvenanceRecord& now) {
  std::vector<Issue> issues;
  const ProvenanceRecord* then = asset.provenance();
  if (then == nullptr) {
    issues.push_back(
        make_issue("R105", "it does not say what it was cooked from; cook with \"scene.provenance\": true"));
    return issues;
  }
  compare_hashes("R101", "a source", then->source_hash, now.source_hash, issues);
  compare_hashes("R102", "a recipe", then->recipe_hash, now.recipe_hash, issues);
  if (!issues.empty()) return issues;
  compare_versions("R103", "version", then->tool_version, now.tool_version, issues);
  compare_versions("R104", "the importer's version", then->importer_version, now.importer_version, issues);
  return issues;
}

std::vector<Issue> find_recook_issues(const Asset& asset, const Asset& cooked_anew) {
  std::vector<std::uint32_t> ids;
  for (const Asset* side : {&asset, &cooked_anew}) {
    std::ranges::transform(side->chunks(), std::back_inserter(ids), &ChunkEntry::id);
  }
  std::string different;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool known =
        std::find(ids.begin(), ids.begin() + std::ptrdiff_t(i), ids[i]) != ids.begin() + std::ptrdiff_t(i);
    if (known || ids[i] == chunk::kProvenance || same_chunk(asset, cooked_anew, ids[i])) continue;
    different += (different.empty() ? "" : ", ") + chunk_name(ids[i]);
  }
  if (different.empty()) return {};
  return {make_issue("R106", fmt::format("cooked anew, it has other chunks {}; use the new one", different))};
}

}  // namespace coif
