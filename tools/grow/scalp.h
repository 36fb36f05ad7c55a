#pragma once

#include "cook/recipe/hair_style.h"
#include "grow/body_field.h"
#include "grow/head_frame.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <vector>

namespace coif::grow {

/// The lowest elevation of hair at an azimuth, degrees.
[[nodiscard]] float hairline(const cook::HairStyle& style, float azimuth);

/// Where a strand begins, and what it is like.
struct Root {
  Eigen::Vector3f place;      ///< On the skin.
  Eigen::Vector3f direction;  ///< HeadFrame::direction().
  float length = 0;           ///< Metres.
  float height = 0;           ///< 0 at the hairline, 1 at the top.
  bool is_fringe = false;
};

/// As many as the style asks for, evenly over the scalp but for where it thins out towards the hairline. Fewer, or
/// none, where the hairline leaves no room.
[[nodiscard]] std::vector<Root> spread_roots(const cook::HairStyle& style, const HeadFrame& head, const BodyField& body,
                                             const platform::Threads& threads);

}  // namespace coif::grow
