#pragma once
// The records of an asset's material and textures; a part of coif/asset_records.h, whose rules hold here too.

#include <cstdint>

namespace coif {

/// Back faces are drawn too. Without this flag only the side that the triangles wind around counter-clockwise is seen.
inline constexpr std::uint32_t kMaterialDoubleSided = 1u << 0;

/// Blended texels are drawn in one pass, both faces in the order of the triangles. Without this flag back faces come
/// before front faces.
inline constexpr std::uint32_t kMaterialFacesTogether = 1u << 1;

/// Normals are those of the hair as one soft body: they point out of it, and are the same from both sides of a card.
inline constexpr std::uint32_t kMaterialVolumeNormals = 1u << 2;

inline constexpr std::uint32_t kMaterialFlags = kMaterialDoubleSided | kMaterialFacesTogether | kMaterialVolumeNormals;

/// How strands reflect light. Formulas, with their sources: shaders/SHADING.md.
enum class ShadingModel : std::uint32_t {
  kThesis = 0,     ///< Algorithm 3 of the thesis: wrapped diffuse light and two shifted highlights.
  kKajiyaKay = 1,  ///< Diffuse light by the sine to the strand, one highlight around the mirror cone.
  kMarschner = 2,  ///< Light that a fibre's surface reflects, lets through, and reflects at its far side.
  kVolume = 3,     ///< Fibres so many that light wanders among them: what path tracing shows, in closed form.
};

inline constexpr float kMostTilt = 0.35f;  ///< Radians; scales of real hair lean by 0.03 to 0.09.
/// Radians. The narrowest lobe is half as wide, about as narrow as 8 bits of a tangent's direction can show.
inline constexpr float kLeastRoughness = 0.02f;
inline constexpr float kMostRoughness = 1.0f;
inline constexpr float kMostGlow = 8.0f;

/// Shading and the four passes of the thesis's 5.3.1. Colours are linear. kThesis uses both highlights' colours,
/// exponents and shifts; kKajiyaKay uses the primary colour and exponent for its only highlight; kMarschner uses none
/// of them.
struct MaterialRecord {
  float base_color[4];     ///< Multiplies the base texture.
  float ambient[3];        ///< Times base colour, independent of lights.
  float opaque_threshold;  ///< Texels with at least this alpha are drawn opaque, 0..1.
  float primary_color[3];
  float primary_exponent;
  float secondary_color[3];
  float secondary_exponent;
  float primary_shift;  ///< Tangent shift along the normal, before the texture's share.
  float secondary_shift;
  float discard_threshold;  ///< Texels with less alpha than this are never drawn, 0..1.
  std::uint32_t flags;
  ShadingModel shading;
  float tilt;  ///< kMarschner: tilt of the fibre's scales towards the tip, radians, -kMostTilt..kMostTilt.
  /// kMarschner: width of the first highlight along the strand, radians, kLeastRoughness..kMostRoughness. Other models
  /// may have 0.
  float roughness;
  float scatter;    ///< kMarschner: share of the transmitted light that other strands scatter before it is seen, 0..1.
  float light_cut;  ///< Share of what lights add that is taken away, 0 (as published) .. 1.
  // Terms that every model may have. At 0 a term is off and costs nothing.
  float glow;        ///< Light that comes through hair from behind, 0..kMostGlow.
  float root_shade;  ///< Share of its colour that a strand loses at the root, 0..1.
  float variation;   ///< Share by which strands are lighter and darker than each other, 0..1.
};

/// The material has one of the terms that every shading model may have.
constexpr bool has_strand_terms(const MaterialRecord& m) {
  return m.glow != 0.0f || m.root_shade != 0.0f || m.variation != 0.0f;
}

/// Some alphas are blended. Otherwise the material is a mask: a texel is drawn or not.
constexpr bool blends(const MaterialRecord& material) { return material.discard_threshold < material.opaque_threshold; }
static_assert(sizeof(MaterialRecord) == 112);

enum class TextureRole : std::uint32_t {
  kBaseColor = 0,
  kShiftMask = 1,  ///< Red: shift, green: mask.
  /// Red and green: the unit normal's components along the directions in which U and V grow on the surface, encoded as
  /// two_sided() reads them.
  kNormal = 2,
  /// Red and green, encoded as two_sided() reads them: cosine and sine of twice the angle from the direction in which U
  /// grows to the strand, towards the direction in which V grows, both times the certainty of the direction. A strand
  /// and its reverse have the same value, so mips may average.
  kStrandAxis = 3,
};
enum class TexelFormat : std::uint32_t {
  kSrgb8Alpha8 = 0,  ///< Four bytes, colour sRGB-encoded, alpha linear and not premultiplied.
  kRg8 = 1,          ///< Two bytes, linear.
  kRg11Eac = 2,      ///< ETC2/EAC RG11, unsigned: 16 bytes for 4x4 texels; the same meaning, half the size of kRg8.
  /// ETC2 with EAC alpha: 16 bytes for 4x4 texels; the meaning of kSrgb8Alpha8, a quarter of its size.
  kSrgb8Alpha8Etc2 = 3,
};

/// Whether a texture of this role describes the surface's form. Such textures are stored in RELR and RELD, all others
/// in TEXR and TEXD.
constexpr bool is_relief(TextureRole role) { return role == TextureRole::kNormal || role == TextureRole::kStrandAxis; }

/// Decodes a channel of 0..1 to a number of -1..1. Zero is 128 of 255, which eight bits represent exactly.
constexpr float two_sided(float channel) { return (channel * 255.0f - 128.0f) / 127.0f; }

/// Mips follow each other, largest first, rows from top to bottom without padding.
struct TextureRecord {
  TextureRole role;
  TexelFormat format;
  std::uint32_t width;  ///< 1..16384.
  std::uint32_t height;
  std::uint32_t mip_count;
  std::uint32_t reserved;
  std::uint64_t offset;  ///< Offset into TEXD, for a relief into RELD.
  std::uint64_t bytes;
};
static_assert(sizeof(TextureRecord) == 40);

/// Bytes of one mip of a texture with these dimensions; 0 for an unknown format.
constexpr std::uint64_t mip_bytes(TexelFormat format, std::uint32_t width, std::uint32_t height, std::uint32_t mip) {
  const std::uint64_t w = (width >> mip) > 0 ? width >> mip : 1;
  const std::uint64_t h = (height >> mip) > 0 ? height >> mip : 1;
  switch (format) {
    case TexelFormat::kSrgb8Alpha8: return w * h * 4;
    case TexelFormat::kRg8: return w * h * 2;
    case TexelFormat::kSrgb8Alpha8Etc2:
    case TexelFormat::kRg11Eac: return (w + 3) / 4 * ((h + 3) / 4) * 16;
  }
  return 0;
}

}  // namespace coif
