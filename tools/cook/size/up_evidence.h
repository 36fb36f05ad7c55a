#pragma once

#include "cook/size/measured_model.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace coif::cook {

/// Directions of a model that may be up: first the one that it was imported with.
inline constexpr std::size_t kUps = 6;
[[nodiscard]] Eigen::Vector3d up_direction(std::size_t up);

/// What takes that direction to Y the shortest way.
[[nodiscard]] Eigen::Matrix3d y_up_from_direction(std::size_t up);

/// How a model speaks for each direction: logarithms of likelihoods, 0 at most.
struct UpEvidence {
  const char* what;  ///< "the head is above the hips".
  std::array<double, kUps> likelihood{};
};

[[nodiscard]] std::vector<UpEvidence> weigh_ups(const KnownModel& known);

}  // namespace coif::cook
