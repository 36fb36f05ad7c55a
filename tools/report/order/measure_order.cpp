#include "report/order/measure_order.h"

#include "report/order/drawn_way.h"
#include "report/solvers/measured_solvers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kMostPixels = 1024, kLeastPixels = 16, kMostFrames = 360;
constexpr double kThresholds[] = {0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95};
constexpr double kSameThreshold = 0.005;  // an 8-bit alpha or so
constexpr double kSortingShare = 0.2;     // Share of the time for measuring times.
constexpr std::uint32_t kThresholdViews =
    3;  // Thresholds differ similarly from all sides: one view in so many suffices.

tl::expected<void, ToolError> check(const OrderSettings& settings) {
  const auto side_ok = [](std::uint32_t side) { return side >= kLeastPixels && side <= kMostPixels; };
  const bool views_ok = settings.views >= 1 && settings.views <= kMostOrderViews;
  const bool orbit_ok = settings.orbit_frames != 1 && settings.orbit_frames <= kMostFrames;
  if (settings.timing_seconds > 0 && side_ok(settings.width) && side_ok(settings.height) && views_ok && orbit_ok)
    return {};
  return tl::unexpected(
      ToolError{ToolError::Kind::kUsage,
                "pictures that are compared have 16 to 1024 pixels each way, are taken from 1 to 1000 "
                "views, an orbit has 0 or 2 to 360 frames, and taking times takes time"});
}

void take_times(OrderRow& row, double ms, std::optional<double> sorting_ns) {
  row.ms_per_frame = ms;
  row.sorting_ns = sorting_ns;
}

/// The runtime's solver of this name in reports; null: none.
const Solver* find_runtime_solver(const std::string& name) {
  const MeasuredSolver* const found = find_measured_solver(name);
  return found == nullptr ? nullptr : found->runtime;
}

tl::expected<const Solver*, ToolError> chosen_solver(const std::string& name) {
  if (const Solver* const solver = find_runtime_solver(name)) return solver;
  std::vector<std::string> known = report_solvers();
  std::erase_if(known, [](const std::string& other) { return find_runtime_solver(other) == nullptr; });
  return tl::unexpected(ToolError{
      ToolError::Kind::kUsage,
      fmt::format("'{}' is no solver that a game can run; orders are measured with {}", name, fmt::join(known, ", "))});
}

class OrderMeasurement {
 public:
  OrderMeasurement(const Asset& asset, const OrderSettings& settings, const ReportProgress& progress,
                   render::OrderPictures& pictures, OrderWays ways, std::vector<OrderPose> poses)
      : asset_(asset),
        settings_(settings),
        progress_(progress),
        pictures_(pictures),
        ways_(std::move(ways)),
        poses_(std::move(poses)),
        comparer_(pictures_, ways_.finest, ways_.exact, settings.width, settings.height) {
    report_.device = pictures.device();
    report_.solver = settings.solver;
    report_.width = settings.width;
    report_.height = settings.height;
    report_.opaque_threshold = pictures.material(ways_.own.model).opaque_threshold;
    report_.orders = asset.order_count();
    report_.directions = spread_directions(settings.views);
    report_.orbit_frames = settings.orbit_frames;
    report_.left_out = ways_.left_out;
  }
  OrderMeasurement(const OrderMeasurement&) = delete;
  OrderMeasurement& operator=(const OrderMeasurement&) = delete;

  tl::expected<OrderReport, ToolError> run() {
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
  [[nodiscard]] std::vector<DrawnWay> ways_of(bool with_modes) const {
    std::vector<DrawnWay> ways = ways_.orders;
    if (with_modes) ways.insert(ways.end(), ways_.modes.begin(), ways_.modes.end());
    return ways;
  }

  void say(const std::string& step) const {
    if (progress_) progress_(step);
  }

  /// Draws all orders and modes side by side, so that exact pictures are taken once.
  tl::expected<void, ToolError> add_pose(const OrderPose& pose) {
    const bool with_modes = settings_.modes && &pose == &poses_.front();
    const std::vector<DrawnWay> ways = ways_of(with_modes);
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
    // Blended with the asset's own orders is an order above: its worst picture is there already.
    const bool is_own = !is_order && way.transparency == ways_.own.transparency;
    if (!is_own) report_.worst.push_back(std::move(compared.worst));
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
    add(own.opaque_threshold);
    for (const double threshold : kThresholds) {
      if (std::abs(threshold - own.opaque_threshold) > kSameThreshold) add(float(threshold));
    }
    std::ranges::sort(materials, {}, &MaterialRecord::opaque_threshold);
    for (std::size_t i = 0; i < ways.size(); ++i) ways[i].material = &materials[i];
    const std::vector<ViewAngle> views = spread_directions((settings_.views + kThresholdViews - 1) / kThresholdViews);
    const auto compared = comparer_.over_views(ways, poses_[0], views, [&](std::size_t view) {
      say(fmt::format("opaque thresholds: view {} of {}", view + 1, views.size()));
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
    const std::vector<DrawnWay> ways = ways_of(settings_.modes);
    const std::vector<double> times = measure_order_times(pictures_, comparer_, ways, poses_[0].moments[0],
                                                          ways_.finest.indices, settings_.timing_seconds);
    const auto sorting =
        measure_sorting(pictures_, comparer_, ways_, poses_[0].moments[0], kSortingShare * settings_.timing_seconds);
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const double ms = times[i];
      for (OrderRow& row : report_.rows) {
        if (i < ways_.orders.size() && row.order == ways[i].name) take_times(row, ms, sorting[i]);
      }
      for (OrderModeRow& row : report_.modes) {
        if (i >= ways_.orders.size() && row.transparency == ways[i].name) row.ms_per_frame = ms;
      }
    }
  }

  const Asset& asset_;
  const OrderSettings& settings_;
  const ReportProgress& progress_;
  render::OrderPictures& pictures_;
  const OrderWays ways_;
  const std::vector<OrderPose> poses_;
  PictureComparer comparer_;
  OrderReport report_;
};

}  // namespace

tl::expected<OrderReport, ToolError> measure_order(const Asset& asset, const OrderSettings& settings,
                                                   const ReportProgress& progress) {
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  const auto solver = chosen_solver(settings.solver);
  if (!solver) return tl::unexpected(solver.error());
  auto poses = make_order_poses(asset, **solver);
  if (!poses) return tl::unexpected(poses.error());
  if (progress) progress("exact pictures");
  auto exactness = measure_exactness(asset, poses->front().moments.front(), settings.width, settings.height);
  if (!exactness) return tl::unexpected(exactness.error());
  auto pictures =
      render::OrderPictures::create(asset, {.stream_bytes = render::stream_bytes_for(asset), .list_bytes = kListBytes});
  if (!pictures) return tl::unexpected(pictures.error());
  auto ways = make_order_ways(asset, **pictures);
  if (!ways) return tl::unexpected(ways.error());
  auto report = OrderMeasurement(asset, settings, progress, **pictures, std::move(*ways), std::move(*poses)).run();
  if (report) report->reference = std::move(*exactness);
  return report;
}

}  // namespace coif::report
