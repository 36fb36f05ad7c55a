#pragma once

#include "cards/card_surface.h"
#include "cards/hair_picture.h"
#include "cards/picture_frame.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::report {

/// Frames of one scale, as in frame_along(), of `size` pixels in each direction. `turn`: from the groom's axes to those
/// of the directions, Y up.
[[nodiscard]] std::vector<cards::PictureFrame> frames_around(const groom::Groom& groom, const Eigen::Matrix3f& turn,
                                                             std::span<const Eigen::Vector3f> directions,
                                                             std::uint32_t size);

/// The frame moved and scaled so that the groom just fits in.
[[nodiscard]] cards::PictureFrame closer(cards::PictureFrame frame, const groom::Groom& groom);

/// Pictures of the strands in some frames, drawn once, for comparison with surfaces.
class GroomViews {
 public:
  /// `width` in metres is for strands whose groom has none; `side`: of draw_cards().
  GroomViews(const groom::Groom& groom, float width, std::vector<cards::PictureFrame> frames,
             const platform::Threads& threads, std::uint32_t side = 4);

  [[nodiscard]] std::size_t count() const { return frames_.size(); }
  [[nodiscard]] const cards::PictureFrame& frame(std::size_t i) const { return frames_[i]; }
  [[nodiscard]] const cards::HairPicture& strands(std::size_t i) const { return strands_[i]; }

  [[nodiscard]] std::vector<cards::HairLikeness> compare(const cards::CardSurface& surface) const;

  /// Mean over the directions.
  [[nodiscard]] cards::SurfaceCost cost(const cards::CardSurface& surface) const;

 private:
  platform::Threads threads_;
  std::uint32_t side_;
  std::vector<cards::PictureFrame> frames_;
  std::vector<cards::HairPicture> strands_;
};

}  // namespace coif::report
