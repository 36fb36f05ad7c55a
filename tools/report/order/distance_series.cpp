#include "report/order/distance_series.h"

#include "report/order/picture_error.h"

#include <coif/lod.h>

#include <algorithm>

namespace coif {
namespace {

constexpr std::uint32_t kLargest = 512, kSmallest = 16;
constexpr double kYaws[] = {0, 60, 120, 180, 240, 300};
constexpr double kPitch = 5;

/// Mean over the views.
tl::expected<double, ToolError> coverage(OrderPictures& pictures, HairShot shot) {
  double sum = 0;
  for (const double yaw : kYaws) {
    shot.yaw_degrees = yaw;
    shot.pitch_degrees = kPitch;
    const auto picture = pictures.take(shot);
    if (!picture) return tl::unexpected(picture.error());
    sum += mean_coverage(picture->rgba);
  }
  return sum / std::size(kYaws);
}

}  // namespace

tl::expected<std::vector<DistanceRow>, ToolError> measure_distances(const Asset& asset, OrderPictures& pictures,
                                                                    std::size_t model, const DrawnWay& exact,
                                                                    const PosedHair& hair) {
  HairShot shot{
      .model = exact.model, .transparency = exact.transparency, .material = exact.material, .palette = hair.palette};
  shot.width = shot.height = kLargest;
  const auto whole = coverage(pictures, shot);
  if (!whole) return tl::unexpected(whole.error());
  shot.model = model;
  shot.transparency = &kBlendMode;
  shot.material = nullptr;
  std::vector<DistanceRow> rows;
  for (std::uint32_t pixels = kLargest; pixels >= kSmallest; pixels /= 2) {
    DistanceRow row{.pixels = pixels};
    shot.width = shot.height = pixels;
    shot.lod = 0;
    const auto finest = coverage(pictures, shot);
    if (!finest) return tl::unexpected(finest.error());
    // A full-screen game's picture is some thousand pixels high: that share of it decides the level.
    constexpr float kScreen = 1080;
    shot.lod = row.lod = choose_lod(asset.lods(), float(pixels) / kScreen, 0, 0);
    const auto chosen = coverage(pictures, shot);
    if (!chosen) return tl::unexpected(chosen.error());
    row.coverage_pct = *whole > 0 ? 100 * *finest / *whole : 0;
    row.lod_coverage_pct = *whole > 0 ? 100 * *chosen / *whole : 0;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace coif
