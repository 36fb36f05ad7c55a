#include "report/order/exactness.h"

#include "render/order_pictures.h"
#include "report/order/order_poses.h"
#include "report/order/order_ways.h"
#include "report/order/picture_error.h"

#include <algorithm>
#include <utility>

namespace coif {
namespace {

constexpr std::uint32_t kViews = 6;
constexpr RendererDesc kTooFewForLists{.list_bytes = 64u << 10};

using Pictures = std::vector<Picture>;

tl::expected<Pictures, ToolError> take_from_all_sides(OrderPictures& pictures, HairShot shot) {
  const MaterialRecord material = with_true_alphas(pictures.material(shot.model));
  shot.material = &material;
  Pictures taken;
  for (const ViewAngle& view : spread_directions(kViews)) {
    shot.yaw_degrees = view.yaw_degrees;
    shot.pitch_degrees = view.pitch_degrees;
    auto picture = pictures.take(shot);
    if (!picture) return tl::unexpected(picture.error());
    taken.push_back(std::move(*picture));
  }
  return taken;
}

/// As often as `times`, one series after the other.
tl::expected<std::vector<Pictures>, ToolError> take_series(const Asset& asset, const RendererDesc& desc, HairShot shot,
                                                           int times) {
  const auto pictures = OrderPictures::create(asset, desc);
  if (!pictures) return tl::unexpected(pictures.error());
  const auto model = (*pictures)->add(asset);
  if (!model) return tl::unexpected(model.error());
  shot.model = *model;
  std::vector<Pictures> series;
  for (int i = 0; i < times; ++i) {
    auto taken = take_from_all_sides(**pictures, shot);
    if (!taken) return tl::unexpected(taken.error());
    series.push_back(std::move(*taken));
  }
  return series;
}

SelfDifferenceRow difference(const char* against, const Pictures& a, const Pictures& b) {
  SelfDifferenceRow row{against, kEqualDb, 0};
  PictureError error;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error += picture_error(a[i].rgba, b[i].rgba);
    row.max_difference = std::max(row.max_difference, largest_difference(a[i].rgba, b[i].rgba));
  }
  row.psnr_db = error.psnr_db();
  return row;
}

}  // namespace

tl::expected<std::vector<SelfDifferenceRow>, ToolError> measure_exactness(const Asset& asset, const PosedHair& hair,
                                                                          std::uint32_t width, std::uint32_t height) {
  HairShot shot{.transparency = &kExactMode, .palette = hair.palette, .width = width, .height = height};
  const auto listed = take_series(asset, {.list_bytes = kListBytes}, shot, 2);
  if (!listed) return tl::unexpected(listed.error());
  const auto peeled = take_series(asset, kTooFewForLists, shot, 1);
  if (!peeled) return tl::unexpected(peeled.error());
  return std::vector{difference("again", listed->at(0), listed->at(1)),
                     difference("layer by layer", listed->at(0), peeled->at(0))};
}

}  // namespace coif
