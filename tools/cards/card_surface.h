#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace coif::cards {

/// Cards for drawing: triangles, and one texture on all of them.
struct CardSurface {
  // Per vertex.
  std::vector<Eigen::Vector3f> positions;  ///< Metres.
  std::vector<Eigen::Vector2f> uvs;        ///< 0..1 of the texture, V downwards.
  std::vector<Eigen::Vector3f> across;     ///< Unit; together with `along` it spans the directions on cards.
  std::vector<Eigen::Vector3f> along;      ///< Unit, root to tip.

  std::vector<std::uint32_t> triangles;  ///< Three vertices each.

  // Per texel, row by row.
  std::uint32_t width = 0, height = 0;
  std::vector<float> opacity;  ///< 0..1.
  /// The smaller mips of `opacity`, each half as large as the one before, rounded down. Empty: it is drawn without.
  std::vector<std::vector<float>> smaller_opacity;
  float opaque_from = 2;    ///< Samples of this opacity and more are drawn solid; more than 1: none.
  float discard_below = 0;  ///< Samples of less are not drawn.
  /// Direction of strands, (across, along), not unit. Empty: along everywhere.
  std::vector<Eigen::Vector2f> direction;
};

}  // namespace coif::cards
