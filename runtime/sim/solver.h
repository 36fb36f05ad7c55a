#pragma once
// What distinguishes the solvers, behind functions, so that a program holds only those that it names.

#include "lanes/lane_code.h"
#include "rows.h"

#include <coif/hair.h>

#include <cstddef>
#include <span>

namespace coif {

/// One chain on one head: a lane of a row.
struct ChainLane {
  std::span<const RowBone> bones;
  const BoneLanes* constants = nullptr;  ///< Per bone.
  void* state = nullptr;                 ///< Per bone, of the solver's own type.
  TwistState* twist = nullptr;           ///< Per bone; null where nothing twists.
  std::uint32_t constant_lane = 0;
  std::uint32_t state_lane = 0;
};

/// What a step's coefficients depend on besides the bone.
struct StepTerms {
  float dt = 0;  ///< Of one sub-step, seconds.
  DynamicsScale scale;
};

/// Lanes `begin`..`end` - 1 of a bone of a row, all for the same bone of the asset or at least one that moves alike.
struct CoefficientLanes {
  void* coefficients = nullptr;
  std::uint32_t begin = 0, end = 0;
};

inline void fill(const CoefficientLanes& to, Lanes& lanes, double value) {
  for (std::uint32_t i = to.begin; i < to.end; ++i) lanes.v[i] = float(value);
}

struct CharacterState;
struct CrowdState;
struct HeadStepLanes;
struct RowCharacter;
class MemoryCarver;
class SavedLane;

/// What is done for hair on a character; behind pointers, so that programs that name no such solver hold nothing of it.
struct CharacterCode {
  /// Takes the arrays; `states` as CrowdState::states has bones.
  void (*carve)(MemoryCarver& carver, const Asset& asset, const HairDesc& desc, std::uint64_t states,
                std::uint32_t blocks, CharacterState& character) = nullptr;
  /// Fills them.
  void (*create)(CrowdState& crowd) = nullptr;
  /// Once per step that takes `dt` seconds.
  void (*pass_time)(CrowdState& crowd, float dt) = nullptr;
  /// Before a block's bones move: `put` has a bit for each head that was put somewhere.
  void (*begin)(CrowdState& crowd, std::uint32_t block, const HeadStepLanes& step, std::uint16_t put,
                const StepParts& parts) = nullptr;
  /// Of one part of the step, for the rows of the block, or of the head in its lane `only_head` where that is not -1.
  void (*set_up)(const CrowdState& crowd, std::uint32_t block, std::int32_t only_head,
                 RowCharacter& character) = nullptr;
  /// For one of those rows then. `state` is where its numbers begin, in bones.
  void (*enter_row)(const CrowdState& crowd, const Row& row, std::size_t state, RowCharacter& character) = nullptr;
  /// Before part `part` of the step: what the air around each head of the block adds to `move`.
  void (*blow)(CrowdState& crowd, std::uint32_t block, const StepParts& parts, std::uint32_t part,
               MoveLanes& move) = nullptr;
  void (*finish)(CrowdState& crowd, std::uint32_t block) = nullptr;
  /// The head of `slot` is where it is without having got there: nor have its colliders and its pose.
  void (*appear)(CrowdState& crowd, std::uint32_t slot) = nullptr;
};

extern const CharacterCode kCharacterCode;

struct Solver {
  /// Set where each chain says which solver moves it; then nothing else is.
  const Solver* (*for_model)(ChainModel model) = nullptr;

  std::size_t state_bytes = 0;        ///< Per bone of a row. A bone's state begins with its direction, or
  bool keeps_places = false;          ///< with its particle's place.
  std::size_t velocity_at = 0;        ///< Byte of the state at which its particle's velocity begins.
  std::size_t coefficient_bytes = 0;  ///< Per bone of a row.
  std::size_t scratch_bytes = 0;      ///< Per bone of the longest row, for each block,
  std::uint32_t scratch_from = 0;     ///< if that has more bones than this.
  bool carries_frames = false;        ///< Bones may twist.
  bool has_substeps = false;
  bool may_be_uneven = false;                ///< Its rows may have chains of unlike length: see kRowEnds.
  const CharacterCode* character = nullptr;  ///< Null: not for hair on a character.
  bool reads_asked = false;  ///< Friction as the artist asked for, whatever the chain was given to have one motion.

  RowFunction* (*row_code)(InstructionSet set) = nullptr;
  /// Fills what only this solver asks of a lane of a row's constants; null: nothing.
  void (*complete_lane)(std::span<const RowBone> bones, std::uint32_t lane, BoneLanes* constants) = nullptr;
  void (*set_coefficients)(const StepTerms& terms, const DynamicsRecord& dynamics, float length,
                           const CoefficientLanes& to) = nullptr;
  /// The rest pose under a head with this rotation, at rest.
  void (*put_to_rest)(const ChainLane& chain, const Quat& head_rotation) = nullptr;
  /// Turns everything that is kept in world axes.
  void (*turn)(const ChainLane& chain, const Quat& by) = nullptr;
  /// Takes all motion out; the shape stays.
  void (*calm)(const ChainLane& chain) = nullptr;
  /// False for what no bone's state can be, of a lane in which each bone's begins at byte `at` of its Lanes; all
  /// numbers are finite.
  bool (*could_be)(const SavedLane& lane, std::size_t at) = nullptr;
  /// The bones' tails, head space, metres; as many as the chain has bones. `palette` are the chain's matrices.
  void (*tails)(const ChainLane& chain, const Quat& head_rotation, std::span<const Mat34> palette,
                std::span<Vec3> tails) = nullptr;
};

/// The one that moves this chain.
[[nodiscard]] inline const Solver& solver_for(const Solver& asked, const ChainRecord& chain) {
  return asked.for_model != nullptr ? *asked.for_model(chain.model) : asked;
}

/// Solver::tails where nothing stretches: where a matrix brings the tail of the rest pose.
void tails_of_palette(const ChainLane& chain, const Quat& head_rotation, std::span<const Mat34> palette,
                      std::span<Vec3> tails);

/// How a damped oscillator with a moving target answers within one step: exact for a target that moves on a cubic in
/// time and a constant load (runtime/docs/MODEL.md, "The step").
struct PoseResponse {
  double offset_from_offset;      ///< 1
  double offset_from_velocity;    ///< s; also the velocity from a constant load.
  double offset_from_load;        ///< s^2
  double offset_from_bend;        ///< 1
  double velocity_from_offset;    ///< 1/s
  double velocity_from_velocity;  ///< 1
  double velocity_from_bend;      ///< 1/s
  /// 1/s: what a constant force that moves the particle by 1 m leaves behind; within 2/dt.
  double velocity_per_offset;
};

/// `stiffness` 1/s^2, `damping` 1/s, both >= 0; `dt` seconds, > 0.
[[nodiscard]] PoseResponse pose_response(double stiffness, double damping, double dt);

}  // namespace coif
