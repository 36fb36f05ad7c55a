#pragma once
// The one place of these programs that knows the class Hair.

#include "bench/job_crew.h"
#include "bench/workload.h"
#include "models/small_asset.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// Words for a table and a command line. The best is the first.
[[nodiscard]] std::vector<std::string> solver_names();
/// The sets that this processor can run.
[[nodiscard]] std::vector<std::string> instruction_set_names();

/// How a crowd is simulated.
struct CrowdRun {
  CrowdShape shape;
  std::string solver = solver_names().front();
  std::string instruction_set = instruction_set_names().front();
  std::uint32_t substeps = 1;
  float sleep_after = StepSettings{}.sleep_after;  ///< Seconds; infinity for hair that never sleeps.
};

/// A crowd whose heads move as head_pose_at() says.
class TimedCrowd {
 public:
  /// Ends the program where `run` names what there is not, or when the runtime refuses the workload, which is this
  /// folder's own.
  explicit TimedCrowd(const CrowdRun& run);

  /// Computes where the heads will be `dt` seconds later; 0 for heads that stand still. Not part of what is timed: a
  /// game has the poses.
  void plan(double dt);
  /// Hands the planned poses to the runtime. Found by its name as step() is.
  [[gnu::noinline]] void set_heads();
  /// One frame of `dt` seconds. Kept out of line, so that tools that count instructions find it by its name.
  [[gnu::noinline]] void step(float dt);
  /// The same frame with its jobs shared out among the threads of `crew`, or all left to the one that calls.
  void step_with(JobCrew& crew, float dt, bool is_shared);

  [[nodiscard]] std::uint32_t sleeping_heads() const;
  [[nodiscard]] double bytes_per_head() const;
  /// False where a step was refused, or hair is not finite or flew away.
  [[nodiscard]] bool is_sane() const;

 private:
  CrowdRun run_;
  AlignedBytes file_;
  Asset asset_;
  AlignedBytes memory_;
  Hair hair_;
  StepSettings settings_;
  std::vector<HeadPose> poses_;
  double seconds_ = 0;
  bool refused_ = false;
};

/// Creates a Hair in `memory` and throws it away. False where the runtime refuses.
[[nodiscard]] bool create_once(const Asset& asset, std::uint32_t heads, std::span<std::byte> memory);

/// Exact need of create_once().
[[nodiscard]] std::size_t bytes_to_create(const Asset& asset, std::uint32_t heads);

}  // namespace coif
