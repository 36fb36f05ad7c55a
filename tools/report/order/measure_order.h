#pragma once

#include "base/tool_error.h"
#include "render/order_pictures.h"
#include "report/order/drawn_way.h"
#include "report/order/order_report.h"
#include "report/page/report_heading.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::report {

/// Sums of a picture's differences from the exact one, or of several pictures'.
struct PictureError {
  double squared = 0;      ///< Squared differences of values 0..1, mean over the three channels.
  std::size_t pixels = 0;  ///< Pixels that hair covers in the exact picture.
  std::size_t bad = 0;     ///< The part of `pixels` with a channel off by more than kBadDifference.

  PictureError& operator+=(const PictureError& other);
  [[nodiscard]] double rmse() const;
  [[nodiscard]] double psnr_db() const;  ///< At most kEqualDb.
};

/// Pixels are RGBA, sRGB, alpha the share that hair covers; both of one size.
[[nodiscard]] PictureError picture_error(std::span<const std::uint8_t> exact, std::span<const std::uint8_t> other);

/// Largest difference of any channel of any pixel, 0..1, alpha included.
[[nodiscard]] double largest_difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b);

/// The error over many views.
[[nodiscard]] OrderError sum_up(std::span<const PictureError> views);

/// The change from one frame to the next beyond the exact frames' change: per pixel that hair covers in either exact
/// frame, max(|change| - |exact change|, 0), squared, mean over the channels.
[[nodiscard]] PictureError excess_change(std::span<const std::uint8_t> exact_before,
                                         std::span<const std::uint8_t> exact_after,
                                         std::span<const std::uint8_t> before, std::span<const std::uint8_t> after);

/// Sum of alpha over the picture's area, 0..1.
[[nodiscard]] double mean_coverage(std::span<const std::uint8_t> pixels);

/// Exact, other and four times their difference side by side, opaque: RGBA, three times as wide.
[[nodiscard]] std::vector<std::uint8_t> side_by_side(std::span<const std::uint8_t> exact,
                                                     std::span<const std::uint8_t> other, std::uint32_t width);

/// Comparison of one way with the exact pictures of a pose.
struct WayComparison {
  OrderError error;
  WorstPicture worst;  ///< Named for the way and the pose.
};

/// Takes pictures of several ways and of the exact one, view by view, so that none has to be kept.
class PictureComparer {
 public:
  /// `finest`: source of ways that sort triangles. All arguments must outlive this object.
  PictureComparer(render::OrderPictures& pictures, const AssetContents& finest, const DrawnWay& exact,
                  std::uint32_t width, std::uint32_t height)
      : pictures_(pictures), finest_(finest), exact_(exact), width_(width), height_(height) {}

  /// One result per way. Calls `progress` before each view. Errors: those of OrderPictures.
  tl::expected<std::vector<WayComparison>, ToolError> over_views(std::span<const DrawnWay> ways, const OrderPose& pose,
                                                                 std::span<const ViewAngle> views,
                                                                 const std::function<void(std::size_t view)>& progress);

  /// One result per way: RMS of a pixel's change beyond the exact one's, over `frames` frames by a degree each around
  /// the pose's first moment, in half the width and height.
  tl::expected<std::vector<double>, ToolError> on_orbit(std::span<const DrawnWay> ways, const OrderPose& pose,
                                                        std::uint32_t frames,
                                                        const std::function<void(std::uint32_t frame)>& progress);

  /// `divisor`: divides width and height.
  tl::expected<render::Picture, ToolError> take(const DrawnWay& way, const PosedHair& hair, const ViewAngle& view,
                                                std::uint32_t divisor = 1);

  [[nodiscard]] render::HairShot shot(const DrawnWay& way, const PosedHair& hair, const ViewAngle& view) const;

 private:
  render::OrderPictures& pictures_;
  const AssetContents& finest_;
  const DrawnWay& exact_;
  std::uint32_t width_, height_;
};

/// Milliseconds per frame of each way, one head, all ways in turns for about `seconds`. Triangles of `indices` that are
/// sorted in every frame are not sent to the device.
[[nodiscard]] std::vector<double> measure_order_times(render::OrderPictures& pictures, const PictureComparer& comparer,
                                                      std::span<const DrawnWay> ways, const PosedHair& hair,
                                                      std::span<const std::uint32_t> indices, double seconds);

/// Nanoseconds of the processor that it takes to choose or to make one head's order, seen from one side after the
/// other, all ways in turns for about `seconds`; nothing for a way with one order for all sides.
[[nodiscard]] std::vector<std::optional<double>> measure_sorting(const render::OrderPictures& pictures,
                                                                 const PictureComparer& comparer, const OrderWays& ways,
                                                                 const PosedHair& hair, double seconds);

/// How much of the hair is left where `asset`, which `pictures` has as `model` with all its levels, is drawn as in a
/// game at 512, 256, ... 16 pixels, mean over some views around it. Errors: those of OrderPictures.
tl::expected<std::vector<DistanceRow>, ToolError> measure_distances(const Asset& asset, render::OrderPictures& pictures,
                                                                    std::size_t model, const DrawnWay& exact,
                                                                    const PosedHair& hair);

/// Differences between exact pictures over a few views: taken twice, and taken layer by layer instead of by lists of
/// texels. Makes and frees OpenGL contexts of its own: none may be current. Errors: those of OrderPictures.
tl::expected<std::vector<SelfDifferenceRow>, ToolError> measure_exactness(const Asset& asset, const PosedHair& hair,
                                                                          std::uint32_t width, std::uint32_t height);

inline constexpr std::uint32_t kMostOrderViews = 1000;

struct OrderSettings {
  std::uint32_t width = 160, height = 160;  ///< Pixels, 16..1024, one sample each except for modes that need more.
  std::uint32_t views = 64;                 ///< 1..kMostOrderViews, evenly spread over the sphere.
  std::uint32_t orbit_frames = 30;          ///< In steps of one degree, 0 (popping is not measured) or 2..360.
  double timing_seconds = 3;    ///< Time to spend on measuring frames, > 0; at least five of each are taken.
  std::string solver = "coif";  ///< The runtime's solver that moves the hair.
  bool modes = true;            ///< Also compares other ways to draw, thresholds and distances, at rest.
};

/// Draws the finest level in every order and pose and from every view with the runtime's renderer, and compares each
/// picture with the exact one. The camera is the studio's, with perspective as in a game, and the directions differ
/// from those of the cook's cells. Errors: kUsage for settings out of range, kBadInput for an asset without a mesh,
/// kUnsupported where nothing can be drawn.
tl::expected<OrderReport, ToolError> measure_order(const Asset& asset, const OrderSettings& settings,
                                                   const ReportProgress& progress);

}  // namespace coif::report
