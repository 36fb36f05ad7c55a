#include "report/cards/groom_views.h"

#include "base/parallel_for.h"
#include "cards/card_picture.h"
#include "cards/surface_raster.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace coif {

SurfaceCost cost_of(const CardSurface& surface, const PictureFrame& frame) {
  std::vector<std::uint8_t> is_met(std::size_t(frame.size) * frame.size, 0);
  std::size_t fragments = 0;
  const SampleRows all{frame.size, 0, frame.size};
  for (std::uint32_t t = 0; 3 * std::size_t(t) < surface.triangles.size(); ++t) {
    for_each_sample(surface, frame, all, t, [&](std::uint32_t x, std::uint32_t y, const SurfacePoint&) {
      ++fragments;
      is_met[std::size_t(y) * frame.size + x] = 1;
    });
  }
  const auto met = std::ranges::count(is_met, std::uint8_t{1});
  return {double(fragments), met > 0 ? double(fragments) / double(met) : 0.0};
}

std::vector<PictureFrame> frames_around(const Groom& groom, const Eigen::Matrix3f& turn,
                                        std::span<const Eigen::Vector3f> directions, std::uint32_t size) {
  const ShownBall ball = ball_around(groom.points);
  std::vector<PictureFrame> frames;
  for (const Eigen::Vector3f& direction : directions) {
    frames.push_back(frame_along(direction, ball, size));
    frames.back().axes *= turn;
  }
  return frames;
}

PictureFrame closer(PictureFrame frame, const Groom& groom) {
  constexpr float kFilled = 0.96f;  // of the picture
  Eigen::AlignedBox2f seen;         // metres
  for (const Eigen::Vector3f& point : groom.points) {
    seen.extend((frame.axes * (point - frame.center)).head<2>().eval());
  }
  const float largest = seen.sizes().maxCoeff();
  if (!(largest > 0)) return frame;
  const Eigen::Vector2f middle = seen.center();
  frame.center += frame.axes.transpose() * Eigen::Vector3f(middle.x(), middle.y(), 0);
  frame.pixels_of_metre = kFilled * float(frame.size) / largest;
  return frame;
}

GroomViews::GroomViews(const Groom& groom, float width, std::vector<PictureFrame> frames, const Threads& threads)
    : threads_(threads), frames_(std::move(frames)) {
  for (const PictureFrame& frame : frames_) strands_.push_back(draw_strands(groom, frame, width, threads));
}

std::vector<HairLikeness> GroomViews::compare(const CardSurface& surface, std::size_t step) const {
  std::vector<HairLikeness> likeness;
  for (std::size_t i = 0; i < count(); i += step) {
    likeness.push_back(compare_hair(strands_[i], draw_cards(surface, frames_[i], threads_)));
  }
  return likeness;
}

SurfaceCost GroomViews::cost(const CardSurface& surface) const {
  std::vector<SurfaceCost> costs(count());
  parallel_for(count(), threads_, [&](std::size_t i) { costs[i] = cost_of(surface, frames_[i]); });
  SurfaceCost mean;
  for (const SurfaceCost& cost : costs) {
    mean.fragments += cost.fragments / double(count());
    mean.layers += cost.layers / double(count());
  }
  return mean;
}

}  // namespace coif
