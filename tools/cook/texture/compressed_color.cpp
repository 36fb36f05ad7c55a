#include "cook/texture/compressed_color.h"

#include "base/color_texels.h"
#include "base/parallel_for.h"
#include "cook/recipe/drawn_recipe.h"
#include "cook/texture/color_block.h"

#include <coif/texel_blocks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coif::cook {
namespace {

/// Smaller textures cost little as they are.
constexpr std::uint64_t kLargeTexels = 1 << 20;
/// Peak signal to noise, decibels: of colours as they are seen, and of alphas.
constexpr double kLeastColorDb = 32, kLeastAlphaDb = 34;

struct BlockError {
  double color_db = INFINITY, alpha_db = INFINITY;
};

double decibels(double squares, double count) {
  return squares > 0 ? 10 * std::log10(255.0 * 255.0 * count / squares) : INFINITY;
}

/// Colours count by alpha.
BlockError error_of(std::span<const std::byte> texels, std::span<const std::byte> decoded) {
  double color = 0, color_weight = 0, alpha = 0;
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    const auto difference = [&](std::size_t k) {
      return double(std::to_integer<int>(texels[i + k]) - std::to_integer<int>(decoded[i + k]));
    };
    const double weight = std::to_integer<int>(texels[i + 3]);
    for (std::size_t k = 0; k < 3; ++k) color += weight * difference(k) * difference(k);
    color_weight += 3 * weight;
    alpha += difference(3) * difference(3);
  }
  return {decibels(color, color_weight), decibels(alpha, double(texels.size()) / 4)};
}

ColorBlock block_at(const Image& image, std::uint32_t left, std::uint32_t top) {
  ColorBlock block;
  for (std::uint32_t y = 0; y < kBlockSide; ++y) {
    for (std::uint32_t x = 0; x < kBlockSide; ++x) {
      const std::size_t column = std::min(left + x, image.width - 1), row = std::min(top + y, image.height - 1);
      std::memcpy(block[y * kBlockSide + x].data(), &image.texels[4 * (row * image.width + column)], 4);
    }
  }
  return block;
}

Image mip_of(const AssetContents& contents, const TextureRecord& record, std::uint32_t mip, std::uint64_t offset) {
  Image image{std::max(record.width >> mip, 1u), std::max(record.height >> mip, 1u), 4, {}};
  const auto* const first = reinterpret_cast<const std::uint8_t*>(contents.texels.data() + offset);
  image.texels.assign(first, first + mip_bytes(record.format, record.width, record.height, mip));
  return image;
}

/// All mips of the texture, one after the other.
std::vector<std::uint8_t> blocks_of(const AssetContents& contents, const TextureRecord& record,
                                    const platform::Threads& threads) {
  std::vector<std::uint8_t> blocks;
  std::uint64_t offset = record.offset;
  for (std::uint32_t mip = 0; mip < record.mip_count; ++mip) {
    const auto encoded = encode_color(mip_of(contents, record, mip, offset), threads);
    blocks.insert(blocks.end(), encoded.begin(), encoded.end());
    offset += mip_bytes(record.format, record.width, record.height, mip);
  }
  return blocks;
}

/// Puts `blocks` in the place of the texture's texels, and moves what follows.
void replace(TextureRecord& record, std::span<const std::uint8_t> blocks, AssetContents& contents) {
  std::vector<std::byte> texels;
  for (TextureRecord& each : contents.textures) {
    texels.resize((texels.size() + 63) / 64 * 64);
    const std::uint64_t offset = texels.size();
    const auto own = std::span(contents.texels).subspan(std::size_t(each.offset), std::size_t(each.bytes));
    const auto stored = &each == &record ? std::as_bytes(blocks) : std::span<const std::byte>(own);
    texels.insert(texels.end(), stored.begin(), stored.end());
    each.offset = offset;
    each.bytes = stored.size();
  }
  record.format = TexelFormat::kSrgb8Alpha8Etc2;
  contents.texels = std::move(texels);
}

}  // namespace

std::vector<std::uint8_t> encode_color(const Image& image, const platform::Threads& threads) {
  const std::uint32_t columns = (image.width + kBlockSide - 1) / kBlockSide;
  const std::uint32_t rows = (image.height + kBlockSide - 1) / kBlockSide;
  std::vector<std::uint8_t> bytes(std::size_t(columns) * rows * kColorBlockBytes);
  parallel_for(rows, threads, [&](std::size_t row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      encode_color_block(block_at(image, column * kBlockSide, std::uint32_t(row) * kBlockSide),
                         &bytes[(row * columns + column) * kColorBlockBytes]);
    }
  });
  return bytes;
}

void compress_color(const DrawnRecipe& recipe, const platform::Threads& threads, AssetContents& contents,
                    Findings& findings) {
  const auto record = std::ranges::find(contents.textures, TextureRole::kBaseColor, &TextureRecord::role);
  if (record == contents.textures.end() || recipe.color_format == ColorFormat::kRgba8) return;
  const bool is_asked = recipe.color_format == ColorFormat::kEtc2;
  if (!is_asked && std::uint64_t{record->width} * record->height < kLargeTexels) return;
  const std::vector<std::uint8_t> blocks = blocks_of(contents, *record, threads);
  const Image finest = mip_of(contents, *record, 0, record->offset);
  const auto decoded =
      decode_color_blocks(reinterpret_cast<const std::byte*>(blocks.data()), record->width, record->height);
  const BlockError error = error_of(std::as_bytes(std::span(finest.texels)), decoded);
  const std::string found = fmt::format("{:.1f} dB in colour, {:.1f} dB in alpha", error.color_db, error.alpha_db);
  if (!is_asked && (error.color_db < kLeastColorDb || error.alpha_db < kLeastAlphaDb)) {
    return findings.note(fmt::format("colours: stored whole, in blocks (ETC2) they would be {} away", found));
  }
  replace(*record, blocks, contents);
  findings.note(fmt::format("colours: stored in blocks (ETC2), a quarter of their bytes, {} away", found));
}

}  // namespace coif::cook
