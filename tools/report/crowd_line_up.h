#pragma once

#include "report/cost_report.h"
#include "report/hair_crowd.h"
#include "timing.h"

#include <functional>
#include <memory>
#include <vector>

namespace coif {

/// Crowds that are timed beside each other. All live at once, so that a slow moment of the machine hits all.
class CrowdLineUp {
 public:
  /// `seconds`: to spend on all of them.
  explicit CrowdLineUp(double seconds) : seconds_(seconds) {}

  /// Takes the crowd's frames. Error: that of HairCrowd::create(). `asset` must outlive this object.
  tl::expected<void, ToolError> add(const Asset& asset, const CrowdSettings& settings);
  /// Takes only the handing over of the poses.
  tl::expected<void, ToolError> add_poses(const Asset& asset, const CrowdSettings& settings);

  /// Why a crowd of this size is not worth adding: it would take more than its share of the time, judged by `second_per_head`
  /// of a smaller one, or of the memory. Empty where it is.
  [[nodiscard]] std::string objection(const Asset& asset, const CrowdSettings& settings, double seconds_per_head) const;

  /// Of one frame of all that were added, in their order.
  [[nodiscard]] std::vector<Timing> time() const;

 private:
  tl::expected<HairCrowd*, ToolError> take(const Asset& asset, const CrowdSettings& settings);

  double seconds_;
  std::uint64_t bytes_ = 0;  ///< Of all crowds.
  std::vector<std::unique_ptr<HairCrowd>> crowds_;
  std::vector<std::function<void()>> works_;
  std::vector<unsigned> frames_;  ///< That each of works_ runs.
};

}  // namespace coif
