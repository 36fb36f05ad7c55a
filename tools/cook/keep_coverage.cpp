#include "cook/keep_coverage.h"

#include "cook/alpha_mips.h"

#include <algorithm>
#include <cstring>

namespace coif {
namespace {

const TextureRecord* find_base_color(const AssetContents& contents) {
  const auto found = std::ranges::find(contents.textures, TextureRole::kBaseColor, &TextureRecord::role);
  return found == contents.textures.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Image> base_color_mips(const AssetContents& contents) {
  const TextureRecord* record = find_base_color(contents);
  if (record == nullptr) return {};
  std::vector<Image> mips;
  const std::byte* from = contents.texels.data() + record->offset;
  for (std::uint32_t level = 0; level < record->mip_count; ++level) {
    Image mip{std::max(1u, record->width >> level), std::max(1u, record->height >> level), 4, {}};
    mip.texels.resize(mip.texel_count() * 4);
    std::memcpy(mip.texels.data(), from, mip.texels.size());
    from += mip.texels.size();
    mips.push_back(std::move(mip));
  }
  return mips;
}

double threshold_in_texture(const MaterialRecord& material, double threshold) {
  const double factor = double(material.base_color[3]);
  return factor > 0 ? threshold / factor : 2;
}

void keep_coverage(std::span<const Image> used, AssetContents& contents) {
  std::vector<Image> mips = base_color_mips(contents);
  if (mips.empty() || contents.material.empty()) return;
  const MaterialRecord& material = contents.material[0];
  keep_alpha_coverage(mips, used, threshold_in_texture(material, double(material.opaque_threshold)));
  std::byte* to = contents.texels.data() + find_base_color(contents)->offset;
  for (const Image& mip : mips) {
    std::memcpy(to, mip.texels.data(), mip.texels.size());
    to += mip.texels.size();
  }
}

}  // namespace coif
