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

/// Some roots beside each other, of strands that set out in one direction, and the skin that they are in: a cap of a
/// sphere over a plane.
struct ScalpPatch {
  std::vector<std::uint32_t> members;  ///< Strands, ascending.

  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  /// Rows: along, as strands set out on the skin; across; outwards. Coordinates below are in these, from the middle,
  /// metres.
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  /// Height of the skin at (x, y) is skin . (1, x, y, x^2 + y^2).
  Eigen::Vector4f skin = Eigen::Vector4f::Zero();
  float off_skin = 0;  ///< How far roots are from that height, root mean square.
  Eigen::Vector2f low = Eigen::Vector2f::Zero(),
                  high = low;  ///< Along and across: where roots are, but for those that stray.

  [[nodiscard]] Eigen::Vector3f local(const Eigen::Vector3f& point) const { return axes * (point - middle); }
  [[nodiscard]] float height(float x, float y) const { return skin.dot(Eigen::Vector4f(1, x, y, x * x + y * y)); }
  [[nodiscard]] Eigen::Vector3f on_skin(float x, float y) const {
    return middle + axes.transpose() * Eigen::Vector3f(x, y, height(x, y));
  }
  /// Outwards, unit.
  [[nodiscard]] Eigen::Vector3f normal(float x, float y) const;
};

/// The skin that hair grows from, as far as its roots tell.
struct Scalp {
  float radius = 0;                 ///< Half the longest side of the box around all roots, metres.
  float reach = 0;                  ///< As much of each strand, from its root on, is shown on the skin, metres.
  std::vector<ScalpPatch> patches;  ///< All strands are in one each.
  groom::Groom strands;             ///< So much of each, root first, laid down on the skin; in the order of the hair's.
};

/// `count` patches at most. No patches and no strands where there is no scalp: a lock, whose strands are many times
/// longer than its roots lie apart, or so few roots that nothing is known of the skin between them. Repeats for equal
/// input, whatever `threads` is.
[[nodiscard]] Scalp find_scalp(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed,
                               const EvenStrands& strands, std::size_t count, const platform::Threads& threads);

}  // namespace coif::cards
