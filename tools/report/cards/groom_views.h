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

/// What drawing a surface from a direction takes.
struct SurfaceCost {
  double fragments = 0;  ///< Pixels of all its triangles, whatever is on them: what a graphics card shades.
  double layers = 0;     ///< Of them over each other, mean over the pixels that any is on.
};

/// At one sample a pixel.
[[nodiscard]] SurfaceCost cost_of(const cards::CardSurface& surface, const cards::PictureFrame& frame);

/// All of one scale, as frame_along() has them, of `size` pixels each way. `turn`: from the groom's axes to those that
/// the directions are in, Y up.
[[nodiscard]] std::vector<cards::PictureFrame> frames_around(const groom::Groom& groom, const Eigen::Matrix3f& turn,
                                                             std::span<const Eigen::Vector3f> directions,
                                                             std::uint32_t size);

/// The same frame moved and scaled so that the groom just fits in.
[[nodiscard]] cards::PictureFrame closer(cards::PictureFrame frame, const groom::Groom& groom);

/// Strands as they look in some frames, drawn once, and how near surfaces come to that.
class GroomViews {
 public:
  /// `width` of strands whose groom says none, metres.
  GroomViews(const groom::Groom& groom, float width, std::vector<cards::PictureFrame> frames,
             const platform::Threads& threads);

  [[nodiscard]] std::size_t count() const { return frames_.size(); }
  [[nodiscard]] const cards::PictureFrame& frame(std::size_t i) const { return frames_[i]; }
  [[nodiscard]] const cards::HairPicture& strands(std::size_t i) const { return strands_[i]; }

  /// Of each `step`-th direction, from the first on.
  [[nodiscard]] std::vector<cards::HairLikeness> compare(const cards::CardSurface& surface, std::size_t step = 1) const;

  /// Mean over the directions.
  [[nodiscard]] SurfaceCost cost(const cards::CardSurface& surface) const;

 private:
  platform::Threads threads_;
  std::vector<cards::PictureFrame> frames_;
  std::vector<cards::HairPicture> strands_;
};

}  // namespace coif::report
