#pragma once
// How the chains of an asset are laid side by side, so that one SIMD vector steps several of them.

#include "lanes/lane_code.h"
#include "lanes/row.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

struct Solver;

/// What lies side by side in a row. Either way there is no gather and no shuffle: a row's lanes are neighbours in memory.
enum class LaneOrder : std::uint8_t {
  kHeads,   ///< The same chain of sixteen heads: for crowds.
  kChains,  ///< Up to sixteen chains of equal shape of one head: for few heads with many chains.
};

/// One row of every block of heads (kHeads) or of every head (kChains).
struct Row {
  const Solver* solver = nullptr;
  RowFunction* step = nullptr;   ///< The solver's, for the processor at hand.
  std::uint32_t first_bone = 0;  ///< Of the row's bones among those of all rows.
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

/// Fills BoneLanes::carried of a row, for those that ask for it: the passive model, and links.
void find_carried(std::span<const RowBone> bones, std::span<BoneLanes> constants);

/// Fills LimitLanes, which lie as `bones`, and says which of these are bounded. `asset` has limits.
void set_limits(const Asset& asset, std::span<const Row> rows, std::span<RowBone> bones, std::span<LimitLanes> limits);

/// The bone of the asset that stands in `lane` of a row's bone; the first lane's for kHeads.
[[nodiscard]] inline std::uint32_t bone_in_lane(const Asset& asset, const Row& row, std::uint32_t bone,
                                                std::uint32_t lane) {
  return asset.chains()[row.first_chain + (lane < row.chain_count ? lane : 0)].first_bone + bone;
}

}  // namespace coif
