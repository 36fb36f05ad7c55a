#include "cli/asset_summary.h"

#include "base/collider_shapes.h"
#include "base/hair_runtime.h"
#include "base/json.h"
#include "base/text.h"
#include "cook/texture/alpha.h"
#include "write/strip_asset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace coif::cli {
namespace {

using nlohmann::ordered_json;

struct BoneSetting {
  const char* name;
  float DynamicsRecord::*value;
  double scale = 1;  ///< Factor to the unit that is printed: the recipe's.
};

constexpr BoneSetting kBoneSettings[] = {
    {"resistance", &DynamicsRecord::resistance},
    {"friction", &DynamicsRecord::friction},
    {"gravity_scale", &DynamicsRecord::gravity_scale},
    {"authoring_rate", &DynamicsRecord::authoring_rate},
    {"hit_radius", &DynamicsRecord::hit_radius},
    {"stiffness", &DynamicsRecord::stiffness},
    {"damping", &DynamicsRecord::damping},
    {"torsion", &DynamicsRecord::torsion},
    {"angle_limit", &DynamicsRecord::angle_limit, 180 / std::numbers::pi},
    {"parent_share", &DynamicsRecord::parent_share},
};

std::vector<DynamicsRecord> simulated_dynamics(const Asset& asset) {
  std::vector<DynamicsRecord> dynamics;
  for (std::size_t i = 0; i < asset.dynamics().size(); ++i) {
    if (asset.bones()[i].kind == BoneKind::kSimulated) dynamics.push_back(asset.dynamics()[i]);
  }
  return dynamics;
}

/// Smallest and largest value over the simulated bones: an artist sets curves and scalars, the asset has numbers.
ordered_json dynamics_ranges(const Asset& asset) {
  ordered_json settings = ordered_json::object();
  const std::vector<DynamicsRecord> moving = simulated_dynamics(asset);
  if (moving.empty()) return settings;
  for (const BoneSetting& setting : kBoneSettings) {
    std::vector<float> values;
    for (const DynamicsRecord& dynamics : moving) values.push_back(float(dynamics.*setting.value * setting.scale));
    settings[setting.name] = {std::ranges::min(values), std::ranges::max(values)};
  }
  return settings;
}

constexpr const char* kTextureRoles[] = {"base_color", "shift_mask", "normal", "strand_axis"};  // as TextureRole
constexpr const char* kTexelFormats[] = {"rgba8", "rg8", "eac_rg11", "etc2_rgba8"};             // as TexelFormat

/// The mips of the base colour with the coverage of each: hair that loses coverage gets thin with distance.
ordered_json mip_list(const TextureRecord& texture, const std::vector<cook::AlphaCoverage>& coverage) {
  ordered_json list = ordered_json::array();
  for (std::uint32_t level = 0; level < texture.mip_count; ++level) {
    list.push_back(
        {{"width", std::max(1u, texture.width >> level)}, {"height", std::max(1u, texture.height >> level)}});
    if (texture.role != TextureRole::kBaseColor || coverage.empty()) continue;
    list.back()["coverage_pct"] = 100 * coverage[level].opaque;
    list.back()["opacity_pct"] = 100 * coverage[level].opacity;
  }
  return list;
}

ordered_json texture_list(const Asset& asset) {
  const std::vector<cook::AlphaCoverage> coverage = cook::mip_coverage(asset);
  ordered_json list = ordered_json::array();
  for (const auto& textures : {asset.textures(), asset.reliefs()}) {
    for (const TextureRecord& texture : textures) {
      list.push_back({{"role", kTextureRoles[std::size_t(texture.role)]},
                      {"format", kTexelFormats[std::size_t(texture.format)]},
                      {"width", texture.width},
                      {"height", texture.height},
                      {"mips", mip_list(texture, coverage)},
                      {"bytes", texture.bytes}});
    }
  }
  return list;
}

ordered_json lod_list(const Asset& asset) {
  ordered_json list = ordered_json::array();
  for (std::uint32_t i = 0; i < asset.stored_lods().size(); ++i) {
    const LodRecord& lod = asset.stored_lods()[i];
    const auto simulated = std::ranges::count_if(asset.lod_bones(), [i](std::uint8_t levels) { return levels > i; });
    list.push_back({{"triangles", asset.lod_indices(i).size() / 3},
                    {"patches", lod.patch_count},
                    {"simulated_bones", simulated},
                    {"screen_size", lod.screen_size},
                    {"error", lod.error}});
  }
  return list;
}

/// The shapes that occur, with their counts; colliders that keep hair inside also count under that name.
ordered_json collider_shapes(std::span<const ColliderRecord> colliders) {
  ordered_json shapes = ordered_json::object();
  for (const ColliderRecord& collider : colliders) {
    const auto count = [&shapes](const char* name) { shapes[name] = shapes.value(name, 0) + 1; };
    count(plural_of(collider.shape));
    if ((collider.flags & kColliderKeepsInside) != 0) count("keep_inside");
  }
  return shapes;
}

/// The body bones, by the names that a host finds them by, and the body colliders that hair may touch.
ordered_json body_json(const Asset& asset) {
  ordered_json bones = ordered_json::array();
  for (std::uint32_t i = 0; i < asset.body_bones().size(); ++i) {
    bones.push_back({{"name", clean_text(asset.body_bone_name(i))},
                     {"colliders", std::ranges::count(asset.body_colliders(), i, &ColliderRecord::bone)}});
  }
  return {{"bones", std::move(bones)},
          {"colliders", asset.body_colliders().size()},
          {"collider_shapes", collider_shapes(asset.body_colliders())},
          {"colliding_bones", std::ranges::count_if(asset.body_sets(), [](std::uint32_t set) { return set != 0; })}};
}

/// Kinds that occur, each with the number of its bones.
ordered_json limits_json(const Asset& asset) {
  constexpr std::pair<LimitKind, const char*> kKinds[] = {
      {LimitKind::kCone, "cone"}, {LimitKind::kHinge, "hinge"}, {LimitKind::kSpherical, "spherical"}};
  ordered_json limits = ordered_json::object();
  for (const auto& [kind, name] : kKinds) {
    const auto count = std::ranges::count(asset.limits(), kind, &LimitRecord::kind);
    if (count > 0) limits[name] = count;
  }
  return limits;
}

ordered_json links_json(const Asset& asset) {
  std::set<std::uint32_t> chains;
  for (const LinkRecord& l : asset.links()) chains.insert({asset.bones()[l.bone].chain, asset.bones()[l.to].chain});
  return {{"count", asset.links().size()}, {"chains", chains.size()}};
}

std::ptrdiff_t colliding_bones(const Asset& asset) {
  return std::ranges::count_if(asset.bones(), [](const BoneRecord& bone) { return bone.colliders != 0; });
}

/// Counts the bones that carry a twist from step to step; the frames of all others are shortest arcs.
std::size_t passive_bones(const Asset& asset) {
  std::size_t count = 0;
  for (const ChainRecord& chain : asset.chains()) count += chain.model == ChainModel::kPassive ? chain.bone_count : 0;
  return count;
}

const char* model_of(const Asset& asset) {
  const std::size_t passive = passive_bones(asset);
  if (passive == 0) return "cascade";
  return passive == asset.skeleton().simulated_count ? "passive" : "mixed";
}

std::ptrdiff_t twisting_bones(const Asset& asset) {
  return std::ranges::count_if(simulated_dynamics(asset),
                               [](const DynamicsRecord& bone) { return bone.torsion < kShortestArc; });
}

ordered_json provenance(const ProvenanceRecord& record) {
  const auto version = [](const std::uint16_t(&v)[3]) { return fmt::format("{}.{}.{}", v[0], v[1], v[2]); };
  const bool is_draft = (record.flags & kProvenanceDraft) != 0;
  return {{"tool", version(record.tool_version)},
          {"importer", version(record.importer_version)},
          {"source_hash", fmt::format("{:016x}", record.source_hash)},
          {"recipe_hash", fmt::format("{:016x}", record.recipe_hash)},
          {"made", is_draft ? "draft" : "in full"}};
}

ordered_json summarize(const Asset& asset) {
  ordered_json chunks = ordered_json::array();
  for (const ChunkEntry& entry : asset.chunks()) {
    chunks.push_back({{"id", chunk_name(entry.id)}, {"bytes", entry.bytes}});
  }
  ordered_json summary = {{"format", {{"major", kAssetMajor}, {"minor", asset.minor()}}},
                          {"bytes", asset.total_bytes()},
                          {"chunks", std::move(chunks)},
                          {"triangles", asset.lod_indices(0).size() / 3},
                          {"vertices", asset.vertices().size()},
                          {"patches", asset.lod_patches(0).size()},
                          {"orders", asset.order_count()},
                          {"chains", asset.chains().size()},
                          {"bones", asset.bones().size()},
                          {"simulated_bones", asset.skeleton().simulated_count},
                          {"passive_bones", passive_bones(asset)},
                          {"twisting_bones", twisting_bones(asset)},
                          {"colliders", asset.colliders().size()},
                          {"collider_shapes", collider_shapes(asset.colliders())},
                          {"colliding_bones", colliding_bones(asset)},
                          {"lods", lod_list(asset)},
                          {"textures", texture_list(asset)},
                          {"settings", dynamics_ranges(asset)},
                          {"quality", quality_json(asset)}};
  if (!asset.body_colliders().empty()) summary["body"] = body_json(asset);
  if (!asset.limits().empty()) summary["limits"] = limits_json(asset);
  if (!asset.links().empty()) summary["links"] = links_json(asset);
  if (!asset.chains().empty()) summary["model"] = model_of(asset);
  if (asset.tuning() != nullptr) summary["settings"]["tuning"] = tuning_json(asset);
  if (asset.material() != nullptr) {
    summary["sides"] = (asset.material()->flags & kMaterialDoubleSided) != 0 ? "both" : "front";
    summary["shading"] = name_of(asset.material()->shading);
  }
  if (asset.provenance()) summary["provenance"] = provenance(*asset.provenance());
  return summary;
}

std::string count_line(const std::string& name, const ordered_json& count) {
  return fmt::format("  {:<16}{:>12}\n", name, count.get<std::uint64_t>());
}

/// Empty where there are no body colliders, limits and links.
std::string bounds_text(const ordered_json& summary) {
  std::string text;
  if (summary.contains("body")) {
    const ordered_json& body = summary["body"];
    text += count_line("body_colliders", body["colliders"]);
    for (const auto& [shape, count] : body["collider_shapes"].items()) text += count_line("  " + shape, count);
    for (const ordered_json& bone : body["bones"]) {
      text += fmt::format("    on '{}': {}\n", bone["name"].get<std::string>(), bone["colliders"].get<int>());
    }
    text += count_line("body_touching", body["colliding_bones"]);
  }
  if (summary.contains("limits")) {
    for (const auto& [kind, count] : summary["limits"].items()) text += count_line("limit_" + kind, count);
  }
  if (!summary.contains("links")) return text;
  return text + count_line("links", summary["links"]["count"]) +
         count_line("linked_chains", summary["links"]["chains"]);
}

std::string texture_line(const ordered_json& texture) {
  const std::string size = fmt::format("{}x{}", texture["width"].get<int>(), texture["height"].get<int>());
  return fmt::format("  {:<16}{:>12} {}\n", texture["role"].get<std::string>(), size,
                     texture["format"].get<std::string>());
}

std::string lod_table(const ordered_json& lods) {
  if (lods.empty()) return {};
  std::string text = "levels of detail (from screen size: triangles, patches, simulated bones; error)\n";
  for (std::size_t i = 0; i < lods.size(); ++i) {
    const ordered_json& lod = lods[i];
    text += fmt::format("  {:<4}{:>12.3g}: {:>8} {:>6} {:>4}; {:.2g} mm\n", i, lod["screen_size"].get<float>(),
                        lod["triangles"].get<std::uint64_t>(), lod["patches"].get<std::uint64_t>(),
                        lod["simulated_bones"].get<int>(), 1000 * lod["error"].get<float>());
  }
  return text;
}

}  // namespace

std::string asset_json(const Asset& asset) { return json_text(summarize(asset)); }

std::string asset_text(const std::string& name, const Asset& asset) {
  const ordered_json summary = summarize(asset);
  std::string text = fmt::format("{}: format {}.{}, {} bytes\n", name, summary["format"]["major"].get<int>(),
                                 summary["format"]["minor"].get<int>(), summary["bytes"].get<std::uint64_t>());
  for (const char* key : {"triangles", "vertices", "patches", "orders", "chains", "bones", "simulated_bones",
                          "passive_bones", "twisting_bones", "colliders"}) {
    text += count_line(key, summary[key]);
  }
  for (const auto& [shape, count] : summary["collider_shapes"].items()) text += count_line("  " + shape, count);
  text += count_line("colliding_bones", summary["colliding_bones"]);
  text += bounds_text(summary);
  for (const auto& texture : summary["textures"]) text += texture_line(texture);
  for (const char* key : {"model", "sides", "shading"}) {
    if (summary.contains(key)) text += fmt::format("  {:<16}{:>12}\n", key, summary[key].get<std::string>());
  }
  text += lod_table(summary["lods"]);
  text += "settings (smallest .. largest over the simulated bones)\n";
  const ordered_json ranges = dynamics_ranges(asset);
  for (const auto& [key, range] : ranges.items()) {
    text += fmt::format("  {:<16}{:>12.4g} .. {:.4g}\n", key, range[0].get<float>(), range[1].get<float>());
  }
  text += tuning_text(asset);
  text += "chunks (bytes)\n";
  for (const auto& chunk : summary["chunks"]) text += count_line(chunk["id"].get<std::string>(), chunk["bytes"]);
  if (!summary.contains("provenance")) return text;
  text += "cooked by\n";
  for (const auto& [key, value] : summary["provenance"].items()) {
    text += fmt::format("  {:<16}{}\n", key, value.get<std::string>());
  }
  return text;
}

}  // namespace coif::cli
