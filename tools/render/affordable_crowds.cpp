#include "render/affordable_crowds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace coif {

/// The same pixels as the last crowd, but more vertices.
double AffordableCrowds::least_seconds(std::uint32_t heads) const {
  constexpr double kVertexShare = 0.2;  // of one head's time, at the least
  return last_seconds_ * std::max(1.0, kVertexShare * heads / last_heads_);
}

bool AffordableCrowds::leave_out_slow(double seconds, std::uint32_t heads) {
  if (heads == 1 || seconds <= longest_frame_) return false;
  left_out_.push_back({heads, "one frame takes " + std::to_string(std::lround(1e3 * seconds)) +
                                  " ms or more, too long for the time there is"});
  return true;
}

tl::expected<std::optional<std::uint32_t>, ToolError> AffordableCrowds::add(const CrowdView& view) {
  const auto heads = std::uint32_t(view.places.size());
  if (!left_out_.empty()) {
    left_out_.push_back({heads, "fewer are too slow already"});
    return std::nullopt;
  }
  if (leave_out_slow(least_seconds(heads), heads)) return std::nullopt;
  auto crowd = make_crowd_(heads);
  if (!crowd) return tl::unexpected(crowd.error());
  const std::uint32_t number = stage_.add(std::move(*crowd), view);
  // The first frame also pays for what drivers put off until then.
  if (const Status status = stage_.draw({.crowd = number}); status != Status::kOk) {
    return tl::unexpected(
        ToolError{ToolError::Kind::kBadInput, std::string("the hair cannot be drawn: ") + describe(status)});
  }
  const auto begin = std::chrono::steady_clock::now();
  (void)stage_.draw({.crowd = number});
  last_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  last_heads_ = heads;
  if (leave_out_slow(last_seconds_, heads)) return std::nullopt;
  return number;
}

}  // namespace coif
