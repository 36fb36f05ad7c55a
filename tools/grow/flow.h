#pragma once

#include "cook/recipe/hair_style.h"
#include "grow/head_frame.h"

#include <Eigen/Core>

#include <cstddef>

namespace coif::grow {

/// Which way hair is combed where it lies on the head.
class Flow {
 public:
  Flow(const cook::HairStyle& style, const HeadFrame& head);

  /// Which side of the parting root `number` is on, 1 at the model's left, -1 at its right, 0 without a parting. It
  /// never changes along a strand: hair that crosses the parting lies over it and does not turn back.
  [[nodiscard]] float side_of(const Eigen::Vector3f& root_direction, std::size_t number) const;
  /// How far hair goes any way where it grows, 1 at the crown, from which it would leave a bare spot otherwise.
  [[nodiscard]] float tangled_at(const Eigen::Vector3f& root_direction) const;
  /// How far hair parts here, at the crown and along a parting: 1 where it leaves the scalp to all sides, 0 where hair
  /// from above lies over it.
  [[nodiscard]] float leaves_bare(const Eigen::Vector3f& root_direction) const;

  /// At a place, along the skin of which `normal` is given; unit, or nearly zero where hair goes any way. `side`: as
  /// side_of() has it.
  [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector3f& place, const Eigen::Vector3f& normal, float side,
                                   bool is_fringe) const;

 private:
  [[nodiscard]] Eigen::Vector3f from_crown(const Eigen::Vector3f& direction) const;
  [[nodiscard]] float parted(const Eigen::Vector3f& direction) const;

  const cook::HairStyle& style_;
  const HeadFrame& head_;
  Eigen::Vector3f crown_,
      parting_;  ///< Unit; the parting's plane goes through the middle, at right angles to `parting_`.
  Eigen::Vector3f comb_ = Eigen::Vector3f::Zero();
};

}  // namespace coif::grow
