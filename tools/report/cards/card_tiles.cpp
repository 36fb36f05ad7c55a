#include "base/srgb.h"
#include "report/cards/card_sheets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace coif::report {
namespace {

const Eigen::Vector3f kHair(0.66f, 0.40f, 0.22f), kGround(0.045f, 0.05f, 0.06f);  // linear
constexpr float kLine = 0.8f;  // pixels, from a triangle's edge inwards

render::Picture square_picture(std::uint32_t size, const std::function<Eigen::Vector3f(std::size_t)>& linear_color) {
  render::Picture picture;
  picture.width = picture.height = size;
  picture.rgba.resize(std::size_t{4} * size * size, 255);
  for (std::size_t i = 0; i < std::size_t(size) * size; ++i) {
    const Eigen::Vector3f color = linear_color(i);
    for (int k = 0; k < 3; ++k) {
      picture.rgba[4 * i + std::size_t(k)] = std::uint8_t(255 * encode_srgb(std::clamp(color[k], 0.0f, 1.0f)) + 0.5f);
    }
  }
  return picture;
}

/// A different colour for each number.
Eigen::Vector3f color_of_number(std::uint32_t number) {
  const float hue = 6 * std::fmod(0.618034f * float(number), 1.0f);
  const auto channel = [hue](float at) { return std::clamp(std::abs(std::fmod(hue + at, 6.0f) - 3) - 1, 0.0f, 1.0f); };
  return Eigen::Vector3f::Constant(0.15f) + 0.35f * Eigen::Vector3f(channel(0), channel(4), channel(2));
}

/// The nearest triangle of a surface at each pixel.
struct NearestTriangle {
  float depth = std::numeric_limits<float>::infinity();
  std::uint32_t strip = 0;
  bool is_edge = false;
};

/// One number per triangle: triangles that share vertices have the same.
std::vector<std::uint32_t> strips_of(const cards::CardSurface& surface) {
  std::vector<std::uint32_t> first(surface.positions.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) first[v] = v;
  const auto find = [&first](std::uint32_t v) {
    while (first[v] != v) v = first[v] = first[first[v]];
    return v;
  };
  const std::size_t triangles = surface.triangles.size() / 3;
  for (std::size_t i = 0; i < 3 * triangles; ++i) {
    const std::uint32_t a = find(surface.triangles[i - i % 3]), b = find(surface.triangles[i]);
    first[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> strips(triangles);
  for (std::size_t t = 0; t < triangles; ++t) strips[t] = find(surface.triangles[3 * t]);
  return strips;
}

void draw_outlined(const std::array<Eigen::Vector3f, 3>& corners, std::uint32_t strip, std::uint32_t size,
                   std::vector<NearestTriangle>& pixels) {
  const Eigen::AlignedBox3f box = Eigen::AlignedBox3f(corners[0]).extend(corners[1]).extend(corners[2]);
  const auto side = [&](int k, float x, float y) {
    const Eigen::Vector3f &a = corners[std::size_t(k + 1) % 3], &b = corners[std::size_t(k + 2) % 3];
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  const float area = side(0, corners[0].x(), corners[0].y());
  if (std::abs(area) < 1e-6f) return;
  const auto first = [](float at) { return int(std::ceil(std::max(at - 0.5f, 0.0f))); };
  const auto last = [&](float at) { return int(std::floor(std::min(at - 0.5f, float(size) - 1))); };
  for (int y = first(box.min().y()); y <= last(box.max().y()); ++y) {
    for (int x = first(box.min().x()); x <= last(box.max().x()); ++x) {
      float depth = 0;
      bool is_in = true, is_edge = false;
      for (int k = 0; k < 3; ++k) {
        const float off = side(k, float(x) + 0.5f, float(y) + 0.5f), weight = off / area;
        const Eigen::Vector3f edge = corners[std::size_t(k + 2) % 3] - corners[std::size_t(k + 1) % 3];
        is_in = is_in && weight >= 0;
        is_edge = is_edge || std::abs(off) < kLine * edge.head<2>().norm();
        depth += weight * corners[std::size_t(k)].z();
      }
      NearestTriangle& pixel = pixels[std::size_t(y) * size + std::size_t(x)];
      if (is_in && depth < pixel.depth) pixel = {depth, strip, is_edge};
    }
  }
}

}  // namespace

render::Picture hair_tile(const cards::HairPicture& hair, const cards::PictureFrame& frame) {
  const float wide = float(frame.size) / frame.pixels_of_metre;
  return square_picture(hair.size, [&](std::size_t i) -> Eigen::Vector3f {
    const float near = std::clamp(0.6f - 1.6f * hair.depth[i] / wide, 0.15f, 1.0f);
    return (1 - hair.coverage[i]) * kGround + near * hair.shade[i] * kHair;
  });
}

render::Picture difference_tile(const cards::HairPicture& wanted, const cards::HairPicture& seen) {
  return square_picture(wanted.size, [&](std::size_t i) -> Eigen::Vector3f {
    const float more = seen.shade[i] - wanted.shade[i];
    const Eigen::Vector3f color = more > 0 ? Eigen::Vector3f(1, 0.15f, 0.05f) : Eigen::Vector3f(0.1f, 0.35f, 1);
    const float hair = std::max(wanted.coverage[i], seen.coverage[i]);
    return kGround + 0.06f * hair * Eigen::Vector3f::Ones() + std::abs(more) * color;
  });
}

render::Picture wire_tile(const cards::CardSurface& surface, const cards::PictureFrame& frame) {
  std::vector<NearestTriangle> pixels(std::size_t(frame.size) * frame.size);
  const std::vector<std::uint32_t> strips = strips_of(surface);
  for (std::size_t t = 0; t < strips.size(); ++t) {
    std::array<Eigen::Vector3f, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = frame.place(surface.positions[surface.triangles[3 * t + k]]);
    draw_outlined(corners, strips[t], frame.size, pixels);
  }
  return square_picture(frame.size, [&](std::size_t i) -> Eigen::Vector3f {
    if (!std::isfinite(pixels[i].depth)) return kGround;
    return (pixels[i].is_edge ? 0.25f : 1.0f) * color_of_number(pixels[i].strip);
  });
}

render::Picture texture_tile(const cards::CardSurface& surface, std::uint32_t size) {
  const std::uint32_t longer = std::max(surface.width, surface.height);
  return square_picture(size, [&](std::size_t i) -> Eigen::Vector3f {
    // The range of texels of a pixel.
    const auto range = [&](std::size_t pixel, std::uint32_t texels) {
      const std::size_t from = pixel * longer / size;
      return std::pair(from, std::min<std::size_t>(std::max(from + 1, (pixel + 1) * longer / size), texels));
    };
    const auto [left, right] = range(i % size, surface.width);
    const auto [top, bottom] = range(i / size, surface.height);
    if (left >= right || top >= bottom) return kGround;
    float sum = 0;
    for (std::size_t y = top; y < bottom; ++y) {
      for (std::size_t x = left; x < right; ++x) sum += surface.opacity[y * surface.width + x];
    }
    return Eigen::Vector3f::Constant(sum / float((right - left) * (bottom - top)));
  });
}

}  // namespace coif::report
