#include "report/cost/measure_cost.h"

#include "lab/rig.h"
#include "write/strip_asset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kSubsteps[] = {1, 2, 4, 8};
constexpr std::uint32_t kComparedHeads[] = {100, 50, 20, 10, 5, 2, 1};
constexpr double kComparedSeconds = 2e-3;  // Seconds of one frame: small compared with the total time.

using Added = tl::expected<void, ToolError>;

CrowdMemory memory_of(const Asset& asset, const std::string& solver) {
  // Both are multiples of every number of heads that a processor could step at once.
  constexpr std::uint32_t kFew = 1024, kMany = 2048;
  const auto few = double(HairCrowd::memory_bytes(asset, {.heads = kFew, .solver = solver}));
  const auto many = double(HairCrowd::memory_bytes(asset, {.heads = kMany, .solver = solver}));
  const double each = (many - few) / (kMany - kFew);
  return {each, few - each * kFew};
}

class CostMeasurement {
 public:
  CostMeasurement(const Asset& asset, const CostSettings& settings, std::vector<std::string> solvers)
      : asset_(asset), settings_(settings), solvers_(std::move(solvers)), line_up_(settings.seconds) {}

  Added line_up() {
    for (const std::string& solver : solvers_) {
      if (auto paced = learn_pace(solver); !paced) return paced;
    }
    compared_heads_ = choose_compared_heads();
    for (const std::string& solver : solvers_) {
      if (auto added = add_scaling(solver); !added) return added;
      if (auto added = add_substeps(solver); !added) return added;
    }
    return add_features();
  }

  /// Adds the results to `report`.
  void time(CostReport& report) {
    const std::vector<Timing> timings = line_up_.time();
    for (std::size_t i = 0; i < timings.size(); ++i) {
      const bool is_feature = i >= report_.simulation.size();
      is_feature ? fill(report_.features[i - report_.simulation.size()], timings[i])
                 : fill(report_.simulation[i], timings[i]);
    }
    for (FeatureCostRow& row : report_.features) {
      row.change_pct = 100 * (row.us_per_frame / report_.features.front().us_per_frame - 1);
    }
    report.simulation = std::move(report_.simulation);
    report.features = std::move(report_.features);
    report.left_out = std::move(report_.left_out);
  }

 private:
  /// As the asset asks for; `thesis` has no sub-steps.
  [[nodiscard]] std::uint32_t default_substeps(const std::string& solver) const {
    return solver == "thesis" ? 1 : tuned_substeps(asset_, float(1 / kCrowdRate));
  }

  /// Estimates from one head the time of many.
  Added learn_pace(const std::string& solver) {
    constexpr double kSeconds = 0.02;
    CrowdLineUp alone(kSeconds);
    auto added = alone.add(asset_, {.heads = 1, .solver = solver, .substeps = default_substeps(solver)});
    if (added) pace_[solver] = alone.time().front().seconds;
    return added;
  }

  [[nodiscard]] std::uint32_t choose_compared_heads() const {
    const double slowest =
        std::ranges::max_element(pace_, {}, [](const auto& of_one) { return of_one.second; })->second;
    const auto fits = [slowest](std::uint32_t heads) { return heads * slowest <= kComparedSeconds; };
    const auto* const found = std::ranges::find_if(kComparedHeads, fits);
    return found == std::end(kComparedHeads) ? 1 : *found;
  }

  Added add_row(const CrowdSettings& crowd) {
    const auto same = [&crowd](const SimulationCostRow& row) {
      return row.solver == crowd.solver && row.heads == crowd.heads && row.substeps == crowd.substeps;
    };
    if (std::ranges::any_of(report_.simulation, same)) return {};
    SimulationCostRow row{.heads = crowd.heads, .solver = std::string(crowd.solver), .substeps = crowd.substeps};
    row.bytes = HairCrowd::memory_bytes(asset_, crowd);
    row.bytes_per_head = double(row.bytes) / crowd.heads;
    report_.simulation.push_back(row);
    return line_up_.add(asset_, crowd);
  }

  Added add_scaling(const std::string& solver) {
    for (const std::uint32_t heads : settings_.heads) {
      const CrowdSettings crowd{.heads = heads, .solver = solver, .substeps = default_substeps(solver)};
      const std::string objection = heads == 1 ? "" : line_up_.objection(asset_, crowd, pace_[solver]);
      if (!objection.empty()) {
        report_.left_out.push_back({heads, solver, objection});
      } else if (auto added = add_row(crowd); !added) {
        return added;
      }
    }
    return {};
  }

  Added add_substeps(const std::string& solver) {
    for (const std::uint32_t substeps : kSubsteps) {
      auto added = add_row({.heads = compared_heads_, .solver = solver, .substeps = substeps});
      if (!added) return added;
    }
    return {};
  }

  /// The cooked asset, or one made from it.
  const Asset& asset_for(FeatureAsset kind) {
    if (kind == FeatureAsset::kTouchingNothing) return bald_.emplace(lab::untouched_part(asset_)).asset();
    if (kind == FeatureAsset::kLinked) return linked_.emplace(with_neighbours_linked(asset_)).asset();
    return asset_;
  }

  Added add_features() {
    const std::string& solver = solvers_.front();
    const CrowdSettings usual{.heads = compared_heads_, .solver = solver, .substeps = default_substeps(solver)};
    for (const CrowdFeature& feature : crowd_features(asset_, usual)) {
      const Asset& asset = asset_for(feature.asset);
      report_.features.push_back(
          {.feature = feature.name, .description = feature.description, .heads = compared_heads_});
      auto added = feature.steps ? line_up_.add(asset, feature.settings) : line_up_.add_poses(asset, feature.settings);
      if (!added) return added;
    }
    return {};
  }

  template <typename Row>
  void fill(Row& row, const Timing& timing) const {
    row.us_per_frame = 1e6 * timing.seconds;
    row.ns_per_bone_frame = 1e9 * timing.seconds / (double(row.heads) * asset_.skeleton().simulated_count);
    row.spread_pct = timing.spread_pct;
  }

  const Asset& asset_;
  const CostSettings& settings_;
  std::vector<std::string> solvers_;
  std::map<std::string, double> pace_;  ///< Seconds a frame of one head.
  std::uint32_t compared_heads_ = 1;
  std::optional<lab::OpenedAsset> bald_;
  std::optional<lab::OpenedAsset> linked_;
  CrowdLineUp line_up_;
  CostReport report_;  ///< Rows in the order of line_up_: simulation, then features.
};

tl::expected<std::vector<std::string>, ToolError> chosen(const std::vector<std::string>& names) {
  const auto known = crowd_solvers();
  if (names.empty()) return std::vector<std::string>(known.begin(), known.end());
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) != known.end()) continue;
    return tl::unexpected(ToolError{
        ToolError::Kind::kUsage,
        fmt::format("'{}' is no solver that a game can run; cost is measured of {}", name, fmt::join(known, ", "))});
  }
  return names;
}

Added check(const CostSettings& settings) {
  const auto in_range = [](std::uint32_t heads) { return heads >= 1 && heads <= kMaxInstances; };
  if (settings.heads.empty() || !std::ranges::all_of(settings.heads, in_range) || !(settings.seconds > 0)) {
    return tl::unexpected(ToolError{ToolError::Kind::kUsage,
                                    fmt::format("crowds have 1 to {} heads, and measuring takes time", kMaxInstances)});
  }
  return {};
}

}  // namespace

tl::expected<CostReport, ToolError> measure_cost(const Asset& asset, const CostSettings& settings,
                                                 const ReportProgress& progress) {
  const auto solvers = chosen(settings.solvers);
  if (!solvers) return tl::unexpected(solvers.error());
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  CostReport report;
  report.asset = asset_bytes(asset);
  if (asset.skeleton().simulated_count == 0 || asset.dynamics().empty()) return report;
  report.instruction_set = name_of(best_instruction_set());
  report.memory = memory_of(asset, solvers->front());
  if (progress) progress("simulation");
  CostMeasurement measurement(asset, settings, *solvers);
  if (auto added = measurement.line_up(); !added) return tl::unexpected(added.error());
  measurement.time(report);
  return report;
}

AssetBytes asset_bytes(const Asset& asset) {
  AssetBytes bytes{asset.total_bytes(), {}, asset.total_bytes()};
  for (const ChunkEntry& entry : asset.chunks()) {
    bytes.chunks.push_back({chunk_name(entry.id), chunk_contents(entry.id), entry.bytes, chunk_use(entry.id)});
    bytes.framing -= entry.bytes;
  }
  return bytes;
}

}  // namespace coif::report
