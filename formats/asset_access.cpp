// What tools and renderers ask of an open asset. Apart from open(), so that a program that only opens and simulates
// does not link it.
#include <coif/asset.h>

namespace coif {

const char* Asset::bone_name(std::uint32_t bone) const {
  if (bone >= bones().size() || bones()[bone].name == kNone) return "";
  return records<chunk::kNames>().data() + bones()[bone].name;
}

const char* Asset::body_bone_name(std::uint32_t body_bone) const {
  return body_bone < body_bones().size() ? records<chunk::kNames>().data() + body_bones()[body_bone].name : "";
}

std::uint32_t Asset::lod_count() const {
  if (!stored_lods().empty()) return std::uint32_t(stored_lods().size());
  return patches().empty() ? 0 : 1;
}

std::span<const PatchRecord> Asset::lod_patches(std::uint32_t lod) const {
  if (lod >= lod_count()) return {};
  return stored_lods().empty() ? patches()
                               : patches().subspan(stored_lods()[lod].first_patch, stored_lods()[lod].patch_count);
}

std::span<const std::uint32_t> Asset::lod_indices(std::uint32_t lod) const {
  const auto drawn = lod_patches(lod);
  if (drawn.empty()) return {};
  const std::uint32_t first = drawn.front().first_index;
  return indices().subspan(first, drawn.back().first_index + drawn.back().index_count - first);
}

std::uint32_t Asset::order_count() const {
  return indices().empty() ? 0 : 1 + std::uint32_t(3 * orders().size() / indices().size());
}

const TextureRecord* Asset::texture(TextureRole role) const {
  for (const TextureRecord& texture : is_relief(role) ? reliefs() : textures()) {
    if (texture.role == role) return &texture;
  }
  return nullptr;
}

std::span<const std::byte> Asset::texels(const TextureRecord& texture, std::uint32_t mip) const {
  std::uint64_t offset = texture.offset;
  for (std::uint32_t i = 0; i < mip; ++i) offset += mip_bytes(texture.format, texture.width, texture.height, i);
  const std::uint64_t bytes = mip_bytes(texture.format, texture.width, texture.height, mip);
  const auto all = is_relief(texture.role) ? records<chunk::kReliefTexels>() : records<chunk::kTexels>();
  return all.subspan(std::size_t(offset), std::size_t(bytes));
}

}  // namespace coif
