#include "base/timing.h"
#include "render/order_pictures.h"
#include "report/order/drawn_way.h"
#include "report/order/measure_order.h"

#include <coif/lod.h>
#include <coif/research.h>
#include <coif/view_cells.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kLargest = 512, kSmallest = 16;
constexpr double kYaws[] = {0, 60, 120, 180, 240, 300};
constexpr double kPitch = 5;

/// Mean over the views.
tl::expected<double, ToolError> coverage(render::OrderPictures& pictures, render::HairShot shot) {
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

tl::expected<std::vector<DistanceRow>, ToolError> measure_distances(const Asset& asset, render::OrderPictures& pictures,
                                                                    std::size_t model, const DrawnWay& exact,
                                                                    const PosedHair& hair) {
  render::HairShot shot{
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
    // A full-screen game's picture is about a thousand pixels high; the share of that decides the level.
    constexpr float kScreen = 1080;
    shot.lod = row.lod = choose_lod(asset.stored_lods(), float(pixels) / kScreen, 0, 0);
    const auto chosen = coverage(pictures, shot);
    if (!chosen) return tl::unexpected(chosen.error());
    row.coverage_pct = *whole > 0 ? 100 * *finest / *whole : 0;
    row.lod_coverage_pct = *whole > 0 ? 100 * *chosen / *whole : 0;
    rows.push_back(row);
  }
  return rows;
}

namespace {

constexpr std::uint32_t kViews = 6;
constexpr RendererDesc kTooFewForLists{.list_bytes = 64u << 10};

using Pictures = std::vector<render::Picture>;

tl::expected<Pictures, ToolError> take_from_all_sides(render::OrderPictures& pictures, render::HairShot shot) {
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

/// Takes each series `times` times, one after the other.
tl::expected<std::vector<Pictures>, ToolError> take_series(const Asset& asset, const RendererDesc& desc,
                                                           render::HairShot shot, int times) {
  const auto pictures = render::OrderPictures::create(asset, desc);
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
  render::HairShot shot{.transparency = &kExactMode, .palette = hair.palette, .width = width, .height = height};
  const auto listed = take_series(asset, {.list_bytes = kListBytes}, shot, 2);
  if (!listed) return tl::unexpected(listed.error());
  const auto peeled = take_series(asset, kTooFewForLists, shot, 1);
  if (!peeled) return tl::unexpected(peeled.error());
  return std::vector{difference("again", listed->at(0), listed->at(1)),
                     difference("layer by layer", listed->at(0), peeled->at(0))};
}

namespace {

constexpr ViewAngle kView{30, 5};

constexpr std::uint32_t kSides = 16;

/// Eyes in head space, from all sides in turns.
class Sides {
 public:
  Sides(const render::OrderPictures& pictures, render::HairShot shot) {
    for (const ViewAngle& view : spread_directions(kSides)) {
      shot.yaw_degrees = view.yaw_degrees;
      shot.pitch_degrees = view.pitch_degrees;
      eyes_.emplace_back(pictures.eye(shot).cast<float>());
    }
  }
  const Eigen::Vector3f& next() { return eyes_[at_++ % kSides]; }

 private:
  std::vector<Eigen::Vector3f> eyes_;
  std::size_t at_ = 0;
};

/// The work of `way` for a head before it is drawn; empty: none.
std::function<void()> sorting_of(const DrawnWay& way, const OrderWays& ways, const PosedHair& hair,
                                 const std::shared_ptr<Sides>& sides) {
  if (way.bones != nullptr) {
    const auto room = std::make_shared<std::vector<std::byte>>(sizeof(std::uint32_t) * ways.finest.indices.size());
    return [&way, &hair, sides, room] {
      const Eigen::Vector3f& eye = sides->next();
      way.bones->order().write({.head = {}, .palette = hair.palette}, {eye.x(), eye.y(), eye.z()}, room->data());
    };
  }
  if (!way.sorted_units.empty()) {
    return [&way, &ways, &hair, sides] {
      (void)far_to_near(ways.finest.indices, way.sorted_units, hair.positions, sides->next());
    };
  }
  if (way.model != ways.own.model || ways.finest.orders.empty()) return {};
  const auto chosen = std::make_shared<volatile std::uint32_t>(0);
  return [&ways, sides, chosen] {
    const Eigen::Vector3f& eye = sides->next();
    *chosen = ways.finest.order_views[view_cell({eye.x(), eye.y(), eye.z()})];
  };
}

}  // namespace

std::vector<std::optional<double>> measure_sorting(const render::OrderPictures& pictures,
                                                   const PictureComparer& comparer, const OrderWays& ways,
                                                   const PosedHair& hair, double seconds) {
  const auto sides = std::make_shared<Sides>(pictures, comparer.shot(ways.own, hair, kView));
  std::vector<std::optional<double>> nanoseconds(ways.orders.size());
  std::vector<std::size_t> of_work;
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < ways.orders.size(); ++i) {
    auto sorting = sorting_of(ways.orders[i], ways, hair, sides);
    if (!sorting) continue;
    works.push_back(std::move(sorting));
    of_work.push_back(i);
  }
  const std::vector<Timing> timed = SideBySideTiming({.clock = TimingClock::kThread, .seconds = seconds}).run(works);
  for (std::size_t i = 0; i < timed.size(); ++i) nanoseconds[of_work[i]] = 1e9 * timed[i].seconds;
  return nanoseconds;
}

std::vector<double> measure_order_times(render::OrderPictures& pictures, const PictureComparer& comparer,
                                        std::span<const DrawnWay> ways, const PosedHair& hair,
                                        std::span<const std::uint32_t> indices, double seconds) {
  std::vector<std::function<void()>> works;
  for (const DrawnWay& way : ways) {
    const render::HairShot shot = comparer.shot(way, hair, kView);
    const Eigen::Vector3f eye = pictures.eye(shot).cast<float>();
    works.emplace_back([&pictures, &hair, indices, shot, eye, &way] {
      if (!way.sorted_units.empty()) (void)far_to_near(indices, way.sorted_units, hair.positions, eye);
      (void)pictures.draw(shot);
    });
  }
  const SideBySideTiming timing({.clock = TimingClock::kWall, .seconds = seconds, .batch_seconds = 0});
  std::vector<double> milliseconds;
  for (const Timing& measured : timing.run(works)) milliseconds.push_back(1e3 * measured.seconds);
  return milliseconds;
}

}  // namespace coif::report
