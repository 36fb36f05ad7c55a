#include "cards/fit_opacity.h"

#include "base/parallel_for.h"
#include "cards/fewer_strands.h"
#include "cards/strand_picture.h"
#include "cards/surface_raster.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace coif {
namespace {

constexpr std::size_t kViews = 32;
constexpr std::size_t kMostPoints = std::size_t{1} << 21;  // more are drawn to no purpose: pixels are millimetres
constexpr std::uint32_t kPicture = 256;                    // pixels of hair, both ways
constexpr float kTolerance = 0.1f;                         // pixels that strands may lie off where they are
constexpr std::uint32_t kFitSide = 2;                      // samples of a pixel, both ways
constexpr double kLeastFall = 0.04;                        // of the error, for another round
constexpr float kClearest = 1e-4f;                         // so that a texel behind an opaque one still has some say
constexpr float kLittleSeen = 0.3f;                        // samples: texels that are seen less than this change less
constexpr std::size_t kSpreadAlong = 12;                   // texels
constexpr float kEdge = 0.2f;                              // of a card's width and length

/// Fog outside of the hair shows more than what lacks inside.
constexpr float kOutside = 4;

/// One direction: what pixels should cover more than they do, and what each sample lets through.
struct View {
  PictureFrame samples;
  std::vector<float> lacking;  ///< Of each pixel.
  std::vector<float> weight;   ///< How much that counts.
  std::vector<float> clear;    ///< Of each sample.
  double error = 0, covered = 0;
};

/// Directions that have not been before: the same spiral, turned.
std::vector<Eigen::Vector3f> directions_of(int round) {
  std::vector<Eigen::Vector3f> directions = spread_directions(kViews);
  const float turn = 2.4f * float(round + 1);
  const Eigen::Matrix3f turned =
      (Eigen::AngleAxisf(turn, Eigen::Vector3f::UnitY()) * Eigen::AngleAxisf(0.5f * turn, Eigen::Vector3f::UnitX()))
          .toRotationMatrix();
  for (Eigen::Vector3f& direction : directions) direction = turned * direction;
  return directions;
}

void see_through(const CardSurface& surface, View& view) {
  const std::uint32_t size = view.samples.size;
  view.clear.assign(std::size_t(size) * size, 1);
  for (std::uint32_t t = 0; 3 * std::size_t(t) < surface.triangles.size(); ++t) {
    for_each_sample(surface, view.samples, {size, 0, size}, t,
                    [&](std::uint32_t x, std::uint32_t y, const SurfacePoint& point) {
                      float& clear = view.clear[std::size_t(y) * size + x];
                      clear *= std::max(1 - bilinear(surface, surface.opacity, point.uv), kClearest);
                    });
  }
}

void compare(const HairPicture& wanted, View& view) {
  view.lacking.resize(wanted.coverage.size());
  view.weight.resize(wanted.coverage.size());
  for (std::uint32_t y = 0; y < wanted.size; ++y) {
    for (std::uint32_t x = 0; x < wanted.size; ++x) {
      float clear = 0;
      for (std::uint32_t s = 0; s < kFitSide * kFitSide; ++s) {
        clear += view.clear[std::size_t(y * kFitSide + s / kFitSide) * view.samples.size + x * kFitSide + s % kFitSide];
      }
      const std::size_t at = std::size_t(y) * wanted.size + x;
      view.lacking[at] = wanted.coverage[at] - 1 + clear / float(kFitSide * kFitSide);
      view.weight[at] = wanted.coverage[at] > 0 ? 1 : kOutside;
      view.error += double(std::abs(view.lacking[at]));
      view.covered += double(wanted.coverage[at]);
    }
  }
}

std::vector<View> look(const Groom& groom, float strand_width, const CardSurface& surface, const ShownBall& ball,
                       int round, unsigned threads) {
  const auto directions = directions_of(round);
  std::vector<View> views(kViews);
  parallel_for(kViews, threads, [&](std::size_t i) {
    const PictureFrame frame = frame_along(directions[i], ball, kPicture);
    views[i].samples = finer(frame, int(kFitSide));
    see_through(surface, views[i]);
    compare(draw_strands(groom, frame, strand_width, 1), views[i]);
  });
  return views;
}

double error_of(std::span<const View> views) {
  double error = 0, covered = 0;
  for (const View& view : views) {
    error += view.error;
    covered += view.covered;
  }
  return covered > 0 ? error / covered : 0;
}

/// What the texels of one card should change by, as all views have it.
class CardChange {
 public:
  explicit CardChange(const AtlasPlace& place)
      : place_(place), asked_(std::size_t(place.width) * place.height), seen_(asked_.size()) {}

  /// A place of the texture: so much of a sample goes through everything else there, and so much its pixel lacks.
  void add(const CardSurface& surface, const Eigen::Vector2f& uv, float through, float lacking) {
    const float x = uv.x() * float(surface.width) - 0.5f - float(place_.x),
                y = uv.y() * float(surface.height) - 0.5f - float(place_.y);
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const float fx = x - float(x0), fy = y - float(y0);
    add_to(x0, y0, (1 - fx) * (1 - fy) * through, lacking);
    add_to(x0 + 1, y0, fx * (1 - fy) * through, lacking);
    add_to(x0, y0 + 1, (1 - fx) * fy * through, lacking);
    add_to(x0 + 1, y0 + 1, fx * fy * through, lacking);
  }

  void apply(CardTexture& texture) {
    spread(asked_);
    spread(seen_);
    for (std::uint32_t y = 0; y < place_.height; ++y) {
      for (std::uint32_t x = 0; x < place_.width; ++x) {
        const std::size_t i = std::size_t(y) * place_.width + x;
        const float change = asked_[i] / (seen_[i] + kLittleSeen);
        texture.opacity[i] = std::clamp(texture.opacity[i] + (change > 0 ? rise(x, y) * change : change), 0.0f, 1.0f);
      }
    }
  }

 private:
  void add_to(int x, int y, float through, float lacking) {
    if (x < 0 || y < 0 || x >= int(place_.width) || y >= int(place_.height)) return;
    const std::size_t at = std::size_t(y) * place_.width + std::size_t(x);
    asked_[at] += through * lacking;
    seen_[at] += through;
  }

  /// Nothing is added at a card's sides and tip, whose straight edges would show.
  [[nodiscard]] float rise(std::uint32_t x, std::uint32_t y) const {
    const float across = (float(x) + 0.5f) / float(place_.width), along = (float(y) + 0.5f) / float(place_.height);
    const float side = std::min({across, 1 - across, 1 - along}) / kEdge;
    return std::min(side, 1.0f);
  }

  /// To the sums over the texels before and behind each, along the card.
  void spread(std::vector<float>& values) const {
    const std::size_t count = place_.height, step = place_.width;
    std::vector<float> before(count);
    for (std::size_t column = 0; column < step; ++column) {
      for (std::size_t i = 0; i < count; ++i) before[i] = values[column + i * step];
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = i - std::min(i, kSpreadAlong), last = std::min(i + kSpreadAlong, count - 1);
        float sum = 0;
        for (std::size_t k = first; k <= last; ++k) sum += before[k];
        values[column + i * step] = sum;
      }
    }
  }

  const AtlasPlace& place_;
  std::vector<float> asked_, seen_;
};

/// Triangles of one card: `count` from `first` on.
void hand_back(const CardSurface& surface, std::span<const View> views, std::uint32_t first, std::uint32_t count,
               CardChange& change) {
  for (const View& view : views) {
    const std::uint32_t size = view.samples.size;
    for (std::uint32_t t = first; t < first + count; ++t) {
      for_each_sample(surface, view.samples, {size, 0, size}, t,
                      [&](std::uint32_t x, std::uint32_t y, const SurfacePoint& point) {
                        const float own = std::max(1 - bilinear(surface, surface.opacity, point.uv), kClearest);
                        const std::size_t pixel = std::size_t(y / kFitSide) * kPicture + x / kFitSide;
                        const float through = view.clear[std::size_t(y) * size + x] / own;
                        change.add(surface, point.uv, view.weight[pixel] * through, view.lacking[pixel]);
                      });
    }
  }
}

void change_textures(const CardSurface& surface, std::span<const View> views, Cards& cards, unsigned threads) {
  std::vector<std::uint32_t> first(cards.strips.size() + 1, 0);
  for (std::size_t i = 0; i < cards.strips.size(); ++i)
    first[i + 1] = first[i] + std::uint32_t(cards.strips[i].triangles());
  parallel_for(cards.strips.size(), threads, [&](std::size_t i) {
    CardChange change(cards.plan.places[i]);
    hand_back(surface, views, first[i], first[i + 1] - first[i], change);
    change.apply(cards.textures[i]);
  });
}

std::vector<std::vector<float>> opacities_of(const Cards& cards) {
  std::vector<std::vector<float>> opacities;
  for (const CardTexture& texture : cards.textures) opacities.push_back(texture.opacity);
  return opacities;
}

}  // namespace

OpacityFit fit_opacity(const Groom& whole, float strand_width, int rounds, Cards& cards, unsigned threads) {
  OpacityFit fit;
  if (rounds <= 0) return fit;
  const Groom fine = fewer_strands(whole, strand_width, kMostPoints);
  const ShownBall ball = ball_around(fine.points);
  const Groom groom = straighter_strands(fine, kTolerance / frame_along({0, 0, -1}, ball, kPicture).pixels_of_metre);
  std::vector<std::vector<float>> best;
  for (int round = 0; round <= rounds; ++round) {
    const CardSurface surface = surface_of(cards);
    const std::vector<View> views = look(groom, strand_width, surface, ball, round, threads);
    const double error = error_of(views), before = fit.errors.empty() ? error : fit.errors.back();
    fit.errors.push_back(error);
    if (round > 0 && error > before) {
      for (std::size_t i = 0; i < best.size(); ++i) cards.textures[i].opacity = std::move(best[i]);
      break;
    }
    if (round == rounds || (round > 0 && error > (1 - kLeastFall) * before)) break;
    best = opacities_of(cards);
    change_textures(surface, views, cards, threads);
  }
  return fit;
}

}  // namespace coif
