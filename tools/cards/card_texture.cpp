#include "cards/card_texture.h"

#include "cards/choose_cards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace coif::cards {
namespace {

constexpr int kAcross = 8, kAlong = 4;  // samples of a texel
constexpr float kLeastUpright = 0.1f;   // Cosine from along the card: a strand across it has no width in a row.
constexpr std::size_t kOnCard = Ribbon::kStations;

/// A place on a flat card: u from -1 to 1 across, v from 0 to 1 along, and metres in front.
struct OnCard {
  float u = 0, v = 0, front = 0;
};

/// A strip as it is drawn, with interpolation between its stations.
class FlatStrip {
 public:
  FlatStrip(const Ribbon& ribbon, const CardStrip& strip) {
    const auto edges = ends_of_edges(ribbon, strip);
    for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
      const std::size_t begin = strip.stations[e], end = strip.stations[e + 1];
      for (std::size_t k = begin; k <= end; ++k) {
        const float share = float(k - begin) / float(end - begin);
        const auto mix = [share](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
          return (a + share * (b - a)).eval();
        };
        const Eigen::Vector3f left = mix(edges[e][0], edges[e + 1][0]), right = mix(edges[e][1], edges[e + 1][1]);
        middle_[k] = 0.5f * (left + right);
        side_[k] = 0.5f * (right - left);
        across_[k] = mix(ribbon.across[begin], ribbon.across[end]);
        along_[k] = mix(ribbon.along[begin], ribbon.along[end]);
      }
    }
    for (std::size_t k = 1; k < kOnCard; ++k) length_ += (middle_[k] - middle_[k - 1]).norm();
  }

  /// Near the place of the point before, `hint`, at which the search begins.
  [[nodiscard]] OnCard place(const Eigen::Vector3f& point, float hint) const {
    float at = hint * float(kOnCard - 1);
    for (int round = 0; round < 4; ++round) {
      const auto k = segment(at);
      const Eigen::Vector3f way = middle_[k + 1] - middle_[k];
      const float squared = way.squaredNorm();
      const float found = float(k) + (squared > 0 ? (point - middle_[k]).dot(way) / squared : 0.0f);
      const float kept = std::clamp(found, at - 1.5f, at + 1.5f);
      if (std::abs(kept - at) < 1e-3f) break;
      at = std::clamp(kept, 0.0f, float(kOnCard - 1));
    }
    const auto k = segment(at);
    const Eigen::Vector3f off = point - mixed(middle_, at), side = mixed(side_, at), way = middle_[k + 1] - middle_[k];
    const float squared = side.squaredNorm();
    const Eigen::Vector3f normal = way.cross(side);
    return {squared > 0 ? off.dot(side) / squared : 0.0f, at / float(kOnCard - 1),
            normal.norm() > 0 ? off.dot(normal.normalized()) : 0.0f};
  }

  [[nodiscard]] float half_width(float v) const { return mixed(side_, v * float(kOnCard - 1)).norm(); }
  [[nodiscard]] float length() const { return length_; }

  /// A direction by the directions across and along that are stored with the strip's edges, as pictures mix them.
  [[nodiscard]] Eigen::Vector2f direction(const Eigen::Vector3f& way, float v) const {
    const float at = v * float(kOnCard - 1);
    const Eigen::Vector2f found(way.dot(mixed(across_, at)), way.dot(mixed(along_, at)));
    return found.norm() > 0 ? found.normalized() : found;
  }

 private:
  using Stations = std::array<Eigen::Vector3f, kOnCard>;
  static std::size_t segment(float at) { return std::size_t(std::clamp(at, 0.0f, float(kOnCard) - 1.001f)); }
  static Eigen::Vector3f mixed(const Stations& values, float at) {
    const auto k = segment(at);
    return values[k] + (at - float(k)) * (values[k + 1] - values[k]);
  }

  Stations middle_, side_, across_, along_;
  float length_ = 0;
};

/// A piece of a flattened strand: values that are constant over it, and colours at its ends.
struct FlatPiece {
  OnCard a, b;
  float half_a = 0, half_b = 0;  ///< Half its width, in samples across.
  float upright = 1;             ///< Cosine of its angle with the card's length, 0..1.
  Eigen::Vector2f along = Eigen::Vector2f::Zero();
  float strand = 0;
  Eigen::Vector3f color_a = Eigen::Vector3f::Zero(), color_b = Eigen::Vector3f::Zero();
};

/// The front piece at a sample.
struct CardSample {
  float front = -std::numeric_limits<float>::infinity();
  std::uint32_t piece = 0;
  float share = 0;  ///< Place between the piece's ends, 0..1.
};

/// Samples of a card.
class CardSamples {
 public:
  CardSamples(std::uint32_t across, std::uint32_t along)
      : width_(int(across) * kAcross),
        height_(int(along) * kAlong),
        samples_(std::size_t(width_) * std::size_t(height_)) {}

  /// A piece at a slant cuts a row in a wider range than its width.
  void draw(const FlatPiece& piece) {
    const OnCard &a = piece.a, &b = piece.b;
    const float ya = a.v * float(height_), yb = b.v * float(height_), xa = column(a.u), xb = column(b.u);
    const float rise = yb - ya, upright = std::max(piece.upright, kLeastUpright);
    const int top = std::max(int(std::ceil(std::min(ya, yb) - 0.5f)), 0),
              bottom = std::min(int(std::ceil(std::max(ya, yb) - 0.5f)) - 1, height_ - 1);
    for (int y = top; y <= bottom; ++y) {
      const float t = (float(y) + 0.5f - ya) / rise;
      const float x = xa + t * (xb - xa), half = (piece.half_a + t * (piece.half_b - piece.half_a)) / upright,
                  front = a.front + t * (b.front - a.front);
      const int left = std::max(int(std::ceil(x - half - 0.5f)), 0),
                right = std::min(int(std::floor(x + half - 0.5f)), width_ - 1);
      for (int c = left; c <= right; ++c) {
        CardSample& sample = samples_[std::size_t(y) * std::size_t(width_) + std::size_t(c)];
        if (front > sample.front) sample = {front, std::uint32_t(pieces_.size()), t};
      }
    }
    pieces_.push_back(piece);
  }

  [[nodiscard]] float column(float u) const { return 0.5f * (u + 1) * float(width_); }
  [[nodiscard]] int width() const { return width_; }

  void develop(CardTexture& texture) const {
    for (std::uint32_t y = 0; y < texture.height; ++y) {
      for (std::uint32_t x = 0; x < texture.width; ++x) develop_texel(x, y, texture);
    }
  }

 private:
  void develop_texel(std::uint32_t x, std::uint32_t y, CardTexture& texture) const {
    int covered = 0;
    float front = 0, strand = 0;
    Eigen::Vector2f along = Eigen::Vector2f::Zero();
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    for (int s = 0; s < kAcross * kAlong; ++s) {
      const CardSample& sample = samples_[(std::size_t(y) * kAlong + std::size_t(s / kAcross)) * std::size_t(width_) +
                                          std::size_t(x) * kAcross + std::size_t(s % kAcross)];
      if (!std::isfinite(sample.front)) continue;
      const FlatPiece& piece = pieces_[sample.piece];
      ++covered;
      front += sample.front;
      along += piece.along;
      strand += piece.strand;
      color += piece.color_a + sample.share * (piece.color_b - piece.color_a);
    }
    const std::size_t at = std::size_t(y) * texture.width + x;
    texture.opacity[at] = float(covered) / float(kAcross * kAlong);
    if (covered == 0) return;
    texture.depth[at] = front / float(covered);
    texture.along[at] = along / float(covered);
    texture.strand[at] = strand / float(covered);
    if (!texture.color.empty()) texture.color[at] = color / float(covered);
  }

  int width_, height_;
  std::vector<CardSample> samples_;
  std::vector<FlatPiece> pieces_;
};

/// Gives texels without strands the mean of those beside them in their row that have one, so that texels that are made
/// to cover later look like their neighbours. Without such a neighbour they get `otherwise`.
template <typename Texel>
void fill_from_beside(const CardTexture& texture, const Texel& otherwise, std::vector<Texel>& texels) {
  const std::size_t reach = std::max(texture.width / 3, 4u);
  std::vector<Texel> sums(texture.width + 1);
  std::vector<int> counts(texture.width + 1, 0);
  sums[0] = Texel::Zero();
  for (std::uint32_t y = 0; y < texture.height; ++y) {
    const std::size_t row = std::size_t(y) * texture.width;
    for (std::size_t x = 0; x < texture.width; ++x) {
      const bool is_covered = texture.opacity[row + x] > 0;
      counts[x + 1] = counts[x] + (is_covered ? 1 : 0);
      sums[x + 1] = is_covered ? (sums[x] + texels[row + x]).eval() : sums[x];
    }
    for (std::size_t x = 0; x < texture.width; ++x) {
      if (texture.opacity[row + x] > 0) continue;
      const std::size_t first = x - std::min(x, reach), last = std::min<std::size_t>(x + reach, texture.width);
      const int count = counts[last] - counts[first];
      texels[row + x] = count > 0 ? ((sums[last] - sums[first]) / float(count)).eval() : otherwise;
    }
  }
}

/// Gives texels without strands the number of the nearest strand in their row, so that mips mix numbers of strands
/// only.
void spread_numbers(CardTexture& texture) {
  for (std::uint32_t y = 0; y < texture.height; ++y) {
    float* const row = &texture.strand[std::size_t(y) * texture.width];
    const float* const opacity = &texture.opacity[std::size_t(y) * texture.width];
    std::optional<std::size_t> before;
    for (std::size_t x = 0; x < texture.width; ++x) {
      if (opacity[x] == 0) continue;
      const std::size_t nearer = before ? (*before + x) / 2 + 1 : 0;
      if (before) std::fill(row + *before, row + nearer, row[*before]);
      std::fill(row + nearer, row + x, row[x]);
      before = x;
    }
    if (before) std::fill(row + *before, row + texture.width, row[*before]);
  }
}

/// Mean colour of all covered texels.
Eigen::Vector3f mean_color_of(const CardTexture& texture) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weight = 0;
  for (std::size_t i = 0; i < texture.color.size(); ++i) {
    sum += texture.opacity[i] * texture.color[i];
    weight += texture.opacity[i];
  }
  return weight > 0 ? (sum / weight).eval() : sum;
}

/// A number of 0..1 that is another for each strand and the same in each run.
float number_of(std::uint32_t strand) {
  std::uint32_t h = strand * 2654435769u;
  h ^= h >> 16;
  h *= 2246822507u;
  h ^= h >> 13;
  return float(h >> 8) * 0x1p-24f;
}

CardTexture empty_texture(std::uint32_t texels_across, std::uint32_t texels_along, bool has_color) {
  CardTexture texture;
  texture.width = texels_across;
  texture.height = texels_along;
  const std::size_t texels = std::size_t(texels_across) * texels_along;
  texture.opacity.assign(texels, 0);
  texture.depth.assign(texels, 0);
  texture.along.assign(texels, Eigen::Vector2f::Zero());
  texture.strand.assign(texels, 0.5f);
  if (has_color) texture.color.assign(texels, Eigen::Vector3f::Zero());
  return texture;
}

/// One end of a piece.
struct StrandPoint {
  OnCard place;
  float half = 0;  ///< Samples across.
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
};

}  // namespace

CardTexture draw_on_card(const groom::Groom& groom, std::span<const std::uint8_t> is_reversed, const Wisp& wisp,
                         const CardStrip& strip, float width, std::uint32_t texels_across, std::uint32_t texels_along) {
  CardTexture texture = empty_texture(texels_across, texels_along, !groom.colors.empty());
  const FlatStrip flat(wisp.ribbon, strip);
  CardSamples samples(texels_across, texels_along);
  for (const std::uint32_t i : wisp.members) {
    const std::size_t count = groom.strand(i).size();
    const bool from_end = !is_reversed.empty() && is_reversed[i] != 0;
    StrandPoint before;
    std::size_t last = 0;
    for (std::size_t p = 0; p < count; ++p) {
      const std::size_t point = groom.begin[i] + (from_end ? count - 1 - p : p);
      StrandPoint now;
      now.place = flat.place(groom.points[point], p == 0 ? 0 : std::min(before.place.v + 0.02f, 1.0f));
      const float wide = groom.widths.empty() ? width : groom.widths[point];
      now.half = 0.25f * wide / flat.half_width(now.place.v) * float(samples.width());
      if (!groom.colors.empty()) now.color = groom.colors[point];
      if (p > 0) {
        const Eigen::Vector2f way((now.place.u - before.place.u) * flat.half_width(now.place.v),
                                  (now.place.v - before.place.v) * flat.length());
        const float upright = way.norm() > 0 ? std::abs(way.y()) / way.norm() : 1.0f;
        const Eigen::Vector2f along =
            flat.direction(groom.points[point] - groom.points[last], 0.5f * (before.place.v + now.place.v));
        samples.draw(
            {before.place, now.place, before.half, now.half, upright, along, number_of(i), before.color, now.color});
      }
      last = point;
      before = now;
    }
  }
  samples.develop(texture);
  fill_from_beside(texture, Eigen::Vector2f::UnitY().eval(), texture.along);
  spread_numbers(texture);
  if (!texture.color.empty()) fill_from_beside(texture, mean_color_of(texture), texture.color);
  return texture;
}

}  // namespace coif::cards
