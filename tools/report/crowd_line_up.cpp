#include "report/crowd_line_up.h"

#include <fmt/format.h>

#include <utility>

namespace coif {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30;  // of all crowds together
constexpr double kLargestShare = 0.25;                        // of the time, for one crowd
constexpr double kLeastRuns = 8;  // of a crowd that is slow: warming up, and the fewest rounds

}  // namespace

tl::expected<HairCrowd*, ToolError> CrowdLineUp::take(const Asset& asset, const CrowdSettings& settings) {
  auto crowd = HairCrowd::create(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  bytes_ += HairCrowd::memory_bytes(asset, settings.heads);
  crowds_.push_back(std::make_unique<HairCrowd>(std::move(*crowd)));
  return crowds_.back().get();
}

tl::expected<void, ToolError> CrowdLineUp::add(const Asset& asset, const CrowdSettings& settings) {
  const auto crowd = take(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  works_.emplace_back([moved = *crowd] { (void)moved->step(); });
  return {};
}

tl::expected<void, ToolError> CrowdLineUp::add_poses(const Asset& asset, const CrowdSettings& settings) {
  const auto crowd = take(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  works_.emplace_back([posed = *crowd] { (void)posed->hand_over_poses(); });
  return {};
}

std::string CrowdLineUp::objection(const Asset& asset, std::uint32_t heads, double seconds_per_head) const {
  const std::uint64_t bytes = HairCrowd::memory_bytes(asset, heads);
  if (bytes > kMostBytes - bytes_) return fmt::format("its {} MB are too many", bytes / 1'000'000);
  const double seconds = seconds_per_head * heads;
  if (seconds * kLeastRuns <= kLargestShare * seconds_) return "";
  return fmt::format("one frame takes about {:.0f} ms, which leaves too few to measure", 1e3 * seconds);
}

std::vector<Timing> CrowdLineUp::time() const {
  return SideBySideTiming({.clock = TimingClock::kThread, .seconds = seconds_}).run(works_);
}

}  // namespace coif
