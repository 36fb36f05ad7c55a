#include "base/srgb.h"
#include "cook/texture/vertex_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr std::uint32_t kBandRows = 256;  ///< Rows of the image at a time, which limits memory.
/// A triangle also colours texels this far beyond its edges, which filtering reads there.
constexpr float kReachTexels = 0.8f;
constexpr float kEdgeWeight = 1.0e-3f;    ///< Weight of such texels where another triangle contains them.
constexpr float kSeenDifference = 0.06f;  ///< Square roots of linear numbers differ by so much.
constexpr double kManyDiffering = 0.02;   ///< Share of the triangles that differ.
constexpr double kMostTexelRows = 4;      ///< Repeats of the image that one triangle may span.

/// One triangle in texels, with the values to interpolate.
struct TexelTriangle {
  std::array<Vector2f, 3> corner;
  std::array<const Vector4f*, 3> color;
  float area = 0;   ///< Doubled, signed.
  Vector3f height;  ///< Texels from each corner to the edge opposite.

  [[nodiscard]] Vector3f weights(const Vector2f& p) const {
    const Vector2f ab = corner[1] - corner[0], ac = corner[2] - corner[0], ap = p - corner[0];
    const float b = (ap.x() * ac.y() - ap.y() * ac.x()) / area, c = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
    return {1 - b - c, b, c};
  }
  [[nodiscard]] Vector4f color_at(const Vector3f& weights) const {
    const Vector3f inside = weights.cwiseMax(0.0f) / weights.cwiseMax(0.0f).sum();
    return inside[0] * *color[0] + inside[1] * *color[1] + inside[2] * *color[2];
  }
};

std::optional<TexelTriangle> texel_triangle(const HairMesh& hair, std::size_t t, const Image& image) {
  TexelTriangle out;
  const Vector2f size(float(image.width), float(image.height));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = hair.triangles[3 * t + k];
    out.corner[k] = hair.uvs[v].cwiseProduct(size);
    out.color[k] = &hair.colors[v];
  }
  const Vector2f ab = out.corner[1] - out.corner[0], ac = out.corner[2] - out.corner[0];
  out.area = ab.x() * ac.y() - ab.y() * ac.x();
  if (std::abs(out.area) < 1.0e-6f) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    out.height[Eigen::Index(k)] = std::abs(out.area) / (out.corner[(k + 2) % 3] - out.corner[(k + 1) % 3]).norm();
  }
  const Vector2f low = out.corner[0].cwiseMin(out.corner[1]).cwiseMin(out.corner[2]);
  const Vector2f high = out.corner[0].cwiseMax(out.corner[1]).cwiseMax(out.corner[2]);
  const bool fits = ((high - low).cwiseQuotient(size).array() <= float(kMostTexelRows)).all();
  return fits ? std::optional(out) : std::nullopt;
}

std::uint32_t wrapped_texel(std::int64_t at, std::uint32_t size) { return std::uint32_t((at % size + size) % size); }

/// Colours of some rows of the image: sums over the triangles that show each texel.
class ColorBand {
 public:
  ColorBand(const Image& image, std::uint32_t first_row)
      : image_(image),
        first_(first_row),
        rows_(std::min(kBandRows, image.height - first_row)),
        sum_(std::size_t(rows_) * image.width, Vector4f::Zero()),
        weight_(sum_.size(), 0.0f) {}

  void add(const TexelTriangle& triangle) {
    const auto [low, high] = std::minmax({triangle.corner[0].y(), triangle.corner[1].y(), triangle.corner[2].y()});
    for (auto y = std::int64_t(std::floor(low - 1)); float(y) <= high + 1; ++y) {
      const std::uint32_t row = wrapped_texel(y, image_.height);
      if (row >= first_ && row < first_ + rows_) add_row(triangle, y, row - first_);
    }
  }

  void multiply(Image& image, std::span<const float> linear) const {
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      if (weight_[i] <= 0) continue;
      const Vector4f color = sum_[i] / weight_[i];
      std::uint8_t* const texel = &image.texels[4 * (std::size_t(first_) * image.width + i)];
      for (int k = 0; k < 3; ++k) {
        const double lit = std::min(1.0, double(linear[texel[k]] * color[k]));
        texel[k] = std::uint8_t(std::lround(std::clamp(encode_srgb(lit), 0.0, 1.0) * 255));
      }
      texel[3] = std::uint8_t(std::lround(std::clamp(double(float(texel[3]) * color.w()), 0.0, 255.0)));
    }
  }

  /// Whether the middle of the triangle lies in these rows and got another colour than the triangle's.
  [[nodiscard]] bool differs_from(const TexelTriangle& triangle) const {
    const Vector2f middle = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) / 3;
    const std::uint32_t row = wrapped_texel(std::int64_t(std::floor(middle.y())), image_.height);
    if (row < first_ || row >= first_ + rows_) return false;
    const std::size_t i =
        std::size_t(row - first_) * image_.width + wrapped_texel(std::int64_t(std::floor(middle.x())), image_.width);
    if (weight_[i] <= 0) return false;
    // The texel's own middle, which a small triangle may not have.
    const Vector2f texel(std::floor(middle.x()) + 0.5f, std::floor(middle.y()) + 0.5f);
    const Vector4f own = triangle.color_at(triangle.weights(texel)), got = sum_[i] / weight_[i];
    return (own.array().max(0.0f).sqrt() - got.array().max(0.0f).sqrt()).abs().maxCoeff() > kSeenDifference;
  }

 private:
  void add_row(const TexelTriangle& triangle, std::int64_t y, std::uint32_t row) {
    const auto [low, high] = std::minmax({triangle.corner[0].x(), triangle.corner[1].x(), triangle.corner[2].x()});
    for (auto x = std::int64_t(std::floor(low - 1)); float(x) <= high + 1; ++x) {
      const Vector3f weights = triangle.weights({float(x) + 0.5f, float(y) + 0.5f});
      if ((weights.cwiseProduct(triangle.height).array() < -kReachTexels).any()) continue;
      const float counts = weights.minCoeff() >= 0 ? 1.0f : kEdgeWeight;
      const std::size_t i = std::size_t(row) * image_.width + wrapped_texel(x, image_.width);
      sum_[i] += counts * triangle.color_at(weights);
      weight_[i] += counts;
    }
  }

  const Image& image_;
  std::uint32_t first_, rows_;
  std::vector<Vector4f> sum_;
  std::vector<float> weight_;
};

}  // namespace

void bake_vertex_colors(Image& image, HairMesh& hair, Findings& findings) {
  if (hair.colors.empty()) return;
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = float(decode_srgb(double(i) / 255));
  std::vector<TexelTriangle> triangles;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    if (const auto triangle = texel_triangle(hair, t, image)) triangles.push_back(*triangle);
  }
  std::size_t differing = hair.triangle_count() - triangles.size();
  for (std::uint32_t row = 0; row < image.height; row += kBandRows) {
    ColorBand band(image, row);
    for (const TexelTriangle& triangle : triangles) band.add(triangle);
    for (const TexelTriangle& triangle : triangles) differing += band.differs_from(triangle) ? 1 : 0;
    band.multiply(image, linear);
  }
  if (double(differing) > kManyDiffering * double(hair.triangle_count())) {
    findings.warn("C152", fmt::format("{} of {} triangles share texels with others of different vertex colours, or "
                                      "have none of their own, and get "
                                      "a mean; unwrap them apart, or paint the colours into the texture",
                                      differing, hair.triangle_count()));
  }
  hair.colors.clear();
}

void keep_vertex_colors(std::uint32_t max_size, BaseColor& color, HairMesh& hair, Findings& findings) {
  if (hair.colors.empty()) return;
  if (hair.uvs.empty()) {
    color.image = make_color_squares(hair, findings);
    color.is_of_vertex_colors = true;
  } else if (color.image) {
    color.image = reduce(std::move(*color.image), max_size, TexelMeaning::kSrgbColorAlpha);
    bake_vertex_colors(*color.image, hair, findings);
  } else {
    findings.warn("C152",
                  "the hair's vertex colours are lost: no image can hold them; unwrap the hair, or give it a texture");
    hair.colors.clear();
  }
}

}  // namespace coif::cook
