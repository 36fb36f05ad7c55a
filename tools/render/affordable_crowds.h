#pragma once

#include "render/crowd_stage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// A crowd that was not measured.
struct DrawCostLeftOut {
  std::uint32_t heads = 0;
  std::string why;
};

inline constexpr std::uint32_t kMostDrawnHeads = 10'000;

/// Puts crowds on a stage as long as one frame of theirs does not take too long; small crowds first, since they tell what
/// large ones would take at the least. One head is never too slow.
class AffordableCrowds {
 public:
  /// `longest_frame`: seconds, with blend. `stage` and `make_crowd` must outlive this object.
  AffordableCrowds(CrowdStage& stage, const MakeCrowd& make_crowd, double longest_frame)
      : stage_(stage), make_crowd_(make_crowd), longest_frame_(longest_frame) {}

  /// A crowd with one head for each of the view's places; no fewer than the last. Returns its number on the stage;
  /// nothing where it was left out. Errors: kBadInput where the hair cannot be drawn; those of `make_crowd`.
  tl::expected<std::optional<std::uint32_t>, ToolError> add(const CrowdView& view);

  /// In the order in which they came: all from some size on.
  [[nodiscard]] const std::vector<DrawCostLeftOut>& left_out() const { return left_out_; }

 private:
  [[nodiscard]] double least_seconds(std::uint32_t heads) const;
  bool leave_out_slow(double seconds, std::uint32_t heads);

  CrowdStage& stage_;
  const MakeCrowd& make_crowd_;
  double longest_frame_;
  double last_seconds_ = 0;       ///< Of a frame of the largest crowd so far.
  std::uint32_t last_heads_ = 1;  ///< Of that crowd.
  std::vector<DrawCostLeftOut> left_out_;
};

}  // namespace coif
