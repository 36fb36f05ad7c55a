#include "cards/card_texture.h"

#include "cards/card_strip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {
namespace {

constexpr int kAcross = 8, kAlong = 4;  // samples of a texel
constexpr std::size_t kOnCard = Ribbon::kStations;

/// A place on a flat card: u from -1 to 1 across, v from 0 to 1 along, and metres in front.
struct OnCard {
  float u = 0, v = 0, front = 0;
};

/// A ribbon whose stations are looked up in between.
class FlatRibbon {
 public:
  explicit FlatRibbon(const Ribbon& ribbon) : ribbon_(ribbon) {}

  /// Near the place of the point before, `hint`, at which the search begins.
  [[nodiscard]] OnCard place(const Eigen::Vector3f& point, float hint) const {
    float at = hint * float(kOnCard - 1);
    for (int round = 0; round < 4; ++round) {
      const auto k = segment(at);
      const Eigen::Vector3f way = ribbon_.middle[k + 1] - ribbon_.middle[k];
      const float squared = way.squaredNorm();
      const float found = float(k) + (squared > 0 ? (point - ribbon_.middle[k]).dot(way) / squared : 0.0f);
      const float kept = std::clamp(found, at - 1.5f, at + 1.5f);
      if (std::abs(kept - at) < 1e-3f) break;
      at = std::clamp(kept, 0.0f, float(kOnCard - 1));
    }
    const auto k = segment(at);
    const float share = at - float(k);
    const auto mix = [&](const auto& values) { return (values[k] + share * (values[k + 1] - values[k])); };
    const Eigen::Vector3f middle = mix(ribbon_.middle), across = mix(ribbon_.across).normalized(),
                          along = mix(ribbon_.along).normalized();
    const Eigen::Vector3f off = point - middle;
    return {off.dot(across) / mix(ribbon_.half_width), at / float(kOnCard - 1), off.dot(along.cross(across))};
  }

  [[nodiscard]] float half_width(float v) const {
    const auto k = segment(v * float(kOnCard - 1));
    const float share = v * float(kOnCard - 1) - float(k);
    return ribbon_.half_width[k] + share * (ribbon_.half_width[k + 1] - ribbon_.half_width[k]);
  }

 private:
  static std::size_t segment(float at) { return std::size_t(std::clamp(at, 0.0f, float(kOnCard) - 1.001f)); }

  const Ribbon& ribbon_;
};

/// Samples of a card.
class CardSamples {
 public:
  CardSamples(std::uint32_t across, std::uint32_t along)
      : width_(int(across) * kAcross),
        height_(int(along) * kAlong),
        front_(std::size_t(width_) * std::size_t(height_), -std::numeric_limits<float>::infinity()),
        along_(front_.size(), Eigen::Vector2f::Zero()),
        strand_(front_.size(), 0) {}

  /// A piece of a strand, which is `half` wide to either side, in samples across, at its ends.
  void draw(const OnCard& a, const OnCard& b, float half_a, float half_b, const Eigen::Vector2f& along, float strand) {
    const float ya = a.v * float(height_), yb = b.v * float(height_), xa = column(a.u), xb = column(b.u);
    const float rise = yb - ya;
    const int top = std::max(int(std::ceil(std::min(ya, yb) - 0.5f)), 0),
              bottom = std::min(int(std::ceil(std::max(ya, yb) - 0.5f)) - 1, height_ - 1);
    for (int y = top; y <= bottom; ++y) {
      const float t = (float(y) + 0.5f - ya) / rise;
      const float x = xa + t * (xb - xa), half = half_a + t * (half_b - half_a),
                  front = a.front + t * (b.front - a.front);
      const int left = std::max(int(std::ceil(x - half - 0.5f)), 0),
                right = std::min(int(std::floor(x + half - 0.5f)), width_ - 1);
      for (int c = left; c <= right; ++c)
        set(std::size_t(y) * std::size_t(width_) + std::size_t(c), front, along, strand);
    }
  }

  [[nodiscard]] float column(float u) const { return 0.5f * (u + 1) * float(width_); }
  [[nodiscard]] int width() const { return width_; }

  void develop(CardTexture& texture) const {
    for (std::uint32_t y = 0; y < texture.height; ++y) {
      for (std::uint32_t x = 0; x < texture.width; ++x) develop_texel(x, y, texture);
    }
  }

 private:
  void set(std::size_t at, float front, const Eigen::Vector2f& along, float strand) {
    if (!(front > front_[at])) return;
    front_[at] = front;
    along_[at] = along;
    strand_[at] = strand;
  }

  void develop_texel(std::uint32_t x, std::uint32_t y, CardTexture& texture) const {
    int covered = 0;
    float front = 0, strand = 0;
    Eigen::Vector2f along = Eigen::Vector2f::Zero();
    for (int s = 0; s < kAcross * kAlong; ++s) {
      const std::size_t at = (std::size_t(y) * kAlong + std::size_t(s / kAcross)) * std::size_t(width_) +
                             std::size_t(x) * kAcross + std::size_t(s % kAcross);
      if (!std::isfinite(front_[at])) continue;
      ++covered;
      front += front_[at];
      along += along_[at];
      strand += strand_[at];
    }
    const std::size_t at = std::size_t(y) * texture.width + x;
    texture.opacity[at] = float(covered) / float(kAcross * kAlong);
    if (covered == 0) return;
    texture.depth[at] = front / float(covered);
    texture.along[at] = along / float(covered);
    texture.strand[at] = strand / float(covered);
  }

  int width_, height_;
  std::vector<float> front_;
  std::vector<Eigen::Vector2f> along_;
  std::vector<float> strand_;
};

/// Where no strand is, directions are as beside: what covers there later, covers as its neighbours do.
void fill_directions(CardTexture& texture) {
  const auto reach = std::size_t(std::max(texture.width / 3, 4u));
  std::vector<Eigen::Vector2f> sums(texture.width + 1);
  for (std::uint32_t y = 0; y < texture.height; ++y) {
    Eigen::Vector2f* const row = &texture.along[std::size_t(y) * texture.width];
    sums[0].setZero();
    for (std::uint32_t x = 0; x < texture.width; ++x) sums[x + 1] = sums[x] + row[x];
    for (std::size_t x = 0; x < texture.width; ++x) {
      if (!row[x].isZero()) continue;
      const Eigen::Vector2f sum = sums[std::min<std::size_t>(x + reach, texture.width)] - sums[x - std::min(x, reach)];
      row[x] = sum.norm() > 1e-3f ? sum.normalized() : Eigen::Vector2f::UnitY().eval();
    }
  }
}

/// A number of 0..1 that is another for each strand and the same in each run.
float number_of(std::uint32_t strand) {
  std::uint32_t h = strand * 2654435769u;
  h ^= h >> 16;
  h *= 2246822507u;
  h ^= h >> 13;
  return float(h >> 8) * 0x1p-24f;
}

}  // namespace

CardTexture draw_on_card(const Groom& groom, std::span<const std::uint8_t> is_reversed, const Wisp& wisp, float width,
                         std::uint32_t texels_across, std::uint32_t texels_along) {
  CardTexture texture;
  texture.width = texels_across;
  texture.height = texels_along;
  const std::size_t texels = std::size_t(texels_across) * texels_along;
  texture.opacity.assign(texels, 0);
  texture.depth.assign(texels, 0);
  texture.along.assign(texels, Eigen::Vector2f::Zero());
  texture.strand.assign(texels, 0);
  const FlatRibbon flat(wisp.ribbon);
  const float length = length_of(wisp.ribbon);
  CardSamples samples(texels_across, texels_along);
  for (const std::uint32_t i : wisp.members) {
    const auto strand = groom.strand(i);
    const bool from_end = !is_reversed.empty() && is_reversed[i] != 0;
    const auto at = [&](std::size_t p) { return from_end ? strand.size() - 1 - p : p; };
    OnCard before = flat.place(strand[at(0)], 0);
    for (std::size_t p = 1; p < strand.size(); ++p) {
      const OnCard now = flat.place(strand[at(p)], std::min(before.v + 0.02f, 1.0f));
      const auto half = [&](const OnCard& place, std::size_t point) {
        const float wide = groom.widths.empty() ? width : groom.widths[groom.begin[i] + at(point)];
        return 0.25f * wide / flat.half_width(place.v) * float(samples.width());
      };
      const Eigen::Vector2f way((now.u - before.u) * flat.half_width(now.v), (now.v - before.v) * length);
      samples.draw(before, now, half(before, p - 1), half(now, p), way.norm() > 0 ? way.normalized() : way,
                   number_of(i));
      before = now;
    }
  }
  samples.develop(texture);
  fill_directions(texture);
  return texture;
}

}  // namespace coif
