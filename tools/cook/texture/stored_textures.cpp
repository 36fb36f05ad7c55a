#include "cook/texture/stored_textures.h"

namespace coif::cook {

std::uint64_t bytes_with_mips(TexelFormat format, const Image& image) {
  std::uint64_t bytes = 0;
  for (std::uint32_t mip = 0; std::max(image.width, image.height) >> mip > 0; ++mip) {
    bytes += mip_bytes(format, image.width, image.height, mip);
  }
  return bytes;
}

void StoredTextures::append(TextureRole role, TexelFormat format, std::span<const Image> mips,
                            const platform::Threads& threads) {
  texels.resize((texels.size() + 63) / 64 * 64);
  TextureRecord record{};
  record.role = role;
  record.format = format;
  record.width = mips[0].width;
  record.height = mips[0].height;
  record.mip_count = std::uint32_t(mips.size());
  record.offset = texels.size();
  for (const Image& mip : mips) {
    const auto encoded = format == TexelFormat::kRg11Eac ? encode_eac_rg11(mip, threads) : mip.texels;
    const auto bytes = std::as_bytes(std::span(encoded));
    texels.insert(texels.end(), bytes.begin(), bytes.end());
  }
  record.bytes = texels.size() - record.offset;
  records.push_back(record);
}

}  // namespace coif::cook
