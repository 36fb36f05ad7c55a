#pragma once

#include <cstdint>

namespace coif::cook {

/// What choose_order() made; all 0 where nothing is blended or looked for.
struct OrderFigures {
  std::uint32_t orders = 0;     ///< The one for all directions included.
  double psnr = 0;              ///< Expected of pictures, dB: of all pixels together,
  double median = 0;            ///< over the views at rest,
  double worst = 0;             ///< of the worst of these,
  double moving = 0;            ///< and over those in motion.
  std::uint32_t crossings = 0;  ///< Pairs of triangles of which neither is before the other all over some picture.
  std::uint32_t cuts = 0;       ///< Lines that triangles were cut along.
  std::uint32_t added = 0;      ///< Triangles.
  double cut_gain = 0;          ///< Expected of the cuts, dB.
};

}  // namespace coif::cook
