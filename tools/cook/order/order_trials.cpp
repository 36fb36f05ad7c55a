#include "cook/order/order_trials.h"

#include "base/parallel_for.h"
#include "cook/texture/alpha.h"
#include "lab/rig.h"
#include "motion/head_path.h"

#include <utility>
#include <vector>

namespace coif::cook {
namespace {

struct Moment {
  motion::Motion motion;
  double seconds;
};

/// In addition to rest: hair thrown to both sides and back, and hair blown back.
constexpr Moment kMoments[] = {{motion::Motion::kTurn, 0.15},
                               {motion::Motion::kTurn, 0.35},
                               {motion::Motion::kTurn, 0.6},
                               {motion::Motion::kCharge, 0.2},
                               {motion::Motion::kCharge, 0.5}};

/// The solver of this name in a recipe.
const Solver& solver_named(std::string_view name) {
  if (name == "cascade") return kCascadeSolver;
  if (name == "passive") return kPassiveSolver;
  return name == "thesis" ? kThesisSolver : kCoifSolver;
}

}  // namespace

tl::expected<std::vector<visibility::HairPositions>, ToolError> find_order_poses(const Asset& asset,
                                                                                 std::string_view solver) {
  std::vector<visibility::HairPositions> poses;
  const auto add = [&](const motion::HeadPath* path, double seconds) -> tl::expected<void, ToolError> {
    const auto pose = motion::simulate_pose(asset, path, seconds, {}, &solver_named(solver));
    if (!pose) return tl::unexpected(pose.error());
    poses.push_back(visibility::posed_positions(asset, pose->palette));
    return {};
  };
  if (auto rest = add(nullptr, 0); !rest) return tl::unexpected(rest.error());
  if (asset.dynamics().empty()) return poses;
  for (const Moment& moment : kMoments) {
    const auto path = motion::path_of(moment.motion);
    if (auto moving = add(path.get(), moment.seconds); !moving) return tl::unexpected(moving.error());
  }
  return poses;
}

void ThresholdAlpha::prepare(std::span<const float> thresholds) {
  std::vector<std::pair<const float, visibility::AlphaTexture>*> missing;
  for (const float threshold : thresholds) {
    const auto [place, is_new] = made_.try_emplace(threshold, plain_);
    if (is_new) missing.push_back(&*place);
  }
  parallel_for(missing.size(), threads_, [&](std::size_t i) {
    auto& [threshold, alpha] = *missing[i];
    const std::vector<Image> mips = mips_for_threshold(used_, contents_, threshold);
    for (std::size_t level = 0; level < mips.size(); ++level) alpha.set_texels(level, mips[level].texels);
  });
}

const visibility::AlphaTexture& ThresholdAlpha::at(float threshold) {
  prepare({&threshold, 1});
  return made_.at(threshold);
}

}  // namespace coif::cook
