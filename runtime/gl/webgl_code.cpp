#include "gl/webgl_code.h"

#include <coif/texel_blocks.h>

namespace coif {
namespace {

constexpr std::uint32_t kSide = 4;  // Texels of a block, each way.
constexpr std::size_t kChannels = 2, kChannelBytes = 8;
constexpr int kMaxValue = 2047;

/// Khronos Data Format Specification 1.3, table 115: distance of texels from their block's base. The second four of a
/// row are the mirror of the first four, less one.
constexpr std::int8_t kModifiers[16][4] = {{-3, -6, -9, -15}, {-3, -7, -10, -13}, {-2, -5, -8, -13}, {-2, -4, -6, -13},
                                           {-3, -6, -8, -12}, {-3, -7, -9, -11},  {-4, -7, -8, -11}, {-3, -5, -8, -11},
                                           {-2, -6, -8, -10}, {-2, -5, -8, -10},  {-2, -4, -8, -10}, {-2, -5, -7, -10},
                                           {-3, -4, -7, -10}, {-1, -2, -3, -10},  {-4, -6, -8, -9},  {-3, -5, -7, -9}};

int modifier_of(unsigned table, unsigned index) {
  const int far = kModifiers[table][index & 3];
  return index < 4 ? far : -far - 1;
}

/// One channel of a block: the bytes that its eight indices stand for.
class Channel {
 public:
  explicit Channel(const std::byte* code) {
    const int base = 8 * int(code[0]) + 4;
    const unsigned multiplier = unsigned(code[1]) >> 4, table = unsigned(code[1]) & 15;
    const int step = multiplier == 0 ? 1 : int(8 * multiplier);
    for (unsigned i = 0; i < 8; ++i) {
      int value = base + modifier_of(table, i) * step;
      value = value < 0 ? 0 : value > kMaxValue ? kMaxValue : value;
      values_[i] = std::byte((value * 510 + kMaxValue) / (2 * kMaxValue));
    }
    for (std::size_t i = 2; i < kChannelBytes; ++i) indices_ = indices_ << 8 | std::uint64_t(code[i]);
  }

  [[nodiscard]] std::byte at(std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t texel = column * kSide + row;  // Column by column, from the highest bits.
    return values_[indices_ >> (3 * (kSide * kSide - 1 - texel)) & 7];
  }

 private:
  std::byte values_[8];
  std::uint64_t indices_ = 0;
};

GLsizei side_of(std::uint32_t side, std::uint32_t mip) { return GLsizei(side >> mip > 0 ? side >> mip : 1); }

void send_blocks(const GlFunctions& gl, const Asset& asset, const TextureRecord& record, std::uint32_t mip,
                 std::span<std::byte> scratch) {
  constexpr std::size_t kBlockBytes = 16;
  const bool is_color = record.format == TexelFormat::kSrgb8Alpha8Etc2;
  const std::size_t texel_bytes = is_color ? 4 : kChannels;
  const GLsizei width = side_of(record.width, mip), height = side_of(record.height, mip);
  const std::span<const std::byte> texels = asset.texels(record, mip);
  const std::size_t row = (std::size_t(width) + kSide - 1) / kSide * kBlockBytes;
  // As many blocks at once as the memory holds.
  const auto most = GLsizei(scratch.size() / (kSide * kSide * texel_bytes) * kSide);
  for (GLsizei top = 0; top < height; top += GLsizei(kSide)) {
    const GLsizei rows = height - top < GLsizei(kSide) ? height - top : GLsizei(kSide);
    for (GLsizei left = 0; left < width; left += most) {
      const GLsizei columns = width - left < most ? width - left : most;
      const auto blocks = texels.subspan(std::size_t(top) / kSide * row + std::size_t(left) / kSide * kBlockBytes);
      is_color ? decode_color_rows(blocks, std::uint32_t(columns), scratch)
               : decode_eac_rows(blocks, std::uint32_t(columns), scratch);
      gl.TexSubImage2D(GL_TEXTURE_2D, GLint(mip), left, top, columns, rows, is_color ? GL_RGBA : GL_RG,
                       GL_UNSIGNED_BYTE, scratch.data());
    }
  }
}

/// Index number `place` over all orders, one after the other.
std::uint32_t index_at(const Asset& asset, std::size_t place) {
  const std::size_t first_order = asset.indices().size();
  if (place < first_order) return asset.indices()[place];
  const std::size_t triangle = asset.orders()[(place - first_order) / 3];
  return asset.indices()[3 * triangle + (place - first_order) % 3];
}

template <typename Index>
void send_as(const GlFunctions& gl, const Asset& asset, const DrawnHair& hair, std::span<std::byte> scratch) {
  Index* const indices = reinterpret_cast<Index*>(scratch.data());
  const std::size_t room = scratch.size() / sizeof(Index);
  const std::size_t count = std::size_t{hair.order_count} * hair.indices_of_order;
  for (std::size_t begin = 0; begin < count; begin += room) {
    const std::size_t some = count - begin < room ? count - begin : room;
    for (std::size_t i = 0; i < some; ++i) indices[i] = static_cast<Index>(index_at(asset, begin + i));
    gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, GLintptr(begin * sizeof(Index)), GLsizeiptr(some * sizeof(Index)),
                     indices);
  }
}

void send_indices(const GlFunctions& gl, const Asset& asset, const DrawnHair& hair, std::span<std::byte> scratch) {
  hair.index_bytes == sizeof(std::uint16_t) ? send_as<std::uint16_t>(gl, asset, hair, scratch)
                                            : send_as<std::uint32_t>(gl, asset, hair, scratch);
}

}  // namespace

void decode_eac_rows(std::span<const std::byte> blocks, std::uint32_t width, std::span<std::byte> out) {
  for (std::uint32_t left = 0; left < width; left += kSide) {
    const std::byte* const block = &blocks[left / kSide * kChannels * kChannelBytes];
    const std::uint32_t columns = width - left < kSide ? width - left : kSide;
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      const Channel decoded(block + channel * kChannelBytes);
      for (std::uint32_t row = 0; row < kSide; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
          out[(std::size_t{row} * width + left + column) * kChannels + channel] = decoded.at(column, row);
        }
      }
    }
  }
}

void decode_color_rows(std::span<const std::byte> blocks, std::uint32_t width, std::span<std::byte> out) {
  std::byte rgba[4 * kBlockTexels];
  for (std::uint32_t left = 0; left < width; left += kSide) {
    decode_color_block(&blocks[left / kSide * kColorBlockBytes], rgba);
    const std::size_t bytes = std::size_t{4} * (width - left < kSide ? width - left : kSide);
    for (std::uint32_t row = 0; row < kSide; ++row) {
      for (std::size_t i = 0; i < bytes; ++i) {
        out[4 * (std::size_t{row} * width + left) + i] = rgba[std::size_t{4} * row * kSide + i];
      }
    }
  }
}

const WebGlCode kWebGl = {send_indices, send_blocks};

}  // namespace coif
