#include "mannequin/solid_shapes.h"
#include "research/sample/strips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::research {
namespace {

using Eigen::Vector3d;

constexpr int kWidth = StrandTexture::kWidth;
constexpr int kHeight = StrandTexture::kHeight;
constexpr double kTexelsPerLock = 6.0;
constexpr double kTexelsPerStrand = 1.15;  // Dense enough that strands overlap about three deep.

/// sRGB 0..1 of the mean hair at `v`: darker roots, lighter tips.
Vector3d hair_color(const StrandColors& colors, double v) {
  const auto& [root, length, tip] = colors;
  return root + mannequin::smooth_step(-0.05, 0.35, v) * (length - root) +
         mannequin::smooth_step(0.35, 1.0, v) * (tip - length);
}

struct Strand {
  double x;  ///< Texels from the left edge, at the root.
  double sway, turns, phase;
  double half_width;  ///< Texels.
  double begin, end;  ///< V where it starts and ends.
  double brightness;
  double warmth;
};

struct Texel {
  Vector3d color;
  double alpha;
};

class StrandPainter {
 public:
  explicit StrandPainter(const StrandColors& colors)
      : colors_(colors), texels_(static_cast<std::size_t>(kWidth) * kHeight) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) at(x, y) = {0.72 * hair_color(colors_, (y + 0.5) / kHeight), 0.0};
  }

  /// `tone` brightens or darkens the whole clump, so that neighbouring strips differ.
  void paint_window(const TextureWindow& window, double tone, mannequin::SeededNoise& noise) {
    const double from = window.from * kWidth, to = window.to * kWidth;
    paint_core(from, to, noise);
    const std::vector<double> lock_tones = random_lock_tones(noise);
    const int count = static_cast<int>((to - from) / kTexelsPerStrand * 3.0);
    for (int i = 0; i < count; ++i) {
      Strand strand = random_strand(from, to, static_cast<double>(i) / count, noise);
      const double across = (strand.x - from) / (to - from);
      const double side = std::min(across, 1.0 - across);
      strand.brightness *= tone * (0.70 + 0.30 * mannequin::smooth_step(0.0, 0.22, side));
      strand.brightness *= lock_tones[static_cast<std::size_t>((strand.x - from) / kTexelsPerLock)];
      paint(strand, from, to);
    }
  }

  [[nodiscard]] StrandTexture finish() const {
    StrandTexture texture;
    texture.rgba.reserve(texels_.size() * 4);
    for (const Texel& texel : texels_) {
      for (int c = 0; c < 3; ++c) texture.rgba.push_back(quantised(texel.color[c]));
      texture.rgba.push_back(quantised(texel.alpha));
    }
    return texture;
  }

 private:
  Texel& at(int x, int y) { return texels_[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)]; }

  static std::uint8_t quantised(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
  }

  /// Strands stick together in thin locks of one tone.
  static std::vector<double> random_lock_tones(mannequin::SeededNoise& noise) {
    std::vector<double> tones(static_cast<std::size_t>(kWidth / kTexelsPerLock) + 1);
    for (double& tone : tones) tone = noise.between(0.87, 1.09);
    return tones;
  }

  /// The closed part under the strands: opaque down to a ragged line, set back from the window's sides.
  void paint_core(double from, double to, mannequin::SeededNoise& noise) {
    double ragged = 0.0;
    for (int x = static_cast<int>(std::ceil(from)); x < static_cast<int>(to); ++x) {
      ragged = 0.75 * ragged + noise.between(-0.035, 0.035);
      const double side = std::min(x + 0.5 - from, to - x - 0.5) / (to - from);
      const double end = 0.70 + ragged - 0.25 * mannequin::smooth_step(0.22, 0.0, side);
      const double begin = 0.012 + 0.3 * std::abs(ragged);
      for (int y = 0; y < kHeight; ++y) {
        const double v = (y + 0.5) / kHeight;
        at(x, y).alpha = mannequin::smooth_step(end + 0.05, end, v) * mannequin::smooth_step(0.0, begin, v) *
                         mannequin::smooth_step(0.035, 0.075, side);
      }
    }
  }

  static Strand random_strand(double from, double to, double depth, mannequin::SeededNoise& noise) {
    Strand strand{};
    const double across = noise.between(0.03, 0.97);
    strand.x = from + across * (to - from);
    strand.sway = noise.between(0.4, 2.6);
    strand.turns = noise.between(0.4, 1.6);
    strand.phase = noise.between(0.0, 1.0);
    strand.half_width = noise.between(0.55, 1.15);
    // Strands in the middle of a clump reach further than those at its sides.
    const double middle = 1.0 - std::abs(2.0 * across - 1.0);
    strand.begin = noise.between(-0.01, 0.035);
    strand.end = 0.74 + 0.11 * std::sqrt(middle) + noise.between(0.0, 0.14);
    strand.brightness = noise.between(0.78, 1.06) + 0.14 * depth;
    strand.warmth = noise.between(-0.035, 0.035);
    return strand;
  }

  void paint(const Strand& strand, double from, double to) {
    for (int y = 0; y < kHeight; ++y) {
      const double v = (y + 0.5) / kHeight;
      if (v < strand.begin || v > strand.end) continue;
      const double wave = std::sin(2.0 * std::numbers::pi * (strand.turns * v + strand.phase));
      const double center = strand.x + strand.sway * wave;
      const double thin = mannequin::smooth_step(strand.end, strand.end - 0.16, v) *
                          mannequin::smooth_step(strand.begin, strand.begin + 0.02, v);
      const double half = strand.half_width * (0.35 + 0.65 * thin);
      paint_span(strand, v, y, center, half, std::sqrt(thin), from, to);
    }
  }

  void paint_span(const Strand& strand, double v, int y, double center, double half, double strength, double from,
                  double to) {
    const int first =
        std::max(static_cast<int>(std::floor(center - half - 0.5)), static_cast<int>(std::ceil(from)) + 1);
    const int last = std::min(static_cast<int>(std::ceil(center + half)), static_cast<int>(to) - 2);
    const Vector3d color = hair_color(colors_, v)
                               .cwiseProduct(Vector3d{strand.brightness + strand.warmth, strand.brightness,
                                                      strand.brightness - strand.warmth});
    for (int x = first; x <= last; ++x) {
      const double off = std::abs(x + 0.5 - center);
      const double cover = strength * std::clamp(half + 0.5 - off, 0.0, 1.0);
      if (cover <= 0.0) continue;
      const double round = 1.0 - 0.30 * std::min(off / half, 1.0) * std::min(off / half, 1.0);
      Texel& texel = at(x, y);
      texel.color += cover * (round * color - texel.color);
      texel.alpha += cover * (1.0 - texel.alpha);
    }
  }

  StrandColors colors_;
  std::vector<Texel> texels_;
};

}  // namespace

StrandTexture make_strand_texture(const StrandColors& colors) {
  mannequin::SeededNoise noise(2011);
  StrandPainter painter(colors);
  constexpr std::array<double, kClumpWindows.size()> kTones{1.00, 0.92, 1.06, 0.97};
  for (std::size_t i = 0; i < kClumpWindows.size(); ++i) painter.paint_window(kClumpWindows[i], kTones[i], noise);
  painter.paint_window(kBroadWindow, 0.82, noise);  // The inner layer lies in the others' shadow.
  return painter.finish();
}

}  // namespace coif::research
