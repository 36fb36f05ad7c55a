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
  bytes_ += HairCrowd::memory_bytes(asset, settings);
  crowds_.push_back(std::make_unique<HairCrowd>(std::move(*crowd)));
  return crowds_.back().get();
}

tl::expected<void, ToolError> CrowdLineUp::add(const Asset& asset, const CrowdSettings& settings) {
  const auto crowd = take(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  // Hair that is not stepped in every frame would be timed in one that leaves out all of it, or none.
  const unsigned frames = settings.detail.interval;
  works_.emplace_back([moved = *crowd, frames] {
    for (unsigned i = 0; i < frames; ++i) (void)moved->step();
  });
  frames_.push_back(frames);
  return {};
}

tl::expected<void, ToolError> CrowdLineUp::add_poses(const Asset& asset, const CrowdSettings& settings) {
  const auto crowd = take(asset, settings);
  if (!crowd) return tl::unexpected(crowd.error());
  works_.emplace_back([posed = *crowd] { (void)posed->hand_over_poses(); });
  frames_.push_back(1);
  return {};
}

std::string CrowdLineUp::objection(const Asset& asset, const CrowdSettings& settings, double seconds_per_head) const {
  const std::uint64_t bytes = HairCrowd::memory_bytes(asset, settings);
  if (bytes > kMostBytes - bytes_)
    return fmt::format("its {:.0f} MB are more memory than is set aside", 1e-6 * double(bytes));
  const double seconds = seconds_per_head * settings.heads;
  if (seconds * kLeastRuns <= kLargestShare * seconds_) return "";
  return fmt::format("one frame takes about {:.0f} ms, too long for the time there is", 1e3 * seconds);
}

std::vector<Timing> CrowdLineUp::time() const {
  auto timings = SideBySideTiming({.clock = TimingClock::kThread, .seconds = seconds_}).run(works_);
  for (std::size_t i = 0; i < timings.size(); ++i) timings[i].seconds /= frames_[i];
  return timings;
}

}  // namespace coif
