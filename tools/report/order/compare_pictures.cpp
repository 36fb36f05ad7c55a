#include "report/order/compare_pictures.h"

#include "report/opened_asset.h"
#include "report/order/drawn_orders.h"

#include <limits>
#include <utility>

namespace coif {
namespace {

constexpr double kOrbitPitch = 5;
constexpr std::uint32_t kOrbitDivisor = 2;  // a quarter of the pixels shows as well what pops

/// A way's pictures so far, and the worst of them.
struct Running {
  std::vector<PictureError> errors;
  double worst_db = std::numeric_limits<double>::infinity();
  ViewAngle worst_view;
  Picture worst, worst_exact;

  void add(const PictureError& error, const ViewAngle& view, const Picture& exact, Picture& picture) {
    errors.push_back(error);
    if (error.psnr_db() >= worst_db) return;
    worst_db = error.psnr_db();
    worst_view = view;
    worst = std::move(picture);
    worst_exact = exact;
  }

  [[nodiscard]] WayComparison comparison(const std::string& way, const std::string& pose) const {
    WayComparison result{sum_up(errors), {way, pose, worst_view.yaw_degrees, worst_view.pitch_degrees, worst_db, {}}};
    const Picture joined{3 * worst.width, worst.height, side_by_side(worst_exact.rgba, worst.rgba, worst.width), "", 0};
    result.worst.png = encode_png(joined);
    return result;
  }
};

}  // namespace

HairShot PictureComparer::shot(const DrawnWay& way, const PosedHair& hair, const ViewAngle& view) const {
  return {.model = way.model,
          .transparency = way.transparency,
          .material = way.material,
          .palette = hair.palette,
          .yaw_degrees = view.yaw_degrees,
          .pitch_degrees = view.pitch_degrees,
          .width = width_,
          .height = height_,
          .samples = way.samples};
}

tl::expected<Picture, ToolError> PictureComparer::take(const DrawnWay& way, const PosedHair& hair,
                                                       const ViewAngle& view, std::uint32_t divisor) {
  HairShot taken = shot(way, hair, view);
  taken.width /= divisor;
  taken.height /= divisor;
  if (!way.sorted_units.empty()) {
    const Eigen::Vector3f eye = pictures_.eye(taken).cast<float>();
    AssetContents contents = sorted_by_unit(finest_, way.sorted_units, hair.positions, eye);
    set_faces(contents, way.faces_together);
    const OpenedAsset sorted(contents);
    if (auto replaced = pictures_.replace(way.model, sorted.asset()); !replaced) {
      return tl::unexpected(replaced.error());
    }
  }
  return pictures_.take(taken);
}

tl::expected<std::vector<WayComparison>, ToolError> PictureComparer::over_views(
    std::span<const DrawnWay> ways, const OrderPose& pose, std::span<const ViewAngle> views,
    const std::function<void(std::size_t view)>& progress) {
  std::vector<Running> running(ways.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    progress(v);
    const PosedHair& hair = pose.moments[v % pose.moments.size()];
    const auto exact = take(exact_, hair, views[v]);
    if (!exact) return tl::unexpected(exact.error());
    for (std::size_t w = 0; w < ways.size(); ++w) {
      auto picture = take(ways[w], hair, views[v]);
      if (!picture) return tl::unexpected(picture.error());
      running[w].add(picture_error(exact->rgba, picture->rgba), views[v], *exact, *picture);
    }
  }
  std::vector<WayComparison> comparisons;
  for (std::size_t w = 0; w < ways.size(); ++w) {
    comparisons.push_back(running[w].comparison(ways[w].name, pose.name));
  }
  return comparisons;
}

tl::expected<std::vector<double>, ToolError> PictureComparer::on_orbit(
    std::span<const DrawnWay> ways, const OrderPose& pose, std::uint32_t frames,
    const std::function<void(std::uint32_t frame)>& progress) {
  std::vector<PictureError> changes(ways.size());
  std::vector<Picture> before(ways.size());
  Picture exact_before;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    progress(frame);
    const ViewAngle view{double(frame), kOrbitPitch};
    auto exact = take(exact_, pose.moments.front(), view, kOrbitDivisor);
    if (!exact) return tl::unexpected(exact.error());
    for (std::size_t w = 0; w < ways.size(); ++w) {
      auto picture = take(ways[w], pose.moments.front(), view, kOrbitDivisor);
      if (!picture) return tl::unexpected(picture.error());
      if (frame > 0) changes[w] += excess_change(exact_before.rgba, exact->rgba, before[w].rgba, picture->rgba);
      before[w] = std::move(*picture);
    }
    exact_before = std::move(*exact);
  }
  std::vector<double> popping;
  for (const PictureError& change : changes) popping.push_back(change.rmse());
  return popping;
}

}  // namespace coif
