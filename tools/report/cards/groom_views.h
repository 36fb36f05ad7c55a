#pragma once

#include "cards/card_surface.h"
#include "cards/compare_hair.h"
#include "cards/picture_frame.h"
#include "cards/strand_picture.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// What drawing a surface from a direction takes.
struct SurfaceCost {
  double fragments = 0;  ///< Pixels of all its triangles, whatever is on them: what a graphics card shades.
  double layers = 0;     ///< Of them over each other, mean over the pixels that any is on.
};

/// At one sample a pixel.
[[nodiscard]] SurfaceCost cost_of(const CardSurface& surface, const PictureFrame& frame);

/// All of one scale, as frame_along() has them, of `size` pixels each way. `turn`: from the groom's axes to those that
/// the directions are in, Y up.
[[nodiscard]] std::vector<PictureFrame> frames_around(const Groom& groom, const Eigen::Matrix3f& turn,
                                                      std::span<const Eigen::Vector3f> directions, std::uint32_t size);

/// The same frame moved and scaled so that the groom just fits in.
[[nodiscard]] PictureFrame closer(PictureFrame frame, const Groom& groom);

/// Strands as they look in some frames, drawn once, and how near surfaces come to that.
class GroomViews {
 public:
  /// `width` of strands whose groom says none, metres.
  GroomViews(const Groom& groom, float width, std::vector<PictureFrame> frames, const Threads& threads);

  [[nodiscard]] std::size_t count() const { return frames_.size(); }
  [[nodiscard]] const PictureFrame& frame(std::size_t i) const { return frames_[i]; }
  [[nodiscard]] const HairPicture& strands(std::size_t i) const { return strands_[i]; }

  /// Of each `step`-th direction, from the first on.
  [[nodiscard]] std::vector<HairLikeness> compare(const CardSurface& surface, std::size_t step = 1) const;

  /// Mean over the directions.
  [[nodiscard]] SurfaceCost cost(const CardSurface& surface) const;

 private:
  Threads threads_;
  std::vector<PictureFrame> frames_;
  std::vector<HairPicture> strands_;
};

}  // namespace coif
