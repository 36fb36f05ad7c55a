#include "cards/fit_opacity.h"

#include "cards/hair_picture.h"

#include <Eigen/Geometry>

namespace coif::cards {
namespace {

constexpr std::size_t kMostPoints = std::size_t{1} << 21;  // more would not show: pixels are millimetres
constexpr float kTolerance = 0.1f;                         // pixels by which strands may be misplaced
constexpr std::uint32_t kStrandSide = 6;                   // Samples of strands per pixel in each direction.

/// The same spiral, turned.
std::vector<Eigen::Vector3f> turned_directions(std::size_t turns) {
  std::vector<Eigen::Vector3f> directions = spread_directions(FitTarget::kViews);
  const float turn = 2.4f * float(turns + 1);
  const Eigen::Matrix3f turned =
      (Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitY()) * Eigen::AngleAxisf(0.5f * turn, Eigen::Vector3f::UnitX()))
          .toRotationMatrix();
  for (Eigen::Vector3f& direction : directions) direction = turned * direction;
  return directions;
}

}  // namespace

FitTarget::FitTarget(const groom::Groom& groom, float strand_width, std::uint32_t size) : strand_width_(strand_width) {
  const groom::Groom fine = fewer_strands(groom, strand_width, kMostPoints);
  const float pixels_of_metre = frame_along({0, 0, -1}, ball_around(fine.points), size).pixels_of_metre;
  groom_ = straighter_strands(fine, kTolerance / pixels_of_metre);
  const ShownBall ball = ball_around(groom_.points);
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    for (const Eigen::Vector3f& direction : turned_directions(turn)) {
      frames_.push_back(frame_along(direction, ball, size));
    }
  }
  coverage_.resize(frames_.size());
}

const std::vector<float>& FitTarget::coverage(std::size_t view) {
  std::vector<float>& coverage = coverage_[view];
  if (coverage.empty()) coverage = draw_strands(groom_, frames_[view], strand_width_, 1, kStrandSide).coverage;
  return coverage;
}

}  // namespace coif::cards
