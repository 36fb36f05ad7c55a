#pragma once
// The one place of these programs that knows the class Hair.

#include "bench/workload.h"
#include "formats/aligned_bytes.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// How a crowd is simulated.
struct CrowdRun {
  CrowdShape shape;
  Solver solver = Solver::kCoif;
  std::uint32_t substeps = 1;

  /// Words for a table: "coif", "thesis"; the instruction set that the solver runs on.
  [[nodiscard]] std::string solver_name() const;
  [[nodiscard]] std::string instruction_set() const;
};

/// A crowd whose heads move as head_pose_at() says.
class Crowd {
 public:
  /// Ends the program when the runtime refuses the workload, which is this folder's own.
  explicit Crowd(const CrowdRun& run);

  /// Computes where the heads will be `dt` seconds later. Not part of what is timed: a game has the poses.
  void plan(double dt);
  /// Hands the planned poses to the runtime.
  void set_heads();
  /// One frame of `dt` seconds. Kept out of line, so that tools that count instructions find it by its name.
  [[gnu::noinline]] void step(float dt);

  [[nodiscard]] double bytes_per_head() const;
  /// False where a step was refused, or hair is not finite or flew away.
  [[nodiscard]] bool is_sane() const;

 private:
  CrowdRun run_;
  Asset asset_;
  Hair hair_;
  AlignedBytes file_;
  AlignedBytes memory_;
  std::vector<HeadPose> poses_;
  double seconds_ = 0;
  bool refused_ = false;
};

/// Creates a Hair in `memory` and throws it away. False where the runtime refuses.
[[nodiscard]] bool create_once(const Asset& asset, std::uint32_t heads, std::span<std::byte> memory);

/// Exact need of create_once().
[[nodiscard]] std::size_t bytes_to_create(const Asset& asset, std::uint32_t heads);

}  // namespace coif
