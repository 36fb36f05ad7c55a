#include "report/cards/groom_views.h"

#include "base/parallel_for.h"
#include "cards/hair_picture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace coif::report {

std::vector<cards::PictureFrame> frames_around(const groom::Groom& groom, const Eigen::Matrix3f& turn,
                                               std::span<const Eigen::Vector3f> directions, std::uint32_t size) {
  const cards::ShownBall ball = cards::ball_around(groom.points);
  std::vector<cards::PictureFrame> frames;
  for (const Eigen::Vector3f& direction : directions) {
    frames.push_back(cards::frame_along(direction, ball, size));
    frames.back().axes *= turn;
  }
  return frames;
}

cards::PictureFrame closer(cards::PictureFrame frame, const groom::Groom& groom) {
  constexpr float kFilled = 0.96f;  // Share of the picture.
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

GroomViews::GroomViews(const groom::Groom& groom, float width, std::vector<cards::PictureFrame> frames,
                       const platform::Threads& threads, std::uint32_t side)
    : threads_(threads), side_(side), frames_(std::move(frames)) {
  for (const cards::PictureFrame& frame : frames_)
    strands_.push_back(cards::draw_strands(groom, frame, width, threads));
}

std::vector<cards::HairLikeness> GroomViews::compare(const cards::CardSurface& surface) const {
  std::vector<cards::HairLikeness> likeness;
  for (std::size_t i = 0; i < count(); ++i) {
    likeness.push_back(cards::compare_hair(strands_[i], cards::draw_cards(surface, frames_[i], threads_, side_)));
  }
  return likeness;
}

cards::SurfaceCost GroomViews::cost(const cards::CardSurface& surface) const {
  std::vector<cards::SurfaceCost> costs(count());
  parallel_for(count(), threads_, [&](std::size_t i) { costs[i] = cards::cost_of(surface, frames_[i]); });
  cards::SurfaceCost mean;
  for (const cards::SurfaceCost& cost : costs) {
    mean.fragments += cost.fragments / double(count());
    mean.layers += cost.layers / double(count());
  }
  return mean;
}

}  // namespace coif::report
