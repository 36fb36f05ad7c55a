#include "validate/find_issues.h"

#include "base/asset_refusal.h"
#include "cook/select/mesh_topology.h"
#include "cook/select/select_hair.h"
#include "cook/size/settle_size.h"
#include "cook/strands/patches.h"
#include "validate/asset_checks.h"
#include "write/chunk_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace coif {
namespace {

std::string place(const LoadStatus& status) {
  if (status.chunk == 0) return "";
  const std::string chunk = "chunk " + chunk_name(status.chunk);
  return status.code == LoadCode::kHash ? chunk : fmt::format("{}, record {}", chunk, status.item);
}

}  // namespace

Issues find_asset_issues(const Asset& asset) {
  Issues issues;
  for (const auto check : {check_bones, check_dynamics, check_geometry, check_patches, check_orders, check_skin,
                           check_textures, check_alpha, check_unwrapping, check_quality, check_origin}) {
    check(asset, issues);
  }
  return issues;
}

Issue refusal_issue(const LoadStatus& status) {
  return make_issue(fmt::format("A{}", 100 + int(status.code)), describe_text(status), place(status));
}

namespace {

using Version = std::uint16_t[3];

std::string text(const Version& v) { return fmt::format("{}.{}.{}", v[0], v[1], v[2]); }

void compare_hashes(const char* code, const char* what, std::uint64_t then, std::uint64_t now, Issues& issues) {
  if (then == now) return;
  add_issue(issues, code, "chunk PROV", "cooked from {} with the hash {:016x}; it now is {:016x}: cook again", what,
            then, now);
}

void compare_versions(const char* code, const char* what, const Version& then, const Version& now, Issues& issues) {
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

Issues find_origin_issues(const Asset& asset, const ProvenanceRecord& now) {
  const ProvenanceRecord* then = asset.provenance();
  if (then == nullptr) {
    return {make_issue("R105", "it does not say what it was cooked from; cook with \"scene.provenance\": true")};
  }
  Issues issues;
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

Issues find_recook_issues(const Asset& asset, const Asset& cooked_anew) {
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

void check_meshes(const SourceModel& source, const HairMesh& hair, const Recipe& recipe, Issues& issues) {
  bool rigid = true;
  for (const std::uint32_t mesh : hair.source_meshes) {
    rigid = rigid && source.meshes[mesh].influences.empty();
    if (!source.meshes[mesh].uvs.empty()) continue;
    add_issue(issues, "S203", fmt::format("mesh '{}'", source.meshes[mesh].name),
              "no texture coordinates; unwrap the strips along their length");
  }
  if (!rigid || !source.springs.empty() || recipe.chain_source == "none") return;
  add_issue(issues, "S204", "", "the hair follows no bone; chains will be fitted to it");
}

void check_size(const HairMesh& mesh, Issues& issues) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& at : mesh.positions) box.extend(at);
  if (is_hair_sized(largest_side(box))) return;
  add_issue(issues, "S205", "",
            "the hair is {:.3g} m large; hair has 0.05 .. 3 m: set \"source.metres_per_unit\" in the recipe",
            largest_side(box));
}

void check_strips(const HairMesh& mesh, const Recipe& recipe, Issues& issues) {
  const auto places = weld_places(mesh.positions, recipe.patch_weld_distance);
  const ExtractedPatches extracted = extract_patches(mesh, places, recipe.patch_connectivity);
  const std::size_t patches = extracted.patches.count;
  if (!is_shattered(mesh.triangle_count(), patches)) return;
  add_issue(issues, "S206", "", "{} triangles fall into {} patches by {}", mesh.triangle_count(), patches,
            extracted.chosen);
}

}  // namespace

Issue import_issue(const ToolError& error) {
  return make_issue(error.kind == ToolError::Kind::kUnsupported ? "S102" : "S101", error.message);
}

namespace {

const char* code_of(SizeDoubt::Of of) {
  switch (of) {
    case SizeDoubt::Of::kOtherUnit: return "S207";
    case SizeDoubt::Of::kDoubtfulUnit: return "S208";
    case SizeDoubt::Of::kOtherUp: return "S209";
    case SizeDoubt::Of::kDoubtfulUp: break;
  }
  return "S210";
}

}  // namespace

Issues find_source_issues(const SourceModel& imported, const Recipe& recipe) {
  Issues issues;
  for (const std::string& warning : imported.warnings) issues.push_back(make_issue("S201", warning));
  const JudgedSize size = judge_size(imported, recipe);
  for (const SizeDoubt& doubt : size.doubts) issues.push_back(make_issue(code_of(doubt.of), doubt.text));
  std::optional<SourceModel> resized;
  if (size.changes()) resized = settled(imported, size);
  const SourceModel& source = resized ? *resized : imported;
  Findings findings;
  const auto hair = select_hair(source, recipe, findings);
  if (!hair) {
    issues.push_back(make_issue("S104", hair.error().message));
    return issues;
  }
  for (const std::string& warning : findings.warnings) issues.push_back(make_issue("S202", warning));
  check_meshes(source, *hair, recipe, issues);
  check_size(*hair, issues);
  check_strips(*hair, recipe, issues);
  return issues;
}

}  // namespace coif
