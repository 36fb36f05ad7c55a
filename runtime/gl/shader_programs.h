#pragma once
// Programs: built from pieces of shaders/, one for each set of things that an asset and a pass need.

#include "gl/passes.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::size_t kMaxPieces = 32;

inline constexpr char kGlsl300[] = "#version 300 es\n";
inline constexpr char kGlsl310[] = "#version 310 es\n";  ///< For OpenGL ES 3.1: storage buffers.
inline constexpr char kGlsl320[] = "#version 320 es\n";  ///< For OpenGL ES 3.2: sample masks.

/// Compiles and links a program from pieces of GLSL ES, at most kMaxPieces for each shader, without their #version
/// line. Returns 0 on failure, with the driver's log in `log`, always ended by a zero byte.
COIF_API GLuint build_program(const GlFunctions& gl, const char* version, std::span<const char* const> vertex,
                              std::span<const char* const> fragment, std::span<char> log);

/// What a program can do, one bit each. A program without a bit contains no trace of the feature: no texture fetch, no
/// branch. Values that do not belong to an asset or its material (lights, sRGB, which component to show) are uniforms.
namespace variant {
inline constexpr std::uint32_t kFourBones = 1u << 0;  ///< Blends four matrices for each vertex.
/// Uses the first bone's matrix only. Without both bits the hair is rigid.
inline constexpr std::uint32_t kOneBone = 1u << 1;
inline constexpr std::uint32_t kBonesInTexture = 1u << 2;
inline constexpr std::uint32_t kBaseTexture = 1u << 3;
inline constexpr std::uint32_t kShiftMask = 1u << 4;
inline constexpr std::uint32_t kPrimary = 1u << 5;  ///< The primary highlight.
inline constexpr std::uint32_t kSecondary = 1u << 6;
inline constexpr std::uint32_t kAlphaTest = 1u << 7;  ///< Drops texels outside the pass's range.
inline constexpr std::uint32_t kShaded = 1u << 8;     ///< Writes the shading model's colour.
inline constexpr std::uint32_t kDirection = 1u << 9;  ///< Writes the strands' direction. Without both bits: depth only.
inline constexpr std::uint32_t kModelShift = 10;      ///< Three bits from here on: ShadingModel.
inline constexpr std::uint32_t kModel = 7u << kModelShift;
inline constexpr std::uint32_t kNormalMap = 1u << 13;
inline constexpr std::uint32_t kStrandMap = 1u << 14;      ///< How strands run on the surface.
inline constexpr std::uint32_t kMotion = 1u << 15;         ///< Compares with the last frame.
inline constexpr std::uint32_t kStrandTerms = 1u << 16;    ///< has_strand_terms().
inline constexpr std::uint32_t kVolumeNormals = 1u << 17;  ///< kMaterialVolumeNormals.
inline constexpr std::uint32_t kCodeShift = 23;            ///< Five bits from here on: FragmentCode::id.
inline constexpr std::uint32_t kShadowShift = 28;          ///< Four bits: ShadowLookup::id, 0 without a shadow.
inline constexpr std::uint32_t kShadow = 15u << kShadowShift;
}  // namespace variant

/// The bits of the program that draws a pass of an asset that needs `needs`. Bits without effect beside the others are
/// left out, so equal programs have equal bits.
[[nodiscard]] std::uint32_t variant_of(const Pass& pass, std::uint32_t needs, const MaterialRecord& material,
                                       Component component);

/// Compiles and links the program of these bits, with its textures and blocks at their binding points. Returns 0 on
/// failure, with the driver's log in `log`, ended by a zero byte. Leaves no program in use. `block_rows`: number of
/// vec4 in the matrices' block.
GLuint build_variant(const GlFunctions& gl, std::uint32_t bits, const Pass& pass, std::uint32_t block_rows,
                     std::span<char> log);

}  // namespace coif
