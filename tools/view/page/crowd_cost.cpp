#include "view/page/crowd_cost.h"

#include "base/hair_runtime.h"
#include "motion/head_path.h"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <vector>

namespace coif {
namespace {

constexpr std::uint32_t kHeads = 64;
constexpr double kRate = 60, kMostMilliseconds = 60;
constexpr int kMostSteps = 120, kWarmSteps = 10;

}  // namespace

double crowd_cost(const Asset& asset, const Solver& solver) {
  const std::uint32_t bones = asset.skeleton().simulated_count;
  if (bones == 0 || asset.dynamics().empty()) return 0;
  HairDesc desc;
  desc.instances = kHeads;
  desc.solver = &solver;
  const MemoryNeed need = Hair::memory_need(asset, desc);
  const HairMemory memory = allocate(need);
  Hair hair;
  if (!memory || hair.create(asset, desc, {memory.get(), need.bytes}) != Status::kOk) return 0;
  const StepSettings step{.dt = float(1 / kRate)};
  double begin = 0;
  int steps = -kWarmSteps;
  while (steps < kMostSteps) {
    if (steps++ == 0) begin = emscripten_get_now();
    const std::vector<HeadPose> poses(kHeads, head_pose(Motion::kTurn, (steps + kWarmSteps) / kRate));
    if (hair.set_heads(poses) != Status::kOk || hair.step(step) != Status::kOk) return 0;
    if (steps > 10 && emscripten_get_now() - begin > kMostMilliseconds) break;
  }
  const double substeps = &solver == &kThesisSolver ? 1 : tuned_substeps(asset, step.dt);
  return 1e6 * (emscripten_get_now() - begin) / (double(steps) * kHeads * bones * substeps);
}

}  // namespace coif
