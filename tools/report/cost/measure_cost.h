#pragma once

#include "base/hair_runtime.h"
#include "base/timing.h"
#include "base/tool_error.h"
#include "lab/placed_solid.h"
#include "report/cost/cost_report.h"
#include "report/page/report_heading.h"
#include "write/asset_writer.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif::report {

inline constexpr double kCrowdRate = 60;  ///< Frames per second of a crowd.

/// Names of the solvers that a game can choose.
[[nodiscard]] std::span<const std::string_view> crowd_solvers();

/// The features of characters that heads have.
struct CrowdCharacter {
  bool is_one = false;            ///< kCharacterSolver instead of kCoifSolver; else only `scale` counts.
  std::uint32_t room = 0;         ///< HairDesc::moving_colliders.
  std::uint32_t colliders = 0;    ///< Colliders given to each head: balls of 4 cm that move with it.
  bool are_near = false;          ///< In the hair; else five metres away.
  std::optional<float> weight{};  ///< Weight of a pose that changes from frame to frame; none: the rest pose.
  float scale = 1;
  bool in_gusts = false;
};

struct CrowdSettings {
  std::uint32_t heads = 1;           ///< 1..kMaxInstances.
  std::string_view solver = "coif";  ///< One of crowd_solvers().
  std::uint32_t substeps = 1;        ///< 0: as many as the asset asks for. Iterations of "thesis".
  bool heads_move = true;            ///< Heads run, each at another time of the same motion; else they stand still.
  bool frame_time_varies = false;    ///< Frames last up to a tenth more or less, each another time.
  Detail detail{};                   ///< For every head.
  bool sleeps = true;                ///< Heads that stand still are all asleep when the crowd has been made.
  InstructionSet instruction_set = InstructionSet::kBest;
  CrowdCharacter character{};
};

/// Heads with the runtime's hair, as a game has them. The asset must outlive it.
class HairCrowd {
 public:
  /// The memory that the runtime asks the game for; 0 for a number of heads that it refuses.
  [[nodiscard]] static std::uint64_t memory_bytes(const Asset& asset, const CrowdSettings& settings);

  /// Errors: kBadInput where the runtime refuses the asset, kUsage for
  /// settings out of range, kUnsupported where the memory cannot be had.
  static tl::expected<HairCrowd, ToolError> create(const Asset& asset, const CrowdSettings& settings);

  /// Gives the runtime each head's next pose, and its character's features. False where it refuses that.
  bool hand_over_poses();
  /// Runs one frame: hand_over_poses(), then the step with its matrices. False where the runtime refuses.
  bool step();

  [[nodiscard]] std::span<const Mat34> palette(std::uint32_t head) const { return hair_.palette(head); }

 private:
  HairCrowd(const Asset& asset, const CrowdSettings& settings);
  [[nodiscard]] Status place_heads();
  [[nodiscard]] bool is_at_rest() const;
  [[nodiscard]] bool hand_over_colliders(std::uint32_t head, const HeadPose& pose);

  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  StepSettings step_;
  CrowdSettings settings_;
  std::vector<HeadPose> poses_;  ///< Frame by frame; the last is next to the first.
  std::size_t frame_ = 0;
  std::vector<Eigen::Vector3d> collider_places_;  ///< Head space.
  std::vector<std::vector<Quat>> rotations_;      ///< Poses, frame by frame.
};

/// The asset of a crowd.
enum class FeatureAsset { kOwn, kTouchingNothing, kLinked };

/// A way to run a crowd that differs from the cooked one.
struct CrowdFeature {
  std::string name;         ///< Short, unique: "no-colliders".
  std::string description;  ///< The difference, one line for people.
  CrowdSettings settings;
  FeatureAsset asset = FeatureAsset::kOwn;
  bool steps = true;  ///< False: only the poses are handed over.
};

/// All ways that `asset` and this processor support; the first, kAsCooked, is `usual` itself.
[[nodiscard]] std::vector<CrowdFeature> crowd_features(const Asset& asset, const CrowdSettings& usual);

/// Crowds that are timed side by side. All exist at once, so that a slow moment of the machine affects all.
class CrowdLineUp {
 public:
  /// `seconds`: time for all of them.
  explicit CrowdLineUp(double seconds) : seconds_(seconds) {}

  /// Warms up the crowd. Error: that of HairCrowd::create(). `asset` must outlive this object.
  tl::expected<void, ToolError> add(const Asset& asset, const CrowdSettings& settings);
  /// Takes only the handing over of the poses.
  tl::expected<void, ToolError> add_poses(const Asset& asset, const CrowdSettings& settings);

  /// Why a crowd of this size is not worth adding: it would take more than its share of the time, judged by
  /// `second_per_head` of a smaller one, or of the memory. Empty where it is.
  [[nodiscard]] std::string objection(const Asset& asset, const CrowdSettings& settings, double seconds_per_head) const;

  /// Times of one frame of each crowd, in the order added.
  [[nodiscard]] std::vector<Timing> time() const;

 private:
  tl::expected<HairCrowd*, ToolError> take(const Asset& asset, const CrowdSettings& settings);

  double seconds_;
  std::uint64_t bytes_ = 0;  ///< All crowds together.
  std::vector<std::unique_ptr<HairCrowd>> crowds_;
  std::vector<std::function<void()>> works_;
  std::vector<unsigned> frames_;  ///< Frames that each of works_ runs.
};

/// The bytes of each chunk of an open asset, in the order of the file.
[[nodiscard]] AssetBytes asset_bytes(const Asset& asset);

struct CostSettings {
  std::vector<std::uint32_t> heads{1, 10, 100, 1000, 10000};  ///< Sizes of the crowd, 1..kMaxInstances.
  std::vector<std::string> solvers;                           ///< Names of crowd_solvers(); empty: all.
  double seconds = 8;  ///< Time to spend, > 0. Crowds that would take longer are left out; one head never is.
};

/// Times the runtime on the calling thread, as a game would call it, and measures the asset in memory and in the file.
/// Fills everything except CostReport::rendering; rigid hair has only its bytes. Errors: kUsage for settings out of
/// range or an unknown solver, kUnsupported where there is not enough memory.
tl::expected<CostReport, ToolError> measure_cost(const Asset& asset, const CostSettings& settings,
                                                 const ReportProgress& progress);

/// The data that Hair reads of the asset, with each chain linked to the nearest of those before it, like hair that is
/// linked everywhere: an upper bound of the cost of links. They may stretch by a tenth, and shrink to half.
[[nodiscard]] AssetContents with_neighbours_linked(const Asset& asset);

}  // namespace coif::report
