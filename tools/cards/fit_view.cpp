#include "cards/fit_view.h"

#include "cards/surface_raster.h"

#include <cmath>

namespace coif::cards {
namespace {

/// Weight of fog outside the hair, which is more visible than missing coverage inside.
constexpr float kOutside = 4;

SeenTexel seen_at(const CardSurface& surface, std::uint32_t sample, const Eigen::Vector2f& uv) {
  const float x = std::clamp(uv.x() * float(surface.width) - 0.5f, 0.0f, float(surface.width - 1));
  const float y = std::clamp(uv.y() * float(surface.height) - 0.5f, 0.0f, float(surface.height - 1));
  const std::uint32_t left = std::min(std::uint32_t(x), surface.width - 2),
                      top = std::min(std::uint32_t(y), surface.height - 2);
  SeenTexel seen{sample, top * surface.width + left, x - float(left), y - float(top), 0};
  const float *above = &surface.opacity[seen.texel], *below = above + surface.width;
  seen.opacity = (1 - seen.down) * (above[0] + seen.right * (above[1] - above[0])) +
                 seen.down * (below[0] + seen.right * (below[1] - below[0]));
  return seen;
}

}  // namespace

void FitView::look(const CardSurface& surface, std::span<const std::uint32_t> first_triangle,
                   const PictureFrame& frame) {
  const PictureFrame samples = finer(frame, int(kSide));
  size_ = frame.size;
  clear_.assign(std::size_t(samples.size) * samples.size, 1);
  begin_.assign(1, 0);
  seen_.clear();
  const auto take = [&](std::uint32_t x, std::uint32_t y, const SurfacePoint& point) {
    seen_.push_back(seen_at(surface, y * samples.size + x, point.uv));
    clear_[seen_.back().sample] *= std::max(1 - seen_.back().opacity, kClearest);
  };
  for (std::size_t card = 0; card + 1 < first_triangle.size(); ++card) {
    for (std::uint32_t t = first_triangle[card]; t < first_triangle[card + 1]; ++t) {
      for_each_sample(surface, samples, {samples.size, 0, samples.size}, t, take);
    }
    begin_.push_back(std::uint32_t(seen_.size()));
  }
}

void FitView::compare(std::span<const float> wanted) {
  lacking_.resize(wanted.size());
  weight_.resize(wanted.size());
  error_ = covered_ = 0;
  const std::size_t row = std::size_t(kSide) * size_;
  for (std::size_t at = 0; at < wanted.size(); ++at) {
    const std::size_t x = at % size_, y = at / size_;
    float clear = 0;
    for (std::size_t s = 0; s < kSide * kSide; ++s)
      clear += clear_[(y * kSide + s / kSide) * row + x * kSide + s % kSide];
    lacking_[at] = wanted[at] - 1 + clear / float(kSide * kSide);
    weight_[at] = wanted[at] > 0 ? 1 : kOutside;
    error_ += double(std::abs(lacking_[at]));
    covered_ += double(wanted[at]);
  }
}

}  // namespace coif::cards
