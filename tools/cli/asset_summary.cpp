#include "cli/asset_summary.h"

#include "cli/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace coif {
namespace {

using nlohmann::ordered_json;

std::string chunk_name(std::uint32_t id) {
  std::string name;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const char c = static_cast<char>(id >> shift & 0xFF);
    name += c >= 0x20 && c < 0x7F ? c : '?';
  }
  return name;
}

struct Range {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();

  void add(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Smallest and largest value over the simulated bones: an artist sets curves and scalars, the asset has numbers.
ordered_json dynamics_ranges(const Asset& asset) {
  Range resistance, friction, gravity_scale, authoring_rate;
  for (std::size_t i = 0; i < asset.dynamics().size(); ++i) {
    if (asset.bones()[i].kind != BoneKind::kSimulated) continue;
    const DynamicsRecord& bone = asset.dynamics()[i];
    resistance.add(bone.resistance);
    friction.add(bone.friction);
    gravity_scale.add(bone.gravity_scale);
    authoring_rate.add(bone.authoring_rate);
  }
  ordered_json settings = ordered_json::object();
  const auto put = [&settings](const char* key, const Range& range) {
    if (range.low <= range.high) settings[key] = {range.low, range.high};
  };
  put("resistance", resistance);
  put("friction", friction);
  put("gravity_scale", gravity_scale);
  put("authoring_rate", authoring_rate);
  return settings;
}

ordered_json texture_list(const Asset& asset) {
  ordered_json list = ordered_json::array();
  for (const TextureRecord& texture : asset.textures()) {
    const char* role = texture.role == TextureRole::kBaseColor ? "base_color" : "shift_mask";
    list.push_back({{"role", role},
                    {"width", texture.width},
                    {"height", texture.height},
                    {"mips", texture.mip_count},
                    {"bytes", texture.bytes}});
  }
  return list;
}

ordered_json provenance(const ProvenanceRecord& record) {
  const auto version = [](const std::uint16_t(&v)[3]) { return fmt::format("{}.{}.{}", v[0], v[1], v[2]); };
  return {{"tool", version(record.tool_version)},
          {"importer", version(record.importer_version)},
          {"source_hash", fmt::format("{:016x}", record.source_hash)},
          {"recipe_hash", fmt::format("{:016x}", record.recipe_hash)}};
}

ordered_json summarize(const Asset& asset) {
  ordered_json chunks = ordered_json::array();
  for (const ChunkEntry& entry : asset.chunks()) {
    chunks.push_back({{"id", chunk_name(entry.id)}, {"bytes", entry.bytes}});
  }
  ordered_json summary = {{"format", {{"major", kAssetMajor}, {"minor", asset.minor()}}},
                          {"bytes", asset.total_bytes()},
                          {"chunks", std::move(chunks)},
                          {"triangles", asset.indices().size() / 3},
                          {"vertices", asset.vertices().size()},
                          {"patches", asset.patches().size()},
                          {"chains", asset.chains().size()},
                          {"bones", asset.bones().size()},
                          {"simulated_bones", asset.skeleton().simulated_count},
                          {"colliders", asset.colliders().size()},
                          {"textures", texture_list(asset)},
                          {"settings", dynamics_ranges(asset)}};
  if (asset.provenance()) summary["provenance"] = provenance(*asset.provenance());
  return summary;
}

}  // namespace

std::string asset_json(const Asset& asset) { return json_text(summarize(asset)); }

std::string asset_text(const std::string& name, const Asset& asset) {
  const ordered_json summary = summarize(asset);
  std::string text = fmt::format("{}: format {}.{}, {} bytes\n", name, summary["format"]["major"].get<int>(),
                                 summary["format"]["minor"].get<int>(), summary["bytes"].get<std::uint64_t>());
  for (const char* key : {"triangles", "vertices", "patches", "chains", "bones", "simulated_bones", "colliders"}) {
    text += fmt::format("  {:<16}{:>12}\n", key, summary[key].get<std::uint64_t>());
  }
  for (const auto& texture : summary["textures"]) {
    text += fmt::format("  {:<16}{:>12}\n", texture["role"].get<std::string>(),
                        fmt::format("{}x{}", texture["width"].get<int>(), texture["height"].get<int>()));
  }
  text += "settings (smallest .. largest over the simulated bones)\n";
  for (const auto& [key, range] : summary["settings"].items()) {
    text += fmt::format("  {:<16}{:>12.4g} .. {:.4g}\n", key, range[0].get<float>(), range[1].get<float>());
  }
  text += "chunks (bytes)\n";
  for (const auto& chunk : summary["chunks"]) {
    text += fmt::format("  {:<16}{:>12}\n", chunk["id"].get<std::string>(), chunk["bytes"].get<std::uint64_t>());
  }
  if (!summary.contains("provenance")) return text;
  text += "cooked by\n";
  for (const auto& [key, value] : summary["provenance"].items()) {
    text += fmt::format("  {:<16}{}\n", key, value.get<std::string>());
  }
  return text;
}

}  // namespace coif
