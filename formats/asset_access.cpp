// What tools and renderers ask of an open asset. Apart from open(), so that a program that only opens and simulates does
// not link it.
#include <coif/asset.h>

namespace coif {

const char* Asset::bone_name(std::uint32_t bone) const {
  if (bone >= bones_.size() || bones_[bone].name == kNone) return "";
  return names_.data() + bones_[bone].name;
}

std::uint32_t Asset::lod_count() const {
  if (!lods_.empty()) return std::uint32_t(lods_.size());
  return patches_.empty() ? 0 : 1;
}

std::span<const PatchRecord> Asset::lod_patches(std::uint32_t lod) const {
  if (lod >= lod_count()) return {};
  return lods_.empty() ? patches_ : patches_.subspan(lods_[lod].first_patch, lods_[lod].patch_count);
}

std::span<const std::uint32_t> Asset::lod_indices(std::uint32_t lod) const {
  const auto patches = lod_patches(lod);
  if (patches.empty()) return {};
  const std::uint32_t first = patches.front().first_index;
  return indices_.subspan(first, patches.back().first_index + patches.back().index_count - first);
}

std::uint32_t Asset::order_count() const {
  return indices_.empty() ? 0 : 1 + std::uint32_t(3 * orders_.size() / indices_.size());
}

const TextureRecord* Asset::texture(TextureRole role) const {
  for (const TextureRecord& texture : textures_) {
    if (texture.role == role) return &texture;
  }
  return nullptr;
}

std::span<const std::byte> Asset::texels(const TextureRecord& texture, std::uint32_t mip) const {
  std::uint64_t offset = texture.offset;
  for (std::uint32_t i = 0; i < mip; ++i) offset += mip_bytes(texture.format, texture.width, texture.height, i);
  return texels_.subspan(std::size_t(offset),
                         std::size_t(mip_bytes(texture.format, texture.width, texture.height, mip)));
}

}  // namespace coif
