#pragma once
// Linked chains: which bones of an asset's rows have links, and the code that keeps links at their lengths. It runs
// once per head and part of a step, after the rows.

#include "lanes/linked_bone.h"
#include "lanes/row.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

struct LinkCode;
struct Solver;
struct WornAsset;
class MemoryCarver;

/// A chain with at least one link, and all of its bones.
struct LinkedChain {
  std::uint32_t row = 0;    ///< Index into LinkState::row_places.
  std::uint32_t lane = 0;   ///< Lane of the row, for kChains; 0 for kHeads.
  std::uint32_t first = 0;  ///< Where its bones begin in LinkState::places.
  std::uint32_t bone_count = 0;
};

/// A bone of a linked chain.
struct LinkedBone {
  std::uint32_t chain = 0;   ///< Index into LinkState::chains.
  std::uint32_t bone = 0;    ///< Its number in its row.
  std::int32_t parent = -1;  ///< Index into LinkState::bones; -1: the head.
  bool has_children = false;
  /// One by the mass that a link feels at the bone's particle, 1/kg for bones of a kilogram per metre.
  float mobility = 0;
};

/// A LinkRecord with indices into LinkState::bones.
struct ChainLink {
  std::uint32_t bone = 0, to = 0;
  float shortest = 0, longest = 0;
};

/// Bones of one depth, and the links between them.
struct LinkLevel {
  std::uint32_t first_bone = 0, bone_count = 0;
  std::uint32_t first_link = 0, link_count = 0;
};

/// A row with linked chains, and how it was stepped.
struct LinkedRowStep {
  const Solver* solver = nullptr;
  RowStep step;
  RowCharacter character;
  Mat34* palettes[kLanes] = {};
};

/// What a block's step needs for its links.
struct LinkWork {
  LinkedRowStep* steps = nullptr;  ///< Per linked row. Valid during a part of a step.
  HeldBone* held = nullptr;        ///< Per linked bone.
  char* moved = nullptr;           ///< Per linked chain.
};

/// Empty where nothing is linked.
struct LinkState {
  const LinkCode* code = nullptr;
  /// Per row: its number among the rows with linked chains, or kNone.
  std::span<std::uint32_t> row_places;
  std::span<std::uint32_t> chain_places;  ///< Per chain of the asset: its index in `chains`, or kNone.
  std::uint32_t row_count = 0;
  std::span<LinkedChain> chains;
  std::span<LinkedBone> bones;      ///< By depth.
  std::span<std::uint32_t> places;  ///< Where each chain's bones are in `bones`, in the chain's order.
  std::span<ChainLink> links;       ///< By depth.
  std::span<LinkLevel> levels;

  [[nodiscard]] bool has(std::uint32_t chain) const { return !chain_places.empty() && chain_places[chain] != kNone; }
};

struct LinkCode {
  bool of_character = false;
  const LinkedBoneCode* bones = nullptr;
  /// The arrays of an asset with so many rows; while counting they are empty.
  void (*carve)(MemoryCarver& carver, const Asset& asset, std::uint32_t rows, LinkState& links) = nullptr;
  void (*carve_work)(MemoryCarver& carver, const Asset& asset, std::uint32_t rows, LinkWork& work) = nullptr;
  void (*create)(WornAsset& worn) = nullptr;
  /// Keeps what a row of a block was stepped with. Does nothing for rows without linked chains.
  void (*keep_row)(const WornAsset& worn, const LinkWork& work, std::size_t row, const RowStep& step) = nullptr;
  /// Keeps the links of one head of a block, whose linked rows are in LinkWork::steps: `lane` is its own in these rows,
  /// -1 where each chain has one. Returns the sum of the squared speeds of the linked chains' tips against the head,
  /// (m/s)^2.
  float (*keep)(const LinkState& links, const LinkWork& work, std::int32_t lane) = nullptr;
};

/// Implements LinkCode::keep: turns the linked bones of one head, depth after depth from root to tip, so that links
/// have their lengths, by the least turns, weighted by mass. Then removes the velocities that would leave these
/// lengths.
[[nodiscard]] float hold_links(const LinkState& links, const LinkWork& work, std::int32_t lane);

}  // namespace coif
