#pragma once

#include "cook/texture/image.h"
#include "platform/stop.h"

#include <coif/asset_records.h>

#include <vector>

namespace coif::cook {

/// Images with their mips in the form in which assets hold them.
struct StoredTextures {
  std::vector<TextureRecord> records;  ///< Offsets into `texels`.
  std::vector<std::byte> texels;

  /// `mips`: largest first. `threads` encode.
  void append(TextureRole role, TexelFormat format, std::span<const Image> mips, const platform::Threads& threads);
};

/// Bytes of an image of these dimensions with all its mips.
[[nodiscard]] std::uint64_t bytes_with_mips(TexelFormat format, const Image& image);

/// Encodes an image of two channels as unsigned EAC RG11: 16 bytes for each 4x4 texels, blocks row by row, red's half
/// first. Edges that are no multiple of four are padded with texels that the search ignores. The same bytes for any
/// number of threads. Source of the layout: Khronos Data Format Specification 1.3, "ETC2 Compressed Texture Image
/// Formats", "Format Unsigned R11 EAC" and "RG11 EAC".
[[nodiscard]] std::vector<std::uint8_t> encode_eac_rg11(const Image& image, const platform::Threads& threads);

}  // namespace coif::cook
