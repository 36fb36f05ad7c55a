#pragma once

#include "cook/recipe/hair_style.h"
#include "grow/head_frame.h"

#include <Eigen/Core>

#include <cstddef>

namespace coif::grow {

/// The direction in which hair is combed on the head.
class Flow {
 public:
  Flow(const cook::HairStyle& style, const HeadFrame& head);

  /// The side of the parting of root `number`, 1 at the model's left, -1 at its right, 0 without a parting. It is
  /// constant along a strand: hair that crosses the parting lies over it and does not turn back.
  [[nodiscard]] float side_of(const Eigen::Vector3f& root_direction, std::size_t number) const;
  /// How much hair grows in random directions, 1 at the crown, which would otherwise have a bare spot.
  [[nodiscard]] float tangled_at(const Eigen::Vector3f& root_direction) const;
  /// How much hair parts here, at the crown and along a parting: 1 where it leaves the scalp to all sides, 0 where hair
  /// from above lies over it.
  [[nodiscard]] float leaves_bare(const Eigen::Vector3f& root_direction) const;

  /// The direction at a place, along the skin with this `normal`; unit, or nearly zero where directions are random.
  /// `side`: from side_of().
  [[nodiscard]] Eigen::Vector3f at(const Eigen::Vector3f& place, const Eigen::Vector3f& normal, float side,
                                   bool is_fringe) const;

 private:
  [[nodiscard]] Eigen::Vector3f from_crown(const Eigen::Vector3f& direction) const;
  [[nodiscard]] float parted(const Eigen::Vector3f& direction) const;

  const cook::HairStyle& style_;
  const HeadFrame& head_;
  Eigen::Vector3f crown_,
      /// Unit; the parting's plane goes through the middle, perpendicular to `parting_`.
      parting_;
  Eigen::Vector3f comb_ = Eigen::Vector3f::Zero();
  float fringe_;  ///< Degrees from the hairline up to where a fringe begins; 0: none.
};

}  // namespace coif::grow
