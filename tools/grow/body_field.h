#pragma once

#include "grow/body_surface.h"
#include "platform/stop.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace coif::grow {

/// The sampled signed distance from a body, which a growing strand needs thousands of times.
class BodyField {
 public:
  /// In `box`, every `spacing` metres, or more if that were too many samples. Repeats, with any `threads`.
  BodyField(const BodySurface& surface, const Eigen::AlignedBox3f& box, float spacing,
            const platform::Threads& threads);

  /// Metres from the surface, negative inside. Outside the box: the distance at the nearest place in it, plus the way
  /// there.
  [[nodiscard]] float distance(const Eigen::Vector3f& point) const;

  /// Unit, the way out.
  [[nodiscard]] Eigen::Vector3f normal(const Eigen::Vector3f& point) const;

  /// `point`, or where it is if it keeps at least so far from the surface.
  [[nodiscard]] Eigen::Vector3f kept_off(const Eigen::Vector3f& point, float clearance) const;

  [[nodiscard]] float spacing() const { return spacing_; }

 private:
  [[nodiscard]] float sample(int x, int y, int z) const {
    return samples_[(std::size_t(z) * std::size_t(size_[1]) + std::size_t(y)) * std::size_t(size_[0]) + std::size_t(x)];
  }

  Eigen::Vector3f low_;
  float spacing_;
  std::array<int, 3> size_{};
  std::vector<float> samples_;
};

}  // namespace coif::grow
