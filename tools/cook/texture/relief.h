#pragma once

#include "base/encodings.h"
#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/texture/image.h"
#include "platform/stop.h"

#include <coif/asset_records.h>

#include <vector>

namespace coif::cook {

/// The direction of green in a normal map: up the image, as in glTF and OpenGL, or down, as in DirectX.
enum class GreenAxis { kUp, kDown };

/// What is known about a map before its texels are read.
struct NormalMapUse {
  std::optional<GreenAxis> green;  ///< None: found from the map.
  double strength = 1;             ///< Multiplies slopes; 0 or more.
};

struct NormalMap {
  Image normals;      ///< Two channels: TextureRole::kNormal.
  std::string found;  ///< The kind of map that was recognised, for messages: "a normal map, green up (...)".
};

/// Reads an RGBA image as a map of normals in the texture's own axes, or as one of heights, which is grey all over.
/// Heights have no unit: their slopes are scaled to a common steepness.
///
/// If nobody gives the direction of green, the map itself shows it. Normals belong to a surface of heights, so the
/// change of one slope along the other axis equals that of the other slope along the first; with green reversed they
/// have opposite signs.
///
/// Error: the end of a sentence that says what the image is instead (normals in the model's axes, or no unit vectors at
/// all).
tl::expected<NormalMap, std::string> read_normal_map(const Image& map, const NormalMapUse& use);

/// The strands' directions from a map of normals (two channels) that shows their ridges: TextureRole::kStrandAxis, with
/// about a hundred texels along the longer side. Normals change across a strand and not along it: so it is the axis of
/// least spread of the normals in a block, after subtraction of their mean, the form of whole locks. The certainty is
/// the coherence of the structure tensor (Foerstner and Guelch 1987).
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

/// The recipe's format for textures with two channels.
[[nodiscard]] TexelFormat two_channel_format(const DrawnRecipe& recipe);

/// How maps of two channels are stored.
struct MapForm {
  TexelFormat format = TexelFormat::kRg8;
  std::uint32_t max_size = 0;  ///< Texels each way; larger images are reduced.
};

/// Maps of how normals and strands lie on the surface (TextureRole::kNormal, kStrandAxis), each at the lowest
/// resolution that loses nothing: from the hair's normals (two channels), and from known strands
/// (SourceMaterial::strand_texture), else also from the normals. Null: none. A map without information where the hair
/// shows it is left out.
StoredTextures bake_relief(const Image* normals, const Image* strands, const HairMesh& hair, const MapForm& form,
                           const platform::Threads& threads, Findings& findings);

}  // namespace coif::cook
