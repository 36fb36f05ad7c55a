// The coefficients of an asset: bones that move alike share them.

#include "../memory_carver.h"
#include "bundles.h"

namespace coif {
namespace {

/// A bone before `bone` with equal coefficients, as neighbours and chains beside each other often have; kNone if there
/// is none.
std::uint32_t alike_before(const Asset& asset, const Solver& asked, std::uint32_t c, std::uint32_t i) {
  const ChainRecord& chain = asset.chains()[c];
  const Solver& solver = solver_for(asked, chain);
  const std::uint32_t bone = chain.first_bone + i;
  if (c > 0) {
    const ChainRecord& last = asset.chains()[c - 1];
    const bool is_comparable = i < last.bone_count && &solver_for(asked, last) == &solver;
    if (is_comparable && move_alike(solver, asset, bone, last.first_bone + i)) return last.first_bone + i;
  }
  return i > 0 && move_alike(solver, asset, bone, bone - 1) ? bone - 1 : kNone;
}

/// Calls visit(bone, earlier bone with equal coefficients or kNone) for each simulated bone, in order.
template <typename Visit>
void for_each_motion(const Asset& asset, const Solver& asked, const Visit& visit) {
  for (std::uint32_t c = 0; c < asset.chains().size(); ++c) {
    const ChainRecord& chain = asset.chains()[c];
    for (std::uint32_t i = 0; i < chain.bone_count; ++i) visit(chain.first_bone + i, alike_before(asset, asked, c, i));
  }
}

}  // namespace

void carve_motions(MemoryCarver& carver, const WorldRules& rules, WornAsset& worn) {
  const Solver& asked = *rules.solver;
  std::size_t motions = 0;
  for_each_motion(worn.asset, asked, [&](std::uint32_t, std::uint32_t alike) { motions += alike == kNone; });
  worn.coefficient_bytes = 0;
  for (const ChainRecord& chain : worn.asset.chains()) {
    const std::size_t own = solver_for(asked, chain).coefficient_bytes;
    worn.coefficient_bytes = own > worn.coefficient_bytes ? own : worn.coefficient_bytes;
  }
  worn.table_bytes = (motions + kLanes - 1) / kLanes * worn.coefficient_bytes;
  worn.shapes = carver.take<ChainShape*>(worn.asset.chains().size());
  worn.motion_of = carver.take<std::uint32_t>(worn.asset.bones().size());
  worn.motions = carver.take<std::uint32_t>(motions);
}

void number_motions(const WorldRules& rules, WornAsset& worn) {
  std::uint32_t count = 0;
  for_each_motion(worn.asset, *rules.solver, [&](std::uint32_t bone, std::uint32_t alike) {
    if (alike == kNone) worn.motions[count++] = bone;
    worn.motion_of[bone] = alike == kNone ? count - 1 : worn.motion_of[alike];
  });
}

void set_motions(const WorldState& world, WornAsset& worn, const StepTerms& terms, std::byte* table) {
  const auto bones = worn.asset.bones();
  for (std::uint32_t m = 0; m < worn.motions.size(); ++m) {
    const std::uint32_t bone = worn.motions[m];
    const Solver& solver = solver_for(*world.rules.solver, worn.asset.chains()[bones[bone].chain]);
    const DynamicsRecord dynamics = dynamics_for(solver, worn.asset, bone);
    const CoefficientLanes to{table + m / kLanes * worn.coefficient_bytes, m % kLanes, m % kLanes + 1};
    solver.set_coefficients(terms, dynamics, bones[bone].length, to);
  }
}

}  // namespace coif
