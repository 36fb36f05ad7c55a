#include "validate/find_issues.h"

#include "base/asset_refusal.h"
#include "cook/select/mesh_topology.h"
#include "cook/select/select_hair.h"
#include "cook/size/settle_size.h"
#include "cook/strands/patches.h"
#include "validate/asset_checks.h"
#include "write/strip_asset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace coif::validate {
namespace {

std::string place(const LoadStatus& status) {
  if (status.chunk == 0) return "";
  const std::string chunk = "chunk " + chunk_name(status.chunk);
  return status.code == LoadCode::kHash ? chunk : fmt::format("{}, record {}", chunk, status.item);
}

}  // namespace

Diagnostics find_asset_issues(const Asset& asset) {
  Diagnostics issues;
  for (const auto check : {check_bones, check_dynamics, check_geometry, check_patches, check_orders, check_skin,
                           check_textures, check_alpha, check_unwrapping, check_quality, check_origin}) {
    check(asset, issues);
  }
  return issues;
}

Diagnostic refusal_issue(const LoadStatus& status) {
  return make_issue(fmt::format("A{}", 100 + int(status.code)), describe_text(status), place(status));
}

namespace {

using Version = std::uint16_t[3];

std::string text(const Version& v) { return fmt::format("{}.{}.{}", v[0], v[1], v[2]); }

void compare_hashes(const char* code, const char* what, std::uint64_t then, std::uint64_t now, Diagnostics& issues) {
  if (then == now) return;
  add_issue(issues, code, "chunk PROV", "cooked from {} with the hash {:016x}; it now is {:016x}: cook again", what,
            then, now);
}

void compare_versions(const char* code, const char* what, const Version& then, const Version& now,
                      Diagnostics& issues) {
  if (std::ranges::equal(then, now)) return;
  add_issue(issues, code, "chunk PROV", "cooked by {} {}; this is {}", what, text(then), text(now));
}

/// The asset has a chunk of this name and content.
bool has_chunk(const Asset& asset, const ChunkEntry& other) {
  return std::ranges::any_of(asset.chunks(), [&](const ChunkEntry& entry) {
    return entry.id == other.id && entry.bytes == other.bytes && entry.hash == other.hash;
  });
}

}  // namespace

Diagnostics find_origin_issues(const Asset& asset, const ProvenanceRecord& now) {
  const ProvenanceRecord* then = asset.provenance();
  if (then == nullptr) {
    return {make_issue("R105", "it does not say what it was cooked from; cook with \"scene.provenance\": true")};
  }
  Diagnostics issues;
  compare_hashes("R101", "a source", then->source_hash, now.source_hash, issues);
  if (is_draft(asset)) {
    issues.push_back(make_issue("R107", "it was cooked with --draft; cook it in full", "chunk PROV"));
    return issues;
  }
  compare_hashes("R102", "a recipe", then->recipe_hash, now.recipe_hash, issues);
  if (!issues.empty()) return issues;
  compare_versions("R103", "version", then->tool_version, now.tool_version, issues);
  compare_versions("R104", "the importer's version", then->importer_version, now.importer_version, issues);
  return issues;
}

Diagnostics find_recook_issues(const Asset& asset, const Asset& cooked_anew) {
  std::vector<std::string> different;
  const auto compare = [&different](const Asset& one, const Asset& other) {
    for (const ChunkEntry& entry : one.chunks()) {
      const std::string name = chunk_name(entry.id);
      const bool told = entry.id == chunk::kProvenance || std::ranges::find(different, name) != different.end();
      if (!told && !has_chunk(other, entry)) different.push_back(name);
    }
  };
  compare(asset, cooked_anew);
  compare(cooked_anew, asset);
  if (different.empty()) return {};
  return {make_issue("R106",
                     fmt::format("cooked anew, it has other chunks {}; use the new one", fmt::join(different, ", ")))};
}

namespace {

void note_meshes(const importer::SourceModel& source, const cook::HairMesh& hair, const cook::Recipe& recipe,
                 Diagnostics& issues) {
  bool rigid = true;
  for (const std::uint32_t mesh : hair.source_meshes) {
    rigid = rigid && source.meshes[mesh].influences.empty();
    if (!source.meshes[mesh].uvs.empty()) continue;
    add_issue(issues, "S203", fmt::format("mesh '{}'", source.meshes[mesh].name),
              "no texture coordinates; unwrap the strips along their length");
  }
  if (!rigid || !source.springs.empty() || recipe.chain_source == cook::ChainSource::kNoChains) return;
  add_issue(issues, "S204", "", "the hair follows no bone; chains will be fitted to it");
}

void warn_of_strips(const cook::HairMesh& mesh, const cook::Recipe& recipe, cook::Findings& findings) {
  const auto places = cook::weld_places(mesh.positions, recipe.patch_weld_distance);
  const cook::ExtractedPatches extracted = cook::extract_patches(mesh, places, recipe.patch_connectivity);
  cook::warn_of_fragments(mesh, extracted.patches.count, extracted.chosen, findings);
}

}  // namespace

Diagnostic import_issue(const ToolError& error) {
  return make_issue(error.kind == ToolError::Kind::kUnsupported ? "S102" : "S101", error.message);
}

Diagnostics cook_issues(const cook::Findings& findings) {
  Diagnostics issues;
  for (const Diagnostic& warning : findings.warnings)
    issues.push_back(make_issue(warning.code, warning.message, warning.place));
  return issues;
}

Diagnostics find_source_issues(const importer::SourceModel& imported, const cook::Recipe& recipe) {
  cook::Findings findings;
  findings.warnings = imported.warnings;
  const cook::SettledSource settled = cook::settle_size(imported, recipe, findings);
  const importer::SourceModel& source = settled.model ? *settled.model : imported;
  const auto hair = cook::select_hair(source, recipe, findings);
  Diagnostics notes;
  if (hair) {
    cook::warn_of_odd_size(*hair, findings);
    warn_of_strips(*hair, recipe, findings);
    note_meshes(source, *hair, recipe, notes);
  } else {
    notes.push_back(make_issue("S104", hair.error().message));
  }
  findings.acknowledge(recipe.acknowledged_warnings);
  Diagnostics issues = cook_issues(findings);
  issues.insert(issues.end(), notes.begin(), notes.end());
  return issues;
}

Diagnostics find_source_issues(const importer::SourceModel& imported, const cook::Recipe& recipe,
                               const tl::expected<cook::CookResult, ToolError>& cooked) {
  Diagnostics first = find_source_issues(imported, recipe);
  if (!cooked) {
    const bool is_told = std::ranges::any_of(first, [](const Diagnostic& issue) { return issue.code == "S104"; });
    if (!is_told) first.push_back(make_issue("S105", cooked.error().message));
    return first;
  }
  // The whole cook's messages replace those of its first passes.
  Diagnostics issues = cook_issues(cooked->report);
  std::ranges::copy_if(first, std::back_inserter(issues),
                       [](const Diagnostic& issue) { return issue.severity == Severity::kInfo; });
  return issues;
}

}  // namespace coif::validate
