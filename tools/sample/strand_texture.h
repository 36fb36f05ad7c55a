#pragma once

#include "sample/strip.h"

#include <array>
#include <cstdint>
#include <vector>

namespace coif::sample {

/// The texture's windows, side by side: four clumps for strips, one broad one for panels.
inline constexpr std::array<TextureWindow, 4> kClumpWindows{
    {{0.000, 0.156}, {0.156, 0.312}, {0.312, 0.469}, {0.469, 0.625}}};
inline constexpr TextureWindow kBroadWindow{0.625, 1.000};

/// 512 x 512 RGBA, sRGB, straight alpha: roots at the top, tips at the bottom. Opaque in the middle, single strands at
/// tips and sides; colour goes on under transparent texels, so that filtering leaves no halo. No taller: along
/// a strand little changes, and a texture squeezed in V makes the renderer pick mips that blur the strands in U.
struct StrandTexture {
  static constexpr int kWidth = 512;
  static constexpr int kHeight = 512;
  std::vector<std::uint8_t> rgba;
};

[[nodiscard]] StrandTexture make_strand_texture();

/// PNG bytes of the texture; empty only when out of memory.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const StrandTexture& texture);

}  // namespace coif::sample
