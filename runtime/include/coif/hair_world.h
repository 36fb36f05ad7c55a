#pragma once

#include <coif/export.h>
#include <coif/hair.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxWorldAssets = 4096;

/// Names an asset of a HairWorld, for as long as it is there; the default names none. Those that left are told from
/// those that came in their place.
struct WorldAsset {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
};

/// The same for a head.
struct WorldHead {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
};

struct WorldDesc {
  std::uint32_t assets = 32;  ///< Most that are there at once, 1..kMaxWorldAssets.
  std::uint32_t heads = 128;  ///< The same of heads, of all assets together, 1..kMaxInstances.
  /// For what assets and heads bring along, up to SIZE_MAX / 4. HairWorld::bytes_for() says how much that is; where
  /// assets of many sizes come and go all the time, free memory falls into pieces: give more than their sum, and be
  /// ready for kMemoryTooSmall.
  std::size_t hair_bytes = std::size_t{4} << 20;
  const Solver* solver = &kCoifSolver;  ///< What moves all heads: kCoifSolver, kCascadeSolver or kPassiveSolver.
  InstructionSet instruction_set = InstructionSet::kBest;  ///< As HairDesc's; few lanes are stepped by narrower ones.
};

struct WorldState;

/// Heads with hair of many assets, which come and go while a game runs, stepped together: chains of equal shape stand
/// side by side whatever asset and head they are of, and whatever their lengths. Forty heads of fifteen assets take
/// about half of the time of a Hair for each asset (tests/bench); many heads of one asset take less in a Hair.
///
/// Each head has the same bits, in every step, as it has in a Hair of its asset alone that is told the same: whatever
/// else is there, comes and goes, on every instruction set, and in every order of jobs.
///
/// Allocates nothing: the caller gives memory once. Not thread safe but for run_job(). What Hair has and this has not:
/// kThesisSolver, characters, links, levels of detail and intervals, gusts, air of single heads, pushes, sets of
/// dynamics, settling, saved states, bone ends. It has no functions in C.
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

  /// Exact need of create(); zero bytes for a description that it refuses.
  [[nodiscard]] static MemoryNeed memory_need(const WorldDesc& desc);
  /// How much of WorldDesc::hair_bytes an asset takes with so many heads that share nothing with others; together they
  /// take less. 0 for an asset that is not open or a solver that a world does not know.
  [[nodiscard]] static std::size_t bytes_for(const Asset& asset, std::uint32_t heads,
                                             const Solver& solver = kCoifSolver);

  /// An empty world. `memory` must outlive this object. kBadArgument (desc), kMemoryTooSmall (or not aligned).
  Status create(const WorldDesc& desc, std::span<std::byte> memory);

  // These four may be called between any two steps. They cost microseconds (add_asset() some more, for each chain), and
  // change no bit of any other head's hair. Where they fail, all is as it was.

  /// The asset's bytes must stay for as long as it is here; the Asset itself need not. kAssetLacksData for one that is
  /// not open, kMemoryTooSmall where WorldDesc::assets are there or hair_bytes are used up.
  Status add_asset(const Asset& asset, WorldAsset& added);
  /// kBadArgument while heads of it are there; kBadIndex.
  Status remove_asset(WorldAsset asset);
  /// A head at `pose`, with its hair in the rest pose there, at rest. kBadIndex, kBadPose, kBadScale,
  /// kMemoryTooSmall.
  Status add_head(WorldAsset asset, const HeadPose& pose, WorldHead& added);
  Status remove_head(WorldHead head);  ///< kBadIndex.

  [[nodiscard]] bool has(WorldAsset asset) const;
  [[nodiscard]] bool has(WorldHead head) const;

  // As Hair's; kBadIndex for a head that is not there.
  Status set_head(WorldHead head, const HeadPose& pose);
  Status set_head(WorldHead head, const HeadPose& pose, const HeadVelocity& velocity);
  Status reset(WorldHead head, const HeadPose& pose);
  Status teleport(WorldHead head, const HeadPose& pose);
  [[nodiscard]] bool is_asleep(WorldHead head) const;

  /// As Hair's, for all heads of all assets. An asset's tuned sub-steps are its own.
  Status step(const StepSettings& settings);
  /// The same in parts, as Hair's. A job is some chains of any heads; what those have in common is computed by
  /// begin_step() and finish_step().
  Status begin_step(const StepSettings& settings);
  [[nodiscard]] std::uint32_t job_count() const;
  void run_job(std::uint32_t job);
  void finish_step();

  /// As Hair's, a matrix for each bone of the head's asset; at the same place until the head is removed. Empty for one
  /// that is not there.
  [[nodiscard]] std::span<const Mat34> palette(WorldHead head) const;

 private:
  WorldState* world_ = nullptr;  ///< In the caller's memory.
};

}  // namespace coif
