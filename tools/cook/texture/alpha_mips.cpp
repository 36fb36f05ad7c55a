#include "cook/texture/alpha.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>

namespace coif::cook {
namespace {

/// Multiple of the factor at which the faintest solid texel just passes.
constexpr double kLargestFactor = 4;
constexpr double kCloseEnough = 1.0e-3;  ///< Share of the wanted figure.
/// Steps for a factor: to a 1000th of its range, less than a step of alpha.
constexpr int kSearchSteps = 10;
constexpr int kSearchRounds = 2;  ///< Both factors affect both figures, each mostly one of them.

/// Twelve bits that no pattern of a texture follows.
std::uint32_t chance(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9E3779B1u ^ (y + 0x7F4A7C15u) * 0x85EBCA77u;
  h = (h ^ h >> 15) * 0x2C1B3C6Du;
  return (h ^ h >> 13) >> 20;
}

/// Ranks texels by opacity: by alpha, then by the alpha around, then at random.
std::vector<std::uint32_t> ranks(const Image& mip) {
  const std::uint32_t width = mip.width, height = mip.height;
  std::vector<std::uint32_t> result;
  result.reserve(mip.texel_count());
  const auto alpha = [&](std::uint32_t x, std::uint32_t y) {
    return std::uint32_t(mip.texels[4 * (std::size_t(y) * width + x) + 3]);
  };
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::uint32_t up = (y + height - 1) % height, down = (y + 1) % height;
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t left = (x + width - 1) % width, right = (x + 1) % width;
      const std::uint32_t around = alpha(left, y) + alpha(right, y) + alpha(x, up) + alpha(x, down);
      result.push_back(alpha(x, y) << 24 | around << 12 | chance(x, y));
    }
  }
  return result;
}

/// The rank from which on texels are to be solid, so that they hold as near to `share` of the used surface as can be.
std::uint32_t solid_from(const std::vector<std::uint32_t>& rank, const Image& used, double share) {
  struct Texel {
    std::uint32_t rank;
    std::uint8_t weight;
  };
  std::vector<Texel> texels;
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < rank.size(); ++i) {
    all += used.texels[i];
    // Nothing can be seen where there is no alpha at all.
    if (used.texels[i] != 0 && rank[i] >> 24 != 0) texels.push_back({rank[i], used.texels[i]});
  }
  std::ranges::sort(texels, [](const Texel& a, const Texel& b) { return a.rank > b.rank; });
  const double wanted = share * double(all);
  double held = 0;
  std::uint32_t from = ~std::uint32_t{0};  // no texel has as much: four neighbours fill ten bits of twelve
  for (const Texel& texel : texels) {
    if (held + 0.5 * texel.weight > wanted) break;
    held += texel.weight;
    from = texel.rank;
  }
  return from;
}

/// One mip during its adjustment.
class MipAlpha {
 public:
  MipAlpha(Image& mip, const Image& used, const AlphaThresholds& thresholds, double solid_share)
      : mip_(mip),
        alpha_(mip, 3),
        used_(used, 0),
        thresholds_(thresholds),
        rank_(ranks(mip)),
        from_(solid_from(rank_, used, solid_share)) {
    const std::uint32_t largest = *std::ranges::max_element(rank_) >> 24;
    const double at_edge = double(std::max(std::min(from_ >> 24, largest), 1u));
    solid_factor_ = blend_factor_ = least() / at_edge;
    largest_factor_ = std::max(kLargestFactor * least(), 255.0) / at_edge;
  }

  /// The contrast of the solid texels decides how many samples between texels are solid; that of the others decides the
  /// total that is hidden.
  void approach(const AlphaCoverage& wanted) {
    for (int round = 0; round < kSearchRounds; ++round) {
      search(solid_factor_, wanted.seen_opaque, &AlphaCoverage::seen_opaque);
      search(blend_factor_, wanted.opacity, &AlphaCoverage::opacity);
    }
    apply();
    for (std::uint32_t y = 0; y < mip_.height; ++y) {
      std::uint8_t* const texels = &mip_.texels[4 * std::size_t(y) * mip_.width];
      for (std::uint32_t x = 0; x < mip_.width; ++x) texels[4 * std::size_t(x) + 3] = std::uint8_t(alpha_.row(y)[x]);
    }
  }

 private:
  [[nodiscard]] int least() const { return std::min(least_passing(thresholds_.opaque), 255); }

  void search(double& factor, double wanted, double AlphaCoverage::*figure) {
    double low = 0, high = largest_factor_;
    for (int step = 0; step <= kSearchSteps; ++step) {
      apply();
      const double found = alpha_coverage(alpha_, used_, thresholds_).*figure;
      if (std::abs(found - wanted) < kCloseEnough * wanted) return;
      (found < wanted ? low : high) = factor;
      factor = 0.5 * (low + high);
    }
  }

  void apply() {
    std::array<std::array<std::int16_t, 256>, 2> alpha_of{};
    for (std::size_t alpha = 0; alpha < 256; ++alpha) {
      const auto scaled = [&](double factor) { return std::floor(double(alpha) * factor + 0.5); };
      alpha_of[0][alpha] = std::int16_t(std::min<double>(scaled(blend_factor_), least() - 1));
      alpha_of[1][alpha] = std::int16_t(std::clamp<double>(scaled(solid_factor_), least(), 255));
    }
    for (std::uint32_t y = 0; y < alpha_.height; ++y) {
      const std::uint32_t* const rank = &rank_[std::size_t(y) * alpha_.width];
      std::int16_t* const alpha = alpha_.row(y);
      for (std::uint32_t x = 0; x < alpha_.width; ++x) alpha[x] = alpha_of[rank[x] >= from_ ? 1 : 0][rank[x] >> 24];
    }
    alpha_.close_rows();
  }

  Image& mip_;
  AlphaPlane alpha_;  ///< The mip's alpha with the present factors.
  AlphaPlane used_;
  AlphaThresholds thresholds_;
  std::vector<std::uint32_t> rank_;
  std::uint32_t from_;
  double solid_factor_ = 1, blend_factor_ = 1, largest_factor_ = 1;
};

}  // namespace

void keep_alpha_coverage(std::span<Image> mips, std::span<const Image> used, const AlphaThresholds& thresholds) {
  if (least_passing(thresholds.opaque) == 0) return;
  const AlphaCoverage wanted = alpha_coverage(mips[0], used[0], thresholds);
  if (wanted.opacity <= 0) return;
  for (std::size_t level = 1; level < mips.size(); ++level) {
    MipAlpha(mips[level], used[level], thresholds, wanted.opaque).approach(wanted);
  }
}

namespace {

const TextureRecord* find_base_color(const AssetContents& contents) {
  const auto found = std::ranges::find(contents.textures, TextureRole::kBaseColor, &TextureRecord::role);
  return found == contents.textures.end() ? nullptr : &*found;
}

/// With fewer texels a single one is too large a step.
constexpr double kJudgedTexels = 64;
constexpr double kMostOff = 0.05;  ///< Share of the largest mip's coverage.

double used_count(const Image& used) {
  return double(std::accumulate(used.texels.begin(), used.texels.end(), std::uint64_t{0})) / 255;
}

/// The relative error of a mip; 0 for errors below half a texel.
double share_off(double found, double wanted, double texels) {
  const double off = std::abs(found - wanted);
  return off <= 0.5 / texels ? 0 : off / std::max(wanted, 1 / texels);
}

/// For the base texture's texels; none where the hair is opaque whatever their alpha.
std::optional<AlphaThresholds> thresholds_in_use(const AssetContents& contents, const MaterialRecord& material) {
  if (find_base_color(contents) == nullptr) return {};
  const AlphaThresholds thresholds = thresholds_in_texture(material);
  return least_passing(thresholds.opaque) == 0 ? std::nullopt : std::optional(thresholds);
}

}  // namespace

std::vector<Image> base_color_mips(const AssetContents& contents) {
  const TextureRecord* record = find_base_color(contents);
  if (record == nullptr) return {};
  std::vector<Image> mips;
  const std::byte* from = contents.texels.data() + record->offset;
  for (std::uint32_t level = 0; level < record->mip_count; ++level) {
    Image mip{std::max(1u, record->width >> level), std::max(1u, record->height >> level), 4, {}};
    mip.texels.resize(mip.texel_count() * 4);
    std::memcpy(mip.texels.data(), from, mip.texels.size());
    from += mip.texels.size();
    mips.push_back(std::move(mip));
  }
  return mips;
}

std::vector<Image> mips_for_threshold(std::span<const Image> used, const AssetContents& contents,
                                      float opaque_threshold) {
  std::vector<Image> mips = base_color_mips(contents);
  if (contents.material.empty()) return mips;
  MaterialRecord material = contents.material[0];
  material.opaque_threshold = opaque_threshold;
  if (const auto thresholds = thresholds_in_use(contents, material)) keep_alpha_coverage(mips, used, *thresholds);
  return mips;
}

void keep_coverage(std::span<const Image> used, AssetContents& contents) {
  const TextureRecord* const record = find_base_color(contents);
  if (record == nullptr || contents.material.empty()) return;
  std::byte* to = contents.texels.data() + record->offset;
  for (const Image& mip : mips_for_threshold(used, contents, contents.material[0].opaque_threshold)) {
    std::memcpy(to, mip.texels.data(), mip.texels.size());
    to += mip.texels.size();
  }
}

void report_coverage(std::span<const Image> used, const AssetContents& contents, Findings& findings) {
  if (contents.material.empty()) return;
  const auto thresholds = thresholds_in_use(contents, contents.material[0]);
  if (!thresholds) return;
  const std::vector<Image> mips = base_color_mips(contents);
  const AlphaCoverage wanted = alpha_coverage(mips[0], used[0], *thresholds);
  double solid_off = 0, opacity_off = 0;
  bool warned = false;
  std::size_t level = 1;
  for (; level < mips.size() && used_count(used[level]) >= kJudgedTexels; ++level) {
    const double texels = used_count(used[level]);
    const AlphaCoverage found = alpha_coverage(mips[level], used[level], *thresholds);
    solid_off = std::max(solid_off, share_off(found.opaque, wanted.opaque, texels));
    opacity_off = std::max(opacity_off, share_off(found.opacity, wanted.opacity, texels));
    if (warned || std::max(solid_off, opacity_off) <= kMostOff) continue;
    warned = true;
    findings.warn(
        "C141",
        fmt::format("mip {} of the base texture ({} x {}) covers {:.1f} % instead of {:.1f} %: hair looks {} from "
                    "afar; paint its "
                    "alpha with fewer faint texels",
                    level, mips[level].width, mips[level].height, 100 * found.opacity, 100 * wanted.opacity,
                    found.opacity < wanted.opacity ? "thinner" : "fuller"));
  }
  findings.note(fmt::format(
      "mips: {:.1f} % of the hair's texels opaque, {:.1f} % covered in all; smaller mips are within {:.1f} % and "
      "{:.1f} % of that, down to mip {}",
      100 * wanted.opaque, 100 * wanted.opacity, 100 * solid_off, 100 * opacity_off, level - 1));
}

}  // namespace coif::cook
