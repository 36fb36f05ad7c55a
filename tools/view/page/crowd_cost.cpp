#include "view/page/motion_figures.h"

#include "base/hair_runtime.h"
#include "motion/head_path.h"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <vector>

namespace coif::view {
namespace {

constexpr std::uint32_t kHeads = 64;
constexpr double kRate = 60;
// Milliseconds. Browsers' clocks have a resolution of tenths of a millisecond; other work on the machine only makes a
// batch longer.
constexpr double kShortestBatch = 3, kLongestTrial = 60;  // ms
constexpr int kBatches = 5;

/// A crowd whose heads shake alike.
class ShakenCrowd {
 public:
  ShakenCrowd(const Asset& asset, const Solver& solver) : poses_(kHeads) {
    HairDesc desc;
    desc.instances = kHeads;
    desc.solver = &solver;
    const MemoryNeed need = Hair::memory_need(asset, desc);
    memory_ = allocate(need);
    works_ = memory_ && hair_.create(asset, desc, {memory_.get(), need.bytes}) == Status::kOk;
  }

  /// Milliseconds for this many steps.
  double time(int steps) {
    const double begin = emscripten_get_now();
    for (int i = 0; i < steps && works_; ++i) {
      std::fill(poses_.begin(), poses_.end(), head_pose(motion::Motion::kTurn, ++done_ / kRate));
      works_ = hair_.set_heads(poses_) == Status::kOk && hair_.step({.dt = float(1 / kRate)}) == Status::kOk;
    }
    return emscripten_get_now() - begin;
  }

  [[nodiscard]] bool works() const { return works_; }

 private:
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  std::vector<HeadPose> poses_;
  int done_ = 0;
  bool works_ = false;
};

}  // namespace

double crowd_cost(const Asset& asset, const Solver& solver) {
  const std::uint32_t bones = asset.skeleton().simulated_count;
  if (bones == 0 || asset.dynamics().empty()) return 0;
  ShakenCrowd crowd(asset, solver);
  const double begin = emscripten_get_now();
  int steps = 4;
  double least = crowd.time(steps);
  while (crowd.works() && least < kShortestBatch) least = crowd.time(steps *= 2);
  for (int batch = 1; batch < kBatches && emscripten_get_now() - begin < kLongestTrial; ++batch) {
    least = std::min(least, crowd.time(steps));
  }
  const double substeps = &solver == &kThesisSolver ? 1 : tuned_substeps(asset, float(1 / kRate));
  return crowd.works() ? 1e6 * least / (steps * double(kHeads) * double(bones) * substeps) : 0;
}

}  // namespace coif::view
