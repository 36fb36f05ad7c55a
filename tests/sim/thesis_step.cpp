#include "sim/thesis_step.h"

#include "sim/rows.h"
#include "sim/solver.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif {
namespace {

constexpr std::uint32_t kLane = 5;   // neither the first nor the last of any vector
constexpr std::uint32_t kInUse = 7;  // the others' particles are at the origin

/// The rows of an asset under the solver `thesis`, with room for one block of heads.
struct Rows {
  Rows(const Asset& asset, float dt) {
    const RowCount count = count_rows(asset, kThesisSolver, LaneOrder::kHeads);
    rows.resize(count.rows);
    bones.resize(count.bones);
    constants.resize(count.bones);
    coefficients.resize(count.bones);
    states.resize(count.bones);
    make_rows(asset, kThesisSolver, LaneOrder::kHeads, rows, bones, constants);
    for (const Row& row : rows) {
      for (std::uint32_t i = 0; i < row.bone_count; ++i) {
        const std::uint32_t bone = bone_in_lane(asset, row, i, 0);
        kThesisSolver.set_coefficients({.dt = dt, .scale = {}}, asset.dynamics()[bone], asset.bones()[bone].length,
                                       {&coefficients[row.first_bone + i], 0, kLanes});
      }
    }
  }

  std::vector<Row> rows;
  std::vector<RowBone> bones;
  std::vector<BoneLanes> constants;
  std::vector<ThesisCoefficients> coefficients;
  std::vector<ThesisState> states;
};

MoveLanes move_of(const ThesisStep& step) {
  MoveLanes move{};
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    set_lane(move.from_head.x, i, rotated(step.head_rotation, {1, 0, 0}));
    set_lane(move.from_head.y, i, rotated(step.head_rotation, {0, 1, 0}));
    set_lane(move.from_head.z, i, rotated(step.head_rotation, {0, 0, 1}));
    set_lane(move.way, i, step.head_displacement);
    set_lane(move.air, i, step.air_velocity);
    set_lane(move.gravity, i, step.gravity);
  }
  return move;
}

}  // namespace

ThesisStep::ThesisStep(const TestRig& rig) : palette(rig.bones.size()), rig_(rig) {
  for (const Vec3& end : rig.rest_ends()) particles.push_back({end, {}});
}

std::vector<Particle> ThesisStep::stepped(const Asset& asset, InstructionSet set) {
  Rows rows(asset, dt);
  const PlacedColliders colliders(asset.colliders());
  const MoveLanes move = move_of(*this);
  std::vector<Mat34> others(palette.size());
  std::vector<Particle> after(particles.size());
  for (const Row& row : rows.rows) {
    const std::uint32_t first = asset.chains()[row.first_chain].first_bone;
    ThesisState* const state = &rows.states[row.first_bone];
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      set_lane(state[i].position, kLane, particles[first + i - 1].position);
      set_lane(state[i].velocity, kLane, particles[first + i - 1].velocity);
    }
    Mat34* palettes[kLanes] = {};
    for (std::uint32_t i = 0; i < kInUse; ++i) palettes[i] = &(i == kLane ? palette : others)[first];
    Lanes motion{};
    RowStep job;
    job.bones = std::span(rows.bones).subspan(row.first_bone, row.bone_count);
    job.constants = &rows.constants[row.first_bone];
    job.coefficients = &rows.coefficients[row.first_bone];
    job.state = state;
    job.lanes = kInUse;
    job.move = &move;
    job.dt = dt;
    job.iterations = iterations;
    job.colliders = &colliders;
    job.palette = palettes;
    job.motion = &motion;
    thesis_row_code(set)(job);
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      after[first + i - 1] = {lane(state[i].position, kLane), lane(state[i].velocity, kLane)};
    }
  }
  return after;
}

void ThesisStep::run() {
  AlignedBytes file(write_asset(rig_.contents()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  const std::vector<Particle> expected = stepped(asset, plainest_set());
  const std::vector<Mat34> matrices = palette;
  for (const InstructionSet set : runnable_sets()) {
    const std::vector<Particle> found = stepped(asset, set);
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(Particle)), 0) << name_of(set);
    EXPECT_EQ(std::memcmp(palette.data(), matrices.data(), palette.size() * sizeof(Mat34)), 0) << name_of(set);
  }
  particles = expected;
}

}  // namespace coif
