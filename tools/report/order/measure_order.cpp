#include "report/order/measure_order.h"

#include "motion/hair_pose.h"
#include "motion/head_path.h"
#include "motion/motion.h"
#include "report/order/compare_pictures.h"
#include "report/order/distance_series.h"
#include "report/order/drawn_orders.h"
#include "report/order/order_ways.h"
#include "timing.h"
#include "visibility/hair_surface.h"

#include <coif/view_cells.h>

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace coif {
namespace {

constexpr std::uint32_t kMostPixels = 1024, kLeastPixels = 16, kMostFrames = 360;
constexpr double kThresholds[] = {0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95};
constexpr std::uint32_t kReferenceViews = 6;
constexpr double kTimedYaw = 30, kTimedPitch = 5;
constexpr double kTimingSeconds = 3;

/// Moments in which hair is on its way: head at its fastest, hair at its furthest, on its way back.
struct MovingPose {
  Motion motion;
  const char* name;
  double seconds[3];
};
constexpr MovingPose kMovingPoses[] = {{Motion::kTurn, "turn", {0.2, 0.45, 0.7}},
                                       {Motion::kCharge, "charge", {0.15, 0.35, 0.8}}};

tl::expected<void, ToolError> check(const OrderSettings& settings) {
  const auto side_ok = [](std::uint32_t side) { return side >= kLeastPixels && side <= kMostPixels; };
  const bool views_ok = settings.views >= 1 && settings.views <= kViewCells;
  const bool orbit_ok = settings.orbit_frames != 1 && settings.orbit_frames <= kMostFrames;
  if (side_ok(settings.width) && side_ok(settings.height) && views_ok && orbit_ok) return {};
  return tl::unexpected(ToolError{ToolError::Kind::kUsage,
                                  "pictures that are compared have 16 to 1024 pixels each way, are taken from 1 to 96 "
                                  "views, and an orbit has 0 or 2 to 360 frames"});
}

std::vector<ViewAngle> directions(std::uint32_t views) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::vector<ViewAngle> angles;
  for (std::uint32_t view = 0; view < views; ++view) {
    float d[3];
    view_cell_direction(view * kViewCells / views, d);
    angles.push_back({kDegrees * std::atan2(d[0], d[2]), kDegrees * std::asin(d[1])});
  }
  return angles;
}

tl::expected<PosedHair, ToolError> posed(const Asset& asset, const HeadPath* path, double seconds) {
  auto pose = simulate_pose(asset, path, seconds, {});
  if (!pose) return tl::unexpected(pose.error());
  std::vector<Eigen::Vector3f> positions = posed_positions(asset, pose->palette);
  return PosedHair{std::move(pose->palette), std::move(positions)};
}

tl::expected<std::vector<OrderPose>, ToolError> make_poses(const Asset& asset) {
  auto rest = posed(asset, nullptr, 0);
  if (!rest) return tl::unexpected(rest.error());
  std::vector<OrderPose> poses = {{"rest", {std::move(*rest)}}};
  if (asset.dynamics().empty()) return poses;
  for (const MovingPose& moving : kMovingPoses) {
    poses.push_back({moving.name, {}});
    for (const double seconds : moving.seconds) {
      auto moment = posed(asset, path_of(moving.motion).get(), seconds);
      if (!moment) return tl::unexpected(moment.error());
      poses.back().moments.push_back(std::move(*moment));
    }
  }
  return poses;
}

class OrderMeasurement {
 public:
  OrderMeasurement(const Asset& asset, const OrderSettings& settings, const ReportProgress& progress,
                   OrderPictures& pictures, OrderWays ways, std::vector<OrderPose> poses)
      : asset_(asset),
        settings_(settings),
        progress_(progress),
        pictures_(pictures),
        ways_(std::move(ways)),
        poses_(std::move(poses)),
        comparer_(pictures_, ways_.finest, ways_.exact, settings.width, settings.height) {
    report_.device = pictures.device();
    report_.width = settings.width;
    report_.height = settings.height;
    report_.opaque_threshold = pictures.material(ways_.own.model).opaque_threshold;
    report_.orders = asset.order_count();
    report_.directions = directions(settings.views);
    report_.orbit_frames = settings.orbit_frames;
    report_.left_out = ways_.left_out;
  }
  OrderMeasurement(const OrderMeasurement&) = delete;
  OrderMeasurement& operator=(const OrderMeasurement&) = delete;

  tl::expected<OrderReport, ToolError> run() {
    if (auto done = add_reference(); !done) return tl::unexpected(done.error());
    for (const OrderPose& pose : poses_) {
      if (auto done = add_pose(pose); !done) return tl::unexpected(done.error());
    }
    if (settings_.modes) {
      if (auto done = add_thresholds(); !done) return tl::unexpected(done.error());
      if (auto done = add_distances(); !done) return tl::unexpected(done.error());
    }
    add_times();
    return std::move(report_);
  }

 private:
  void say(const std::string& step) const {
    if (progress_) progress_(step);
  }

  tl::expected<void, ToolError> add_reference() {
    say("exact pictures");
    SelfDifferenceRow again{.against = "again"};
    PictureError error;
    for (std::uint32_t i = 0; i < kReferenceViews; ++i) {
      const ViewAngle& view = report_.directions[i * report_.directions.size() / kReferenceViews];
      const auto first = comparer_.take(ways_.exact, poses_[0].moments[0], view);
      if (!first) return tl::unexpected(first.error());
      const auto second = comparer_.take(ways_.exact, poses_[0].moments[0], view);
      if (!second) return tl::unexpected(second.error());
      error += picture_error(first->rgba, second->rgba);
      again.max_difference = std::max(again.max_difference, largest_difference(first->rgba, second->rgba));
    }
    again.psnr_db = error.psnr_db();
    report_.reference.push_back(again);
    return {};
  }

  /// All orders and modes beside each other, so that exact pictures are taken once.
  tl::expected<void, ToolError> add_pose(const OrderPose& pose) {
    std::vector<DrawnWay> ways = ways_.orders;
    if (settings_.modes) ways.insert(ways.end(), ways_.modes.begin(), ways_.modes.end());
    auto compared = comparer_.over_views(ways, pose, report_.directions, [&](std::size_t view) {
      say(fmt::format("{}: view {} of {}", pose.name, view + 1, report_.directions.size()));
    });
    if (!compared) return tl::unexpected(compared.error());
    std::vector<double> popping;
    if (settings_.orbit_frames > 0) {
      auto orbit = comparer_.on_orbit(ways, pose, settings_.orbit_frames, [&](std::uint32_t frame) {
        say(fmt::format("{}: frame {} of {}", pose.name, frame + 1, settings_.orbit_frames));
      });
      if (!orbit) return tl::unexpected(orbit.error());
      popping = std::move(*orbit);
    }
    for (std::size_t i = 0; i < ways.size(); ++i) {
      add_row(ways[i], i < ways_.orders.size(), pose.name, std::move((*compared)[i]),
              popping.empty() ? std::optional<double>() : popping[i]);
    }
    add_gain(pose.name);
    return {};
  }

  void add_row(const DrawnWay& way, bool is_order, const std::string& pose, WayComparison compared,
               std::optional<double> popping) {
    report_.worst.push_back(std::move(compared.worst));
    if (is_order) {
      report_.rows.push_back({way.name, pose, way.faces_together, std::move(compared.error), popping, 0, way.bytes});
    } else {
      report_.modes.push_back({way.name, way.samples, pose, std::move(compared.error), popping, 0});
    }
  }

  void add_gain(const std::string& pose) {
    const auto of = [&](const std::string& order) {
      const auto row =
          std::ranges::find_if(report_.rows, [&](const OrderRow& r) { return r.pose == pose && r.order == order; });
      return row->error.psnr_db;
    };
    report_.gains.push_back({pose, of(ways_.own.name) - of("head")});
  }

  tl::expected<void, ToolError> add_thresholds() {
    std::vector<MaterialRecord> materials;
    std::vector<DrawnWay> ways;
    const MaterialRecord own = pictures_.material(ways_.own.model);
    const auto add = [&](float threshold) {
      materials.push_back(own);
      materials.back().opaque_threshold = threshold;
      ways.push_back(ways_.own);
    };
    for (const double threshold : kThresholds) add(float(threshold));
    if (std::ranges::none_of(materials, [&](const auto& m) { return m.opaque_threshold == own.opaque_threshold; })) {
      add(own.opaque_threshold);
    }
    std::ranges::sort(materials, {}, &MaterialRecord::opaque_threshold);
    for (std::size_t i = 0; i < ways.size(); ++i) ways[i].material = &materials[i];
    const auto compared = comparer_.over_views(ways, poses_[0], report_.directions, [&](std::size_t view) {
      say(fmt::format("opaque thresholds: view {} of {}", view + 1, report_.directions.size()));
    });
    if (!compared) return tl::unexpected(compared.error());
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const float threshold = materials[i].opaque_threshold;
      report_.thresholds.push_back({threshold, threshold == own.opaque_threshold, (*compared)[i].error});
    }
    return {};
  }

  tl::expected<void, ToolError> add_distances() {
    say("distances");
    const auto model = pictures_.add(asset_);
    if (!model) return tl::unexpected(model.error());
    auto rows = measure_distances(asset_, pictures_, *model, ways_.exact, poses_[0].moments[0]);
    if (!rows) return tl::unexpected(rows.error());
    report_.distance = std::move(*rows);
    return {};
  }

  void add_times() {
    say("times");
    std::vector<DrawnWay> ways = ways_.orders;
    if (settings_.modes) ways.insert(ways.end(), ways_.modes.begin(), ways_.modes.end());
    const PosedHair& hair = poses_[0].moments[0];
    std::vector<std::function<void()>> works;
    for (const DrawnWay& way : ways) {
      const HairShot shot = comparer_.shot(way, hair, {kTimedYaw, kTimedPitch});
      const Eigen::Vector3f eye = pictures_.eye(shot).cast<float>();
      works.emplace_back([this, &hair, shot, eye, sorts = way.sorts_triangles] {
        if (sorts) (void)far_to_near(ways_.finest.indices, hair.positions, eye);
        (void)pictures_.draw(shot);
      });
    }
    const auto timings =
        SideBySideTiming({.clock = TimingClock::kWall, .seconds = kTimingSeconds, .batch_seconds = 0}).run(works);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const double ms = 1e3 * timings[i].seconds;
      for (OrderRow& row : report_.rows) {
        if (i < ways_.orders.size() && row.order == ways[i].name) row.ms_per_frame = ms;
      }
      for (OrderModeRow& row : report_.modes) {
        if (i >= ways_.orders.size() && row.transparency == ways[i].name) row.ms_per_frame = ms;
      }
    }
  }

  const Asset& asset_;
  const OrderSettings& settings_;
  const ReportProgress& progress_;
  OrderPictures& pictures_;
  const OrderWays ways_;
  const std::vector<OrderPose> poses_;
  PictureComparer comparer_;
  OrderReport report_;
};

}  // namespace

tl::expected<OrderReport, ToolError> measure_order(const Asset& asset, const OrderSettings& settings,
                                                   const ReportProgress& progress) {
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  auto pictures = OrderPictures::create(asset);
  if (!pictures) return tl::unexpected(pictures.error());
  auto ways = make_order_ways(asset, **pictures);
  if (!ways) return tl::unexpected(ways.error());
  auto poses = make_poses(asset);
  if (!poses) return tl::unexpected(poses.error());
  return OrderMeasurement(asset, settings, progress, **pictures, std::move(*ways), std::move(*poses)).run();
}

}  // namespace coif
