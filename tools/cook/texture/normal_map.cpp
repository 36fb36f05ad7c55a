#include "cook/texture/relief.h"

#include <coif/asset_records.h>

#include <fmt/format.h>
#include <Eigen/Core>

namespace coif::cook {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kGrey = 3;             ///< In steps of 255: after JPEG, channels of a grey image differ by no more.
constexpr double kNearlyAll = 0.98;  ///< Share of the texels.
constexpr double kUnitSlack = 0.25;  ///< Share of a normal's length; resizing shortens them.
/// Share of the texels whose normal may have another length, or point inwards.
constexpr double kMostUnlike = 0.3;
constexpr double kHeightSlope = 0.3;   ///< RMS slope of a map of heights.
constexpr double kSureOfGreen = 0.05;  ///< Correlation from which on a map shows which way green leads.
/// Smallest height of a unit normal over the surface.
constexpr double kLeastUp = 0.05;

/// Both middle bytes mean zero.
double signed_of(std::uint8_t byte) { return byte == 127 || byte == 128 ? 0 : byte / 127.5 - 1; }

const std::uint8_t* texel(const Image& image, std::size_t x, std::size_t y) {
  return &image.texels[image.channels * (y % image.height * image.width + x % image.width)];
}

template <typename Holds>
double share_of_texels(const Image& image, const Holds& holds) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.texels.size(); i += image.channels) count += holds(&image.texels[i]) ? 1 : 0;
  return double(count) / double(image.texel_count());
}

bool is_grey(const std::uint8_t* c) {
  const auto [low, high] = std::minmax({c[0], c[1], c[2]});
  return high - low <= kGrey;
}

Vector3d normal_of(const std::uint8_t* c) { return {signed_of(c[0]), signed_of(c[1]), signed_of(c[2])}; }

/// Blue left out: some tools store two channels and let the reader find the third.
bool has_two_channels(const Image& map) {
  return share_of_texels(map, [](const std::uint8_t* c) { return c[2] <= kGrey; }) > kNearlyAll;
}

std::optional<std::string> refusal_of(const Image& map) {
  const double inwards = share_of_texels(map, [](const std::uint8_t* c) { return normal_of(c).z() < -0.1; });
  const double unlike =
      share_of_texels(map, [](const std::uint8_t* c) { return std::abs(normal_of(c).norm() - 1) > kUnitSlack; });
  if (unlike > kMostUnlike) return fmt::format("{:.0f} % of its texels are no unit vectors", 100 * unlike);
  if (inwards > kMostUnlike) {
    return fmt::format(
        "{:.0f} % of its normals lead into the surface: it shows something else, or normals in the model's axes",
        100 * inwards);
  }
  return std::nullopt;
}

/// Correlation of the changes that agree where green leads down; 0 where nothing changes.
double green_leads_down(const Image& map) {
  double both = 0, first = 0, second = 0;
  for (std::size_t y = 0; y < map.height; ++y) {
    for (std::size_t x = 0; x < map.width; ++x) {
      const std::uint8_t *here = texel(map, x, y), *right = texel(map, x + 1, y), *below = texel(map, x, y + 1);
      const double red_down = double(below[0]) - here[0], green_right = double(right[1]) - here[1];
      both += red_down * green_right;
      first += red_down * red_down;
      second += green_right * green_right;
    }
  }
  return first > 0 && second > 0 ? both / std::sqrt(first * second) : 0;
}

/// `normal_at(x, y)`: along U, along V and out of the surface, of any length.
template <typename NormalAt>
Image draw_normals(std::uint32_t width, std::uint32_t height, double strength, const NormalAt& normal_at) {
  Image normals{width, height, 2, {}};
  normals.texels.reserve(2 * normals.texel_count());
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      Vector3d normal = normal_at(x, y);
      normal.head<2>() *= strength;
      normal.z() = std::max(normal.z(), kLeastUp);
      normal.normalize();
      normals.texels.push_back(two_sided_byte(normal.x()));
      normals.texels.push_back(two_sided_byte(normal.y()));
    }
  }
  return normals;
}

NormalMap from_heights(const Image& map, double strength) {
  const auto slope = [&](std::size_t x, std::size_t y) {
    const auto height = [&](std::size_t dx, std::size_t dy) {
      return double(texel(map, x + map.width + dx - 1, y + map.height + dy - 1)[0]);
    };
    return Vector2d(height(0, 1) - height(2, 1), height(1, 0) - height(1, 2));
  };
  double squares = 0;
  for (std::size_t y = 0; y < map.height; ++y) {
    for (std::size_t x = 0; x < map.width; ++x) squares += slope(x, y).squaredNorm();
  }
  const double rms = std::sqrt(squares / double(map.texel_count()));
  const double scale = rms > 0 ? kHeightSlope / rms : 0;
  const auto normal_at = [&](std::size_t x, std::size_t y) {
    const Vector2d lean = scale * slope(x, y);
    return Vector3d(lean.x(), lean.y(), 1);
  };
  return {draw_normals(map.width, map.height, strength, normal_at), "a map of heights"};
}

}  // namespace

tl::expected<NormalMap, std::string> read_normal_map(const Image& map, const NormalMapUse& use) {
  if (share_of_texels(map, is_grey) > kNearlyAll) return from_heights(map, use.strength);
  const bool two = has_two_channels(map);
  if (const auto refusal = two ? std::nullopt : refusal_of(map)) return tl::unexpected(*refusal);
  std::string found = "a normal map, ";
  GreenAxis green = use.green.value_or(GreenAxis::kUp);
  const double down = green_leads_down(map);
  if (use.green) {
    found += fmt::format("green {}", green == GreenAxis::kUp ? "up" : "down");
  } else if (std::abs(down) < kSureOfGreen) {
    found += "green up as nothing shows the contrary";
  } else {
    green = down > 0 ? GreenAxis::kDown : GreenAxis::kUp;
    found += fmt::format("green {} as its slopes show (correlation {:.2f})", down > 0 ? "down" : "up", std::abs(down));
  }
  const double side = green == GreenAxis::kUp ? -1 : 1;
  const auto normal_at = [&](std::size_t x, std::size_t y) {
    const Vector3d n = normal_of(texel(map, x, y));
    const double up = two ? std::sqrt(std::max(0.0, 1 - n.head<2>().squaredNorm())) : n.z();
    return Vector3d(n.x(), side * n.y(), up);
  };
  return NormalMap{draw_normals(map.width, map.height, use.strength, normal_at), found};
}

namespace {

constexpr std::uint32_t kBlocks = 128;  ///< Along the longer side, and not less than kLeastBlock texels each.
constexpr std::uint32_t kLeastBlock = 4;
constexpr double kNoise = 4.0 / 127;          ///< RMS spread of compressed images.
constexpr double kUnsure = 0.2, kSure = 0.6;  ///< Coherence; noise has some.

/// Spread of the normals in a block: their variance along U less that along V, twice the covariance, and the sum.
struct Spread {
  double difference = 0, twice_joint = 0, all = 0;
};

Spread spread_in(const Image& normals, std::uint32_t left, std::uint32_t top, std::uint32_t side) {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0, count = 0;
  for (std::uint32_t row = top; row < std::min(top + side, normals.height); ++row) {
    for (std::uint32_t column = left; column < std::min(left + side, normals.width); ++column) {
      const std::uint8_t* c = texel(normals, column, row);
      const double u = double(two_sided(float(c[0]) / 255)), v = double(two_sided(float(c[1]) / 255));
      x += u, y += v, xx += u * u, xy += u * v, yy += v * v, count += 1;
    }
  }
  xx = xx / count - x * x / (count * count);
  yy = yy / count - y * y / (count * count);
  xy = xy / count - x * y / (count * count);
  return {xx - yy, 2 * xy, xx + yy};
}

/// The sum over neighbouring blocks, those further away with less weight.
Spread around(std::span<const Spread> blocks, std::uint32_t width, std::uint32_t height, std::uint32_t x,
              std::uint32_t y) {
  Spread sum;
  for (std::uint32_t dy : {0u, 1u, 2u}) {
    for (std::uint32_t dx : {0u, 1u, 2u}) {
      const Spread& s = blocks[std::size_t(y + height + dy - 1) % height * width + (x + width + dx - 1) % width];
      const double weight = (dx == 1 ? 2 : 1) * (dy == 1 ? 2 : 1) / 16.0;
      sum.difference += weight * s.difference;
      sum.twice_joint += weight * s.twice_joint;
      sum.all += weight * s.all;
    }
  }
  return sum;
}

/// Cosine and sine of twice the angle, times the certainty. The axis is perpendicular to that of the largest spread.
Vector2d axis_of(const Spread& spread) {
  const Vector2d across(spread.difference, spread.twice_joint);
  const double length = across.norm();
  if (!(length > 0)) return Vector2d::Zero();
  const double coherence = length / (spread.all + kNoise * kNoise);
  return across / length * -std::clamp((coherence - kUnsure) / (kSure - kUnsure), 0.0, 1.0);
}

}  // namespace

Image strand_axes(const Image& normals) {
  const std::uint32_t side = std::max(kLeastBlock, std::max(normals.width, normals.height) / kBlocks);
  Image axes{(normals.width + side - 1) / side, (normals.height + side - 1) / side, 2, {}};
  std::vector<Spread> blocks;
  for (std::uint32_t y = 0; y < axes.height; ++y) {
    for (std::uint32_t x = 0; x < axes.width; ++x) blocks.push_back(spread_in(normals, x * side, y * side, side));
  }
  for (std::uint32_t y = 0; y < axes.height; ++y) {
    for (std::uint32_t x = 0; x < axes.width; ++x) {
      const Vector2d axis = axis_of(around(blocks, axes.width, axes.height, x, y));
      axes.texels.push_back(two_sided_byte(axis.x()));
      axes.texels.push_back(two_sided_byte(axis.y()));
    }
  }
  return axes;
}

}  // namespace coif::cook
