#include "saved_lane.h"

#include "vector_math.h"

#include <cmath>
#include <limits>

namespace coif {
namespace {

/// A rotation and a translation: the columns have length one and are perpendicular.
bool is_rigid(const Mat34& matrix) {
  Vec3 column[3];
  for (int k = 0; k < 3; ++k) column[k] = {matrix.m[0][k], matrix.m[1][k], matrix.m[2][k]};
  constexpr float kOff = kSavedFrameTolerance;
  const bool is_square = is_unit_direction(column[0], kOff) && is_unit_direction(column[1], kOff) &&
                         std::fabs(dot(column[0], column[1])) <= kOff &&
                         length(cross(column[0], column[1]) - column[2]) <= 4 * kOff;
  return is_square && is_finite(Vec3{matrix.m[0][3], matrix.m[1][3], matrix.m[2][3]});
}

bool is_rest_pose(const SavedLane& pose, std::size_t at, const Vec3& pull) {
  const Quat none, before = pose.quaternion(at + offsetof(PoseLanes, before)),
                   now = pose.quaternion(at + offsetof(PoseLanes, now));
  return same_bits(&before, &none, sizeof none) && same_bits(&now, &none, sizeof none) &&
         pose.vector(at + offsetof(PoseLanes, pull_before)) == pull &&
         pose.vector(at + offsetof(PoseLanes, pull_now)) == pull &&
         pose.number(at + offsetof(PoseLanes, weight)) == 1.0f;
}

bool is_followed_pose(const SavedLane& pose, std::size_t at) {
  return is_unit(pose.quaternion(at + offsetof(PoseLanes, before))) &&
         is_unit(pose.quaternion(at + offsetof(PoseLanes, now))) &&
         is_unit_direction(pose.vector(at + offsetof(PoseLanes, pull_before))) &&
         is_unit_direction(pose.vector(at + offsetof(PoseLanes, pull_now))) &&
         is_share(pose.number(at + offsetof(PoseLanes, weight)));
}

bool are_states(const Solver& solver, std::uint32_t bones, const SavedLane& lane) {
  if (!lane.are_finite(0, bones * solver.state_bytes)) return false;
  for (std::uint32_t i = 0; i < bones; ++i) {
    if (!solver.could_be(lane, i * solver.state_bytes)) return false;
  }
  return true;
}

bool are_poses(const ChainLane& chain, std::uint32_t bones, bool is_posed, const SavedLane& lane) {
  for (std::uint32_t i = 0; i < bones; ++i) {
    const std::size_t at = i * sizeof(PoseLanes);
    const Vec3 pull = coif::lane(chain.constants[i].pull, chain.constant_lane);
    if (!(is_posed ? is_followed_pose(lane, at) : is_rest_pose(lane, at, pull))) return false;
  }
  return true;
}

bool are_twists(std::uint32_t bones, const SavedLane& lane) {
  for (std::uint32_t i = 0; i < bones; ++i) {
    const std::size_t at = i * sizeof(TwistState);
    const float cosine = lane.number(at + offsetof(TwistState, cosine)),
                sine = lane.number(at + offsetof(TwistState, sine));
    if (!is_unit_direction(lane.vector(at + offsetof(TwistState, before)), kSavedFrameTolerance)) return false;
    if (!is_unit_direction({cosine, sine, 0})) return false;
  }
  return true;
}

}  // namespace

float farthest_bone_start(const WorldRules& rules, const Asset& asset) {
  float most = 0, lengths = 0;
  for (const BoneRecord& bone : asset.bones()) {
    const float joint = length(to_vec3(bone.joint));
    most = joint > most ? joint : most;
    lengths += bone.length;
  }
  return rules.solver->keeps_places ? std::numeric_limits<float>::max() : 1.01f * (most + lengths) + 1e-3f;
}

bool is_saved_palette(const Asset& asset, float farthest, SavedBytes& bytes) {
  for (const BoneRecord& bone : asset.bones()) {
    const auto matrix = bytes.take<Mat34>();
    if (!is_rigid(matrix)) return false;
    Vec3 start;
    float* const to[3] = {&start.x, &start.y, &start.z};
    for (int row = 0; row < 3; ++row) {
      const Vec3 turn{matrix.m[row][0], matrix.m[row][1], matrix.m[row][2]};
      *to[row] = dot(turn, to_vec3(bone.joint)) + matrix.m[row][3];
    }
    if (!(length(start) <= farthest)) return false;
  }
  return true;
}

bool are_saved_chains(WorldState& world, std::uint32_t head, bool is_posed, SavedBytes& bytes) {
  const auto chains = world.worn_by(world.heads[head]).asset.chains();
  bool are_good = true;
  for_each_chain(world, head, [&](const Solver& solver, std::uint32_t c, const ChainLane& chain) {
    if (!are_good) return;
    const std::uint32_t bones = chains[c].bone_count;
    are_good = are_states(solver, bones, bytes.take_lane(bones * solver.state_bytes));
    if (are_good && chain.poses != nullptr) {
      are_good = are_poses(chain, bones, is_posed, bytes.take_lane(bones * sizeof(PoseLanes)));
    }
    if (are_good && chain.twist != nullptr) are_good = are_twists(bones, bytes.take_lane(bones * sizeof(TwistState)));
  });
  return are_good;
}

}  // namespace coif
