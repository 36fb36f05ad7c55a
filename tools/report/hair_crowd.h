#pragma once

#include "hair_memory.h"
#include "tool_error.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

inline constexpr double kCrowdRate = 60;  ///< Frames per second of a crowd.

/// Names of the solvers that a game can choose.
[[nodiscard]] std::span<const std::string_view> crowd_solvers();

struct CrowdSettings {
  std::uint32_t heads = 1;           ///< 1..kMaxInstances.
  std::string_view solver = "coif";  ///< One of crowd_solvers().
  std::uint32_t substeps = 1;        ///< 0: as many as the asset asks for. Iterations of "thesis".
  bool heads_move = true;            ///< They run, each at another time of the same motion; else they stand still.
  bool frame_time_varies = false;    ///< Frames last up to a tenth more or less, each another time.
  Detail detail{};                   ///< Of every head.
  bool sleeps = true;                ///< Heads that stand still have all fallen asleep when the crowd is made.
  InstructionSet instruction_set = InstructionSet::kBest;
};

/// Heads with the runtime's hair, as a game has them. The asset must outlive it.
class HairCrowd {
 public:
  /// What the runtime asks the game for; 0 for a number of heads that it refuses.
  [[nodiscard]] static std::uint64_t memory_bytes(const Asset& asset, const CrowdSettings& settings);

  /// Errors: kBadInput where the runtime refuses the asset, kUsage for
  /// settings out of range, kUnsupported where the memory cannot be had.
  static tl::expected<HairCrowd, ToolError> create(const Asset& asset, const CrowdSettings& settings);

  /// Tells the runtime where each head is in the next frame. False where it refuses a pose.
  bool hand_over_poses();
  /// One frame: hand_over_poses(), then the step with its matrices. False where the runtime refuses.
  bool step();

  [[nodiscard]] std::span<const Mat34> palette(std::uint32_t head) const { return hair_.palette(head); }

 private:
  explicit HairCrowd(const CrowdSettings& settings);
  [[nodiscard]] Status place_heads();
  [[nodiscard]] bool is_at_rest() const;

  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  StepSettings step_;
  CrowdSettings settings_;
  std::vector<HeadPose> poses_;  ///< Frame by frame; the last is next to the first.
  std::size_t frame_ = 0;
};

}  // namespace coif
