#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace coif::cards {

/// Cards as they are drawn: triangles, and one texture on all of them.
struct CardSurface {
  // Of each vertex.
  std::vector<Eigen::Vector3f> positions;  ///< Metres.
  std::vector<Eigen::Vector2f> uvs;        ///< 0..1 of the texture, V downwards.
  std::vector<Eigen::Vector3f> across;     ///< Unit; with `along` what directions on cards are measured in.
  std::vector<Eigen::Vector3f> along;      ///< Unit, root to tip.

  std::vector<std::uint32_t> triangles;  ///< Three vertices each.

  // Of each texel, row by row.
  std::uint32_t width = 0, height = 0;
  std::vector<float> opacity;              ///< 0..1.
  std::vector<Eigen::Vector2f> direction;  ///< Of strands, (across, along), not unit. Empty: along everywhere.
};

}  // namespace coif::cards
