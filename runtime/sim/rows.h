#pragma once
// Vectors as wide as the lanes in use. With few lanes, narrow ones take down to half the time of the widest. The bits
// are the same.

#include "lanes/lane_code.h"
#include "lanes/row.h"

#include <coif/asset.h>
#include <coif/instruction_set.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kWidths = 3;  ///< Up to 4, 8 and 16 lanes.
[[nodiscard]] constexpr std::uint32_t width_for(std::uint32_t lanes) { return lanes <= 4 ? 0 : lanes <= 8 ? 1 : 2; }
[[nodiscard]] constexpr std::uint32_t lanes_of(std::uint32_t width) { return 4u << width; }

/// For each width the narrowest instruction set that holds it in one vector, or else `widest`, of those that this build
/// has and this processor supports.
struct WidthSets {
  explicit WidthSets(InstructionSet widest) {
    using enum InstructionSet;
    set[2] = widest;
    set[1] = widest == kAvx512 ? narrowed(widest, kAvx2) : widest;
    set[0] = widest == kAvx512 || widest == kAvx2 ? narrowed(set[1], kSse4) : widest;
  }

  InstructionSet set[kWidths];

 private:
  static InstructionSet narrowed(InstructionSet set, InstructionSet narrower) {
    return can_run(narrower) ? narrower : set;
  }
};
// The arrangement of an asset's chains in rows, so that one SIMD vector steps several of them.

struct Solver;

/// The contents of a row's lanes. In all orders lanes are neighbours in memory, so there is no gather and no shuffle.
enum class LaneOrder : std::uint8_t {
  kHeads,   ///< The same chain of sixteen heads: for crowds.
  kChains,  ///< Up to sixteen chains of equal shape of one head: for few heads with many chains.
  kShared,  ///< Chains of equal shape of any heads and assets: see bundles/bundles.h. Not for make_rows().
};

/// A row that every block of heads has (kHeads), or every head (kChains).
struct Row {
  const Solver* solver = nullptr;
  RowFunction* steps[kWidths] = {};  ///< The solver's functions for this processor.
  std::uint32_t first_bone = 0;      ///< Where the row's bones begin among those of all rows.
  std::uint32_t bone_count = 0;
  std::uint32_t first_chain = 0;
  std::uint32_t chain_count = 0;  ///< 1 for kHeads, else the lanes in use.
};

struct RowCount {
  std::uint32_t rows = 0;
  std::uint32_t bones = 0;            ///< Bones of all rows together.
  std::size_t state_bytes = 0;        ///< Per bone: as many as the solver with the largest state needs.
  std::size_t coefficient_bytes = 0;  ///< Per bone: as many as the solver with the largest coefficients needs.
  std::size_t scratch_bytes = 0;      ///< Per block: as many as the row with the largest need.
  bool has_substeps = false;          ///< Some solver has them.
};

/// The order with fewer idle lanes.
[[nodiscard]] LaneOrder choose_lane_order(const Asset& asset, const Solver& solver, std::uint32_t instances);

[[nodiscard]] RowCount count_rows(const Asset& asset, const Solver& solver, LaneOrder order);

/// The spans must have the sizes that count_rows() says.
void make_rows(const Asset& asset, const Solver& solver, LaneOrder order, std::span<Row> rows, std::span<RowBone> bones,
               std::span<BoneLanes> constants);

/// Fills BoneLanes::carried of one lane, for the passive model and for links.
void find_carried(std::span<const RowBone> bones, std::uint32_t lane, BoneLanes* constants);

/// The bone has a LimitRecord that limits it.
[[nodiscard]] inline bool is_bounded(const Asset& asset, std::uint32_t bone) {
  return !asset.limits().empty() && asset.limits()[bone].kind != LimitKind::kUnlimited;
}

/// The number of a bone's parent in its chain; -1 for a bone that hangs from a rigid one.
[[nodiscard]] std::int32_t parent_in_chain(std::span<const BoneRecord> bones, const ChainRecord& chain,
                                           std::uint32_t i);

/// Assigns the slots in which bones leave values for their children. RowBone::parent must be set.
void assign_slots(std::span<RowBone> bones);

/// Writes a bone of the asset into a lane of a row, and adds its features to `shape`.
void add_bone(const Asset& asset, std::uint32_t bone, std::uint32_t lane, RowBone& shape, BoneLanes& constants);

/// The RowFeature bits that a bone needs of its row, without those that follow from its place in the chain.
[[nodiscard]] std::uint32_t features_of(const BoneRecord& bone, const DynamicsRecord& dynamics);

/// Writes a bone's limit into a lane.
void set_limit(const LimitRecord& limit, std::uint32_t lane, LimitLanes& lanes);

/// Fills LimitLanes, in the order of `bones`, and marks the bounded ones. `asset` must have limits.
void set_limits(const Asset& asset, std::span<const Row> rows, std::span<RowBone> bones, std::span<LimitLanes> limits);

/// The asset's bone in `lane` of a row's bone; the first lane's for kHeads.
[[nodiscard]] inline std::uint32_t bone_in_lane(const Asset& asset, const Row& row, std::uint32_t bone,
                                                std::uint32_t lane) {
  return asset.chains()[row.first_chain + (lane < row.chain_count ? lane : 0)].first_bone + bone;
}

}  // namespace coif
