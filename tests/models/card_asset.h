#pragma once

#include "lab/rig.h"
#include "write/asset_writer.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coif {

/// A rectangle of one alpha everywhere.
struct Card {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Vector3f right{0.1f, 0, 0};  ///< From the middle to an edge; right x up is the side of the front face.
  Eigen::Vector3f up{0, 0.1f, 0};
  int alpha = 128;  ///< 0..255.
};

/// Rigid hair: each card a patch, in this order, double-sided, opaque from 0.95 on.
[[nodiscard]] AssetContents card_contents(std::span<const Card> cards);

/// A ball on the head, which hides what is behind it.
void add_ball(AssetContents& contents, const Eigen::Vector3f& center, float radius);

}  // namespace coif
