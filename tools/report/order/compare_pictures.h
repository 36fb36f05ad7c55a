#pragma once

#include "render/order_pictures.h"
#include "report/order/drawn_way.h"
#include "report/order/picture_error.h"
#include "report/order_report.h"
#include "tool_error.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// How one way compares with the exact pictures of a pose.
struct WayComparison {
  OrderError error;
  WorstPicture worst;  ///< Named for the way and the pose.
};

/// Takes pictures of several ways and of the exact one, view by view, so that none has to be kept.
class PictureComparer {
 public:
  /// `finest`: what ways that sort triangles are made from. All must outlive this object.
  PictureComparer(OrderPictures& pictures, const AssetContents& finest, const DrawnWay& exact, std::uint32_t width,
                  std::uint32_t height)
      : pictures_(pictures), finest_(finest), exact_(exact), width_(width), height_(height) {}

  /// One per way. `progress` hears of each view before. Errors: those of OrderPictures.
  tl::expected<std::vector<WayComparison>, ToolError> over_views(std::span<const DrawnWay> ways, const OrderPose& pose,
                                                                 std::span<const ViewAngle> views,
                                                                 const std::function<void(std::size_t view)>& progress);

  /// One per way: RMS of what a pixel changes in excess of the exact one, over `frames` frames by a degree each around the
  /// pose's first moment, half as wide and high.
  tl::expected<std::vector<double>, ToolError> on_orbit(std::span<const DrawnWay> ways, const OrderPose& pose,
                                                        std::uint32_t frames,
                                                        const std::function<void(std::uint32_t frame)>& progress);

  /// `divisor`: of width and height.
  tl::expected<Picture, ToolError> take(const DrawnWay& way, const PosedHair& hair, const ViewAngle& view,
                                        std::uint32_t divisor = 1);

  [[nodiscard]] HairShot shot(const DrawnWay& way, const PosedHair& hair, const ViewAngle& view) const;

 private:
  OrderPictures& pictures_;
  const AssetContents& finest_;
  const DrawnWay& exact_;
  std::uint32_t width_, height_;
};

}  // namespace coif
