#pragma once

#include "cards/even_strands.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// Neighbouring roots of strands that start in one direction, and their skin: a cap of a sphere over a plane.
struct ScalpPatch {
  std::vector<std::uint32_t> members;  ///< Strands, ascending.

  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  /// Rows: along, as strands set out on the skin; across; outwards. Coordinates below are in these, from the middle,
  /// metres.
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  /// Height of the skin at (x, y) is skin . (1, x, y, x^2 + y^2).
  Eigen::Vector4f skin = Eigen::Vector4f::Zero();
  float off_skin = 0;  ///< Root mean square distance of roots from that height.
  Eigen::Vector2f low = Eigen::Vector2f::Zero(),
                  /// Range of the roots along and across, without those that stray.
      high = low;

  [[nodiscard]] Eigen::Vector3f local(const Eigen::Vector3f& point) const { return axes * (point - middle); }
  [[nodiscard]] float height(float x, float y) const { return skin.dot(Eigen::Vector4f(1, x, y, x * x + y * y)); }
  [[nodiscard]] Eigen::Vector3f on_skin(float x, float y) const {
    return middle + axes.transpose() * Eigen::Vector3f(x, y, height(x, y));
  }
  /// Outwards, unit.
  [[nodiscard]] Eigen::Vector3f normal(float x, float y) const;
};

/// The skin that hair grows from, as far as its roots show it.
struct Scalp {
  float radius = 0;                  ///< Half the longest side of the box around all roots, metres.
  float reach = 0;                   ///< Length of each strand, from its root on, that is shown on the skin, metres.
  std::vector<ScalpPatch> patches;   ///< Each strand is in one of them.
  std::vector<std::uint8_t> at_rim;  ///< 1 for each strand whose root is at the rim of the hair: roots_at_rim().
  groom::Groom strands;  ///< The beginning of each strand, root first, laid down on the skin; in the hair's order.
};

/// At most `count` patches. No patches and no strands where there is no scalp: a lock, whose strands are many times
/// longer than the distance of its roots, or so few roots that they do not show the skin between them. Repeats for
/// equal input, with any `threads`.
[[nodiscard]] Scalp find_scalp(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                               const EvenStrands& strands, std::size_t count, const platform::Threads& threads);

/// 1 for roots at the rim, where fewer others are on one side within `reach`, metres, than on the other, or than
/// around most: some half of it deep, and thinned out inwards. `inside`: a point below the skin.
[[nodiscard]] std::vector<std::uint8_t> roots_at_rim(std::span<const Eigen::Vector3f> roots,
                                                     const Eigen::Vector3f& inside, float reach);

}  // namespace coif::cards
