#pragma once
// Heads side by side. Sixteen heads make a block; heads of one crowd with equal treatment share blocks, so a block has
// no idle lanes and no branches between its lanes.

#include "chain_links.h"
#include "dense_list.h"
#include "lanes/lane_layout.h"
#include "lanes/row.h"
#include "rows.h"
#include "solver.h"
#include "step_settings.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

struct ChainShape;
struct Crowd;
struct WornAsset;

/// Sixteen heads of equal treatment; the first `count` lanes are in use. The last pointers lead to memory of its own;
/// they are null where its crowd has no such numbers.
struct Block {
  HeadLanes heads;
  Block* previous = nullptr;
  Block* next = nullptr;
  Crowd* crowd = nullptr;
  std::uint32_t head[kLanes] = {};
  std::uint32_t count = 0;
  std::uint32_t treatment = 0;
  std::uint16_t teleports = 0;  ///< A bit for each lane: the host has put the head somewhere since the last step.
  std::uint16_t is_lost = 0;    ///< A bit for each lane: moved too far for single precision.
  std::uint16_t may_sleep = 0;  ///< A bit for each lane: at rest for long enough in the last step.
  std::byte* memory = nullptr;  ///< Memory of all that follows.
  std::byte* state = nullptr;   ///< kHeads: per bone of the rows.
  TwistState* twist = nullptr;  ///< kHeads: per bone of the rows.
  PoseLanes* poses = nullptr;   ///< kHeads: per bone of the rows.
  std::byte* scratch = nullptr;
  HeadStepLanes* step = nullptr;     ///< kShared: in the present step.
  ColliderBounds* bounds = nullptr;  ///< Per collider place. Valid during a step.
  GustLanes* gusts = nullptr;        ///< Valid during a part of a step.
  std::uint32_t most_ways = 0;       ///< Most colliders that one of its heads may touch in this step.
  LinkWork links;
};

using BlockPlace = DenseList<Block>::Place;

inline constexpr std::uint32_t kMaxIntervals = 3;  ///< 1, 2 and 4.
inline constexpr std::uint32_t kIdle = 0;          ///< The treatment of heads that are asleep or not simulated.

/// What a treatment, other than kIdle, means.
struct Treatment {
  std::uint32_t level = 0;
  std::uint32_t set = 0;    ///< 0 for kShared, whose lanes may have different ones.
  std::uint32_t power = 0;  ///< The interval is 2 to this power.
  std::uint32_t phase = 0;  ///< Which step of the interval is its turn.

  /// Whether it is to be stepped in the step with this number.
  [[nodiscard]] bool has_its_turn(std::uint32_t step) const { return ((step + phase) & ((1u << power) - 1u)) == 0; }
};

/// Heads of one treatment.
struct TreatedHeads {
  DenseList<Block> blocks;
  Treatment treatment;
};

/// Heads that share blocks: those of one asset, or those of all assets with one pace whose chains stand side by side.
struct Crowd {
  std::uint32_t users = 0;  ///< Number of assets; 0: free.
  LaneOrder order = LaneOrder::kHeads;
  StepPace pace;
  std::uint32_t levels = 1;       ///< Levels of detail in which bones are simulated: 1 where the assets store none.
  std::uint32_t sets = 1;         ///< Sets of dynamics whose heads do not share blocks.
  std::span<std::byte> memory;    ///< Memory of `lists`.
  std::span<TreatedHeads> lists;  ///< Per treatment.
  PartPool<Block> blocks;
  std::size_t number_bytes = 0;                ///< What each block points to needs so many.
  WornAsset* worn = nullptr;                   ///< Its asset, except for kShared.
  ChainShape* shapes = nullptr;                ///< kShared.
  StepParts parts[kMaxIntervals];              ///< In the present step.
  std::uint32_t versions[kMaxIntervals] = {};  ///< kShared: counts the changes of coefficients.
};

/// The detail that the host chose for one head.
struct HeadDetail {
  std::uint8_t level = 0;
  std::uint8_t interval_power = 0;  ///< The interval is 2 to this power.
  std::uint8_t asked_power = 0;     ///< The requested power, used from the next step on that ends both intervals.
  bool simulated = true;
  bool asleep = false;
};

/// One block during a step.
struct BlockStep {
  const Crowd& crowd;
  Block& block;
  const StepParts& parts;
  Treatment treatment;
  HeadStepLanes& heads;
  std::uint16_t put = 0;  ///< A bit for each head that was put somewhere.
  Lanes motion{};         ///< See RowStep; one lane per head.
};

}  // namespace coif
