#pragma once

#include <coif/export.h>
#include <coif/hair.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxWorldAssets = 4096;

/// A handle of an asset in a HairWorld, valid until the asset is removed; the default names none. The generation tells
/// a removed asset from a later one at the same index.
struct WorldAsset {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
};

/// A handle of a head, as WorldAsset.
struct WorldHead {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
};

struct WorldDesc {
  std::uint32_t assets = 32;  ///< Most assets at one time, 1..kMaxWorldAssets.
  std::uint32_t heads = 128;  ///< Most heads at one time, of all assets together, 1..kMaxInstances.
  /// Memory for the data of assets and heads, up to SIZE_MAX / 4; HairWorld::bytes_for() says how much they need. Where
  /// assets of many sizes come and go all the time, free memory becomes fragmented: give more than the sum, and handle
  /// kMemoryTooSmall.
  std::size_t hair_bytes = std::size_t{4} << 20;
  const Solver* solver = &kCoifSolver;  ///< Moves all heads: kCoifSolver, kCascadeSolver or kPassiveSolver.
  /// As in HairDesc. A few lanes left over run on a narrower set.
  InstructionSet instruction_set = InstructionSet::kBest;
};

struct WorldState;

/// Heads with hair of many assets, which come and go while a game runs and are stepped together. Chains of equal shape
/// are computed side by side, whatever their asset, head and lengths. Forty heads of fifteen assets take about half the
/// time of one Hair for each asset (tests/bench); many heads of one asset are faster in a Hair.
///
/// Each head has the same bits in every step as in a Hair of its asset alone with the same calls. Other heads and
/// assets, the instruction set and the order of jobs change nothing.
///
/// Allocates nothing: the caller gives memory once. Not thread safe except run_job(). HairWorld lacks some features of
/// Hair: kThesisSolver, characters, links, levels of detail and intervals, gusts, air of single heads, pushes, sets of
/// dynamics, settling, saved states, bone ends. It has no C interface.
class COIF_API HairWorld {
 public:
  HairWorld() = default;
  HairWorld(const HairWorld&) = delete;  ///< Two owners would step the same memory.
  HairWorld& operator=(const HairWorld&) = delete;
  HairWorld(HairWorld&& other) noexcept : world_(other.world_) { other.world_ = nullptr; }
  HairWorld& operator=(HairWorld&& other) noexcept {
    world_ = other.world_;
    if (&other != this) other.world_ = nullptr;
    return *this;
  }

  /// Exactly the memory that create() needs; zero bytes for a description that it refuses.
  [[nodiscard]] static MemoryNeed memory_need(const WorldDesc& desc);
  /// The part of WorldDesc::hair_bytes that an asset takes with so many heads when nothing is shared with other assets;
  /// several together take less. 0 for an asset that is not open or a solver that a world does not support.
  [[nodiscard]] static std::size_t bytes_for(const Asset& asset, std::uint32_t heads,
                                             const Solver& solver = kCoifSolver);

  /// Creates an empty world. `memory` must outlive this object. kBadArgument (desc), kMemoryTooSmall (or not aligned).
  Status create(const WorldDesc& desc, std::span<std::byte> memory);

  // These four may be called between any two steps. They take microseconds (add_asset() a few more, for each chain),
  // and change no bit of any other head's hair. On failure nothing changes.

  /// The asset's bytes must stay until it is removed; the Asset itself need not. kAssetLacksData for an asset that is
  /// not open, kMemoryTooSmall where WorldDesc::assets or hair_bytes are used up.
  Status add_asset(const Asset& asset, WorldAsset& added);
  /// kBadArgument while the asset has heads; kBadIndex.
  Status remove_asset(WorldAsset asset);
  /// Adds a head at `pose`, with its hair in the rest pose there, at rest. kBadIndex, kBadPose, kBadScale,
  /// kMemoryTooSmall.
  Status add_head(WorldAsset asset, const HeadPose& pose, WorldHead& added);
  Status remove_head(WorldHead head);  ///< kBadIndex.

  [[nodiscard]] bool has(WorldAsset asset) const;
  [[nodiscard]] bool has(WorldHead head) const;

  // As the functions of Hair. kBadIndex for a head that does not exist.
  Status set_head(WorldHead head, const HeadPose& pose);
  Status set_head(WorldHead head, const HeadPose& pose, const HeadVelocity& velocity);
  Status reset(WorldHead head, const HeadPose& pose);
  Status teleport(WorldHead head, const HeadPose& pose);
  [[nodiscard]] bool is_asleep(WorldHead head) const;

  /// As Hair::step(), for all heads of all assets. Each asset has its own tuned sub-steps.
  Status step(const StepSettings& settings);
  /// step() in parts, as in Hair. A job is some chains of any heads; begin_step() and finish_step() compute what chains
  /// share.
  Status begin_step(const StepSettings& settings);
  [[nodiscard]] std::uint32_t job_count() const;
  void run_job(std::uint32_t job);
  void finish_step();

  /// As Hair::palette(), one matrix for each bone of the head's asset. Stays at the same address until the head is
  /// removed. Empty for a head that does not exist.
  [[nodiscard]] std::span<const Mat34> palette(WorldHead head) const;

 private:
  WorldState* world_ = nullptr;  ///< In the caller's memory.
};

}  // namespace coif
