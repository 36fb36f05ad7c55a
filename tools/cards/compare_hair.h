#pragma once

#include "cards/strand_picture.h"

namespace coif::cards {

/// How near one picture of hair comes to another of the same frame.
struct HairLikeness {
  double coverage_iou =
      1;             ///< Sum of the smaller coverages over that of the larger ones (intersection over union), 0..1.
  double error = 0;  ///< Root mean square difference of shades, over all pixels that either covers.
};

[[nodiscard]] HairLikeness compare_hair(const HairPicture& wanted, const HairPicture& seen);

/// The same error in decibels below a white pixel, at most 100.
[[nodiscard]] double psnr_db(double error);

}  // namespace coif::cards
