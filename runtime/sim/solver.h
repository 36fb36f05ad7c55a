#pragma once
// The differences between solvers, behind function pointers, so that a program links only the solvers that it names.

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
  PoseLanes* poses = nullptr;            ///< Per bone; null where no poses are followed.
  std::uint32_t constant_lane = 0;
  std::uint32_t state_lane = 0;
};

/// The values besides the bone's that a step's coefficients depend on.
struct StepTerms {
  float dt = 0;  ///< One sub-step, seconds.
  DynamicsScale scale;
};

/// Lanes `begin`..`end` - 1 of a bone of a row. All have the same bone of the asset or bones with equal coefficients.
struct CoefficientLanes {
  void* coefficients = nullptr;
  std::uint32_t begin = 0, end = 0;
};

inline void fill(const CoefficientLanes& to, Lanes& lanes, double value) {
  for (std::uint32_t i = to.begin; i < to.end; ++i) lanes.v[i] = float(value);
}

struct Block;
struct BlockStep;
struct Crowd;
struct RowCharacter;
struct RowHeads;
struct WornAsset;
struct WorldState;
class MemoryCarver;
class SavedLane;

/// The code for hair on a character, behind pointers, so that programs that name no such solver do not link it.
struct CharacterCode {
  /// Finds the ways of the colliders of a block's heads in this step. Runs before its bones move.
  void (*begin)(WorldState& world, BlockStep& step) = nullptr;
  /// Puts the bounds of those ways side by side.
  void (*gather)(const WorldState& world, RowHeads& heads) = nullptr;
  /// Adds the air around each head during a part of the step to `move`.
  void (*blow)(const WorldState& world, const RowHeads& heads, const StepParts& parts, std::uint32_t part,
               MoveLanes& move) = nullptr;
  /// Prepares that part for rows of these heads' chains.
  void (*set_up)(const WorldState& world, const RowHeads& heads, const StepParts& parts, std::uint32_t part,
                 RowCharacter& character) = nullptr;
  /// The next step begins with the poses that were reached.
  void (*finish)(WorldState& world, const Block& block) = nullptr;
  /// Sets poses that add nothing: the rest pose.
  void (*set_rest_poses)(const ChainLane& chain) = nullptr;
  /// Moves colliders and pose of a head to where it appears, without a way there.
  void (*appear)(WorldState& world, std::uint32_t head) = nullptr;
};

extern const CharacterCode kCharacterCode;

struct Solver {
  /// Set in solvers that only choose one by the chain's model; the members below are then unused.
  const Solver* (*for_model)(ChainModel model) = nullptr;

  /// Per bone of a row. A bone's state begins with its direction or its particle's place: see keeps_places.
  std::size_t state_bytes = 0;
  bool keeps_places = false;          ///< A bone's state begins with its particle's place instead of its direction.
  std::size_t velocity_at = 0;        ///< Byte offset of the particle's velocity in the state.
  std::size_t coefficient_bytes = 0;  ///< Per bone of a row.
  std::size_t scratch_bytes = 0;      ///< Per block, for each bone of the longest row that needs scratch.
  std::uint32_t scratch_from = 0;     ///< Rows with more bones than this need scratch.
  bool carries_frames = false;        ///< Bones may twist.
  bool has_substeps = false;
  bool may_be_uneven = false;                ///< Its rows may have chains of different lengths: see kRowEnds.
  const CharacterCode* character = nullptr;  ///< Null: not for hair on a character.
  bool reads_asked = false;                  ///< Uses the artist's own friction (Asset::asked()).

  RowFunction* (*row_code)(InstructionSet set) = nullptr;
  /// Fills the part of a row's constants in one lane that only this solver needs; null: nothing.
  void (*complete_lane)(std::span<const RowBone> bones, std::uint32_t lane, BoneLanes* constants) = nullptr;
  void (*set_coefficients)(const StepTerms& terms, const DynamicsRecord& dynamics, float length,
                           const CoefficientLanes& to) = nullptr;
  /// Sets the rest pose under a head with this rotation, at rest.
  void (*put_to_rest)(const ChainLane& chain, const Quat& head_rotation) = nullptr;
  /// Turns all values that are kept in world axes.
  void (*turn)(const ChainLane& chain, const Quat& by) = nullptr;
  /// Removes all motion; the shape stays.
  void (*calm)(const ChainLane& chain) = nullptr;
  /// False for values that no bone's state can have. In the lane each bone's state begins at byte `at` of its Lanes;
  /// all numbers are finite.
  bool (*could_be)(const SavedLane& lane, std::size_t at) = nullptr;
  /// The bones' tails, head space, metres, one per bone of the chain. `palette` has the chain's matrices.
  void (*tails)(const ChainLane& chain, const Quat& head_rotation, std::span<const Mat34> palette,
                std::span<Vec3> tails) = nullptr;
};

/// The solver that moves this chain.
[[nodiscard]] inline const Solver& solver_for(const Solver& asked, const ChainRecord& chain) {
  return asked.for_model != nullptr ? *asked.for_model(chain.model) : asked;
}

/// Solver::tails for solvers without stretch: the matrix applied to the rest pose's tail.
void tails_of_palette(const ChainLane& chain, const Quat& head_rotation, std::span<const Mat34> palette,
                      std::span<Vec3> tails);

/// The response of a damped oscillator with a moving target within one step. Exact for a target that moves on a cubic
/// in time and a constant load (runtime/docs/MODEL.md, "The step").
struct PoseResponse {
  double offset_from_offset;      ///< 1
  double offset_from_velocity;    ///< s; also the velocity from a constant load.
  double offset_from_load;        ///< s^2
  double offset_from_bend;        ///< 1
  double velocity_from_offset;    ///< 1/s
  double velocity_from_velocity;  ///< 1
  double velocity_from_bend;      ///< 1/s
  /// 1/s: the velocity that a constant force leaves which moves the particle by 1 m; at most 2/dt.
  double velocity_per_offset;
};

/// `stiffness` 1/s^2, `damping` 1/s, both >= 0; `dt` seconds, > 0.
[[nodiscard]] PoseResponse pose_response(double stiffness, double damping, double dt);

}  // namespace coif
