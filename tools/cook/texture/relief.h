#pragma once

#include "base/encodings.h"
#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/texture/image.h"
#include "platform/stop.h"

#include <coif/asset_records.h>

#include <vector>

namespace coif::cook {

/// Where green of a normal map leads as it grows: up the image, as glTF and OpenGL have it, or down, as DirectX has.
enum class GreenAxis { kUp, kDown };

/// What is known of a map before its texels are looked at.
struct NormalMapUse {
  std::optional<GreenAxis> green;  ///< None: found from the map.
  double strength = 1;             ///< Multiplies slopes; 0 or more.
};

struct NormalMap {
  Image normals;      ///< Two channels: TextureRole::kNormal.
  std::string found;  ///< What kind of map it was taken for, for messages: "a normal map, green up (...)".
};

/// Reads an RGBA image as a map of normals in the texture's own axes, or as one of heights, which is grey all over.
/// Heights have no unit: their slopes are scaled to a common steepness.
///
/// Which way green leads shows in the map itself where nobody says it. Normals are those of a surface of heights, so
/// that the change of one slope along the other axis and of the other along the first are the same; with green turned
/// round they are opposite.
///
/// Error: a sentence that ends in what the image is instead (normals in the model's axes, or no unit vectors at all).
tl::expected<NormalMap, std::string> read_normal_map(const Image& map, const NormalMapUse& use);

/// How strands run where a map of normals (two channels) shows their ridges: TextureRole::kStrandAxis, with about a
/// hundred texels along the longer side. Across a strand normals change, along it they do not: the axis of least spread
/// of the normals in a block, of which the mean, the form of whole locks, is taken off. Sure is what spreads one way
/// only (the coherence of the structure tensor, Foerstner and Guelch 1987).
[[nodiscard]] Image strand_axes(const Image& normals);

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

struct DrawnRecipe;

/// Of textures with two channels, as the recipe wants them.
[[nodiscard]] TexelFormat two_channel_format(const DrawnRecipe& recipe);

/// Maps of how normals and strands lie on the surface (TextureRole::kNormal, kStrandAxis), each at the lowest
/// resolution that says all: from the hair's normals (two channels), and from what is known of its strands
/// (SourceMaterial::strand_texture), else from the normals too. Null: there are none. A map that says nothing where the
/// hair shows it is left out.
StoredTextures bake_relief(const Image* normals, const Image* strands, const HairMesh& hair, const DrawnRecipe& recipe,
                           const platform::Threads& threads, Findings& findings);

}  // namespace coif::cook
