#pragma once
// Vectors as wide as the lanes that are in use: where few are, narrow ones take down to half the time of the widest.
// The bits are the same.

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

/// The narrowest instruction set for each width that holds it in one vector, or else `widest`: of those that this build
/// and this processor have.
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

// How the chains of an asset are laid side by side, so that one SIMD vector steps several of them.

struct Solver;

/// What lies side by side in a row. Either way there is no gather and no shuffle: a row's lanes are neighbours in
/// memory.
enum class LaneOrder : std::uint8_t {
  kHeads,   ///< The same chain of sixteen heads: for crowds.
  kChains,  ///< Up to sixteen chains of equal shape of one head: for few heads with many chains.
};

/// One row of every block of heads (kHeads) or of every head (kChains).
struct Row {
  const Solver* solver = nullptr;
  RowFunction* steps[kWidths] = {};  ///< The solver's, for the processor at hand.
  std::uint32_t first_bone = 0;      ///< Of the row's bones among those of all rows.
  std::uint32_t bone_count = 0;
  std::uint32_t first_chain = 0;
  std::uint32_t chain_count = 0;  ///< 1 for kHeads, else the lanes in use.
};

struct RowCount {
  std::uint32_t rows = 0;
  std::uint32_t bones = 0;            ///< Of all rows.
  std::size_t state_bytes = 0;        ///< Per bone: as many as the solver needs that needs most.
  std::size_t coefficient_bytes = 0;  ///< As state_bytes.
  std::size_t scratch_bytes = 0;      ///< Per block, for the row that needs most.
  bool has_substeps = false;          ///< Some solver has them.
};

/// The order that keeps fewer lanes idle.
[[nodiscard]] LaneOrder choose_lane_order(const Asset& asset, const Solver& solver, std::uint32_t instances);

[[nodiscard]] RowCount count_rows(const Asset& asset, const Solver& solver, LaneOrder order);

/// `rows`, `bones` and `constants` as count_rows() says.
void make_rows(const Asset& asset, const Solver& solver, LaneOrder order, std::span<Row> rows, std::span<RowBone> bones,
               std::span<BoneLanes> constants);

/// Fills BoneLanes::carried of one lane, for those that ask for it: the passive model, and links.
void find_carried(std::span<const RowBone> bones, std::uint32_t lane, BoneLanes* constants);

/// By a LimitRecord.
[[nodiscard]] inline bool is_bounded(const Asset& asset, std::uint32_t bone) {
  return !asset.limits().empty() && asset.limits()[bone].kind != LimitKind::kUnlimited;
}

/// Of a bone in its chain; -1 for one that hangs from a rigid bone.
[[nodiscard]] std::int32_t parent_in_chain(std::span<const BoneRecord> bones, const ChainRecord& chain,
                                           std::uint32_t i);

/// What bones leave for their children, and where; RowBone::parent is known.
void assign_slots(std::span<RowBone> bones);

/// Writes a bone of the asset into a lane of a row, and adds what it asks for to `shape`.
void add_bone(const Asset& asset, std::uint32_t bone, std::uint32_t lane, RowBone& shape, BoneLanes& constants);

/// What a bone asks of its row; of RowFeature, without those that follow from its place in the chain.
[[nodiscard]] std::uint32_t features_of(const BoneRecord& bone, const DynamicsRecord& dynamics);

/// Writes what bounds a bone into a lane.
void set_limit(const LimitRecord& limit, std::uint32_t lane, LimitLanes& lanes);

/// Fills LimitLanes, which lie as `bones`, and says which of these are bounded. `asset` has limits.
void set_limits(const Asset& asset, std::span<const Row> rows, std::span<RowBone> bones, std::span<LimitLanes> limits);

/// The bone of the asset that stands in `lane` of a row's bone; the first lane's for kHeads.
[[nodiscard]] inline std::uint32_t bone_in_lane(const Asset& asset, const Row& row, std::uint32_t bone,
                                                std::uint32_t lane) {
  return asset.chains()[row.first_chain + (lane < row.chain_count ? lane : 0)].first_bone + bone;
}

}  // namespace coif
