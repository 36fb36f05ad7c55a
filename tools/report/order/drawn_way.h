#pragma once
// Ways to draw one asset that are compared, and the poses in which they are.

#include <coif/asset_records.h>
#include <coif/math.h>
#include <coif/transparency.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coif {

struct DrawnWay {
  std::string name;
  std::size_t model = 0;  ///< Of OrderPictures.
  const TransparencyMode* transparency = &kBlendMode;
  const MaterialRecord* material = nullptr;  ///< Instead of the asset's, unless null.
  std::uint32_t samples = 1;
  /// Per triangle what is sorted far to near for each picture, for which `model` is made anew; empty: nothing is.
  std::vector<std::uint32_t> sorted_units = {};
  bool faces_together = false;
  std::uint64_t bytes = 0;  ///< Of indices.
};

/// Hair at one moment, head space.
struct PosedHair {
  std::vector<Mat34> palette;
  std::vector<Eigen::Vector3f> positions;  ///< Of all vertices, metres.
};

/// A row's pose: views take turns between its moments.
struct OrderPose {
  std::string name;  ///< rest or a motion.
  std::vector<PosedHair> moments;
};

}  // namespace coif
