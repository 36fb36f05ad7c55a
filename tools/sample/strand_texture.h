#pragma once

#include "sample/strip.h"

#include <Eigen/Core>

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

/// Mean colour of the hair along a strand, sRGB 0..1. The defaults are the bob's brown.
struct StrandColors {
  Eigen::Vector3d root{0.230, 0.148, 0.098};
  Eigen::Vector3d length{0.410, 0.275, 0.182};
  Eigen::Vector3d tip{0.560, 0.405, 0.280};
};

[[nodiscard]] StrandTexture make_strand_texture(const StrandColors& colors = {});

/// PNG bytes of the texture; empty only when out of memory.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const StrandTexture& texture);

}  // namespace coif::sample
