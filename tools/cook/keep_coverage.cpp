#include "cook/keep_coverage.h"

#include "cook/alpha_mips.h"
#include "cook/mip_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace coif {
namespace {

const TextureRecord* find_base_color(const AssetContents& contents) {
  const auto found = std::ranges::find(contents.textures, TextureRole::kBaseColor, &TextureRecord::role);
  return found == contents.textures.end() ? nullptr : &*found;
}

/// With fewer texels one more or less is too much of a step to ask for.
constexpr double kJudgedTexels = 64;
constexpr double kMostOff = 0.05;  ///< Of what the largest mip covers.

double used_count(const Image& used) {
  return double(std::accumulate(used.texels.begin(), used.texels.end(), std::uint64_t{0})) / 255;
}

/// How far a mip is off: of the wanted figure, but nothing for what half a texel changes.
double share_off(double found, double wanted, double texels) {
  const double off = std::abs(found - wanted);
  return off <= 0.5 / texels ? 0 : off / std::max(wanted, 1 / texels);
}

KeptCoverage judged(std::span<const Image> mips, std::span<const Image> used, const AlphaThresholds& thresholds) {
  const AlphaCoverage wanted = alpha_coverage(mips[0], used[0], thresholds);
  KeptCoverage kept;
  double solid_off = 0, opacity_off = 0;
  std::size_t level = 1;
  for (; level < mips.size() && used_count(used[level]) >= kJudgedTexels; ++level) {
    const double texels = used_count(used[level]);
    const AlphaCoverage found = alpha_coverage(mips[level], used[level], thresholds);
    solid_off = std::max(solid_off, share_off(found.opaque, wanted.opaque, texels));
    opacity_off = std::max(opacity_off, share_off(found.opacity, wanted.opacity, texels));
    if (std::max(solid_off, opacity_off) > kMostOff && kept.warnings.empty()) {
      kept.warnings.push_back(
          fmt::format("mip {} of the base texture ({} x {}) covers {:.1f} % instead of {:.1f} %: hair looks {} from "
                      "afar; paint its "
                      "alpha with fewer faint texels",
                      level, mips[level].width, mips[level].height, 100 * found.opacity, 100 * wanted.opacity,
                      found.opacity < wanted.opacity ? "thinner" : "fuller"));
    }
  }
  kept.notes.push_back(fmt::format(
      "mips: {:.1f} % of the hair's texels opaque, {:.1f} % covered in all; smaller mips are within {:.1f} % and "
      "{:.1f} % of that, down to mip {}",
      100 * wanted.opaque, 100 * wanted.opacity, 100 * solid_off, 100 * opacity_off, level - 1));
  return kept;
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

KeptCoverage keep_coverage(std::span<const Image> used, AssetContents& contents) {
  std::vector<Image> mips = base_color_mips(contents);
  if (mips.empty() || contents.material.empty()) return {};
  const AlphaThresholds thresholds = thresholds_in_texture(contents.material[0]);
  if (least_passing(thresholds.opaque) == 0) return {};
  keep_alpha_coverage(mips, used, thresholds);
  std::byte* to = contents.texels.data() + find_base_color(contents)->offset;
  for (const Image& mip : mips) {
    std::memcpy(to, mip.texels.data(), mip.texels.size());
    to += mip.texels.size();
  }
  return judged(mips, used, thresholds);
}

}  // namespace coif
