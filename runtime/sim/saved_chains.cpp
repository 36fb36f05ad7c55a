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
  const bool is_square = is_unit_direction(column[0]) && is_unit_direction(column[1]) &&
                         std::fabs(dot(column[0], column[1])) <= kSavedUnitTolerance &&
                         length(cross(column[0], column[1]) - column[2]) <= 4 * kSavedUnitTolerance;
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

/// Checks a lane of a row: its bones' states one after the other, and the padding of rows whose solver needs less.
bool are_states(const CrowdState& crowd, const Row& row, const SavedLane& lane) {
  const std::size_t own = row.bone_count * row.solver->state_bytes, all = row.bone_count * crowd.state_bytes;
  if (!lane.are_finite(0, own) || !lane.are_zero(own, all - own)) return false;
  for (std::uint32_t i = 0; i < row.bone_count; ++i) {
    if (!row.solver->could_be(lane, i * row.solver->state_bytes)) return false;
  }
  return true;
}

bool are_twists(const Row& row, const SavedLane& lane) {
  if (!row.solver->carries_frames) return lane.are_zero(0, row.bone_count * sizeof(TwistState));
  for (std::uint32_t i = 0; i < row.bone_count; ++i) {
    const std::size_t at = i * sizeof(TwistState);
    const float cosine = lane.number(at + offsetof(TwistState, cosine)),
                sine = lane.number(at + offsetof(TwistState, sine));
    if (!is_unit_direction(lane.vector(at + offsetof(TwistState, before)))) return false;
    if (!is_unit_direction({cosine, sine, 0})) return false;
  }
  return true;
}

}  // namespace

float farthest_bone_start(const CrowdState& crowd) {
  float most = 0, lengths = 0;
  for (const BoneRecord& bone : crowd.asset.bones()) {
    const float joint = length(to_vec3(bone.joint));
    most = joint > most ? joint : most;
    lengths += bone.length;
  }
  bool keeps_places = false;
  for (const Row& row : crowd.rows) keeps_places = keeps_places || row.solver->keeps_places;
  return keeps_places ? std::numeric_limits<float>::max() : 1.01f * (most + lengths) + 1e-3f;
}

bool is_saved_palette(const CrowdState& crowd, float farthest, SavedBytes& bytes) {
  for (const BoneRecord& bone : crowd.asset.bones()) {
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

bool are_saved_chains(const CrowdState& crowd, bool is_posed, SavedBytes& bytes) {
  for (const Row& row : crowd.rows) {
    const std::uint32_t lanes = crowd.order == LaneOrder::kHeads ? 1 : row.chain_count;
    for (std::uint32_t k = 0; k < lanes; ++k) {
      if (!are_states(crowd, row, bytes.take_lane(row.bone_count * crowd.state_bytes))) return false;
      if (!crowd.character.poses.empty()) {
        const SavedLane pose = bytes.take_lane(row.bone_count * sizeof(PoseLanes));
        for (std::uint32_t i = 0; i < row.bone_count; ++i) {
          const std::size_t at = i * sizeof(PoseLanes);
          const Vec3 pull = lane(crowd.constants[row.first_bone + i].pull, k);
          if (!(is_posed ? is_followed_pose(pose, at) : is_rest_pose(pose, at, pull))) return false;
        }
      }
      if (crowd.twists.empty()) continue;
      if (!are_twists(row, bytes.take_lane(row.bone_count * sizeof(TwistState)))) return false;
    }
  }
  return true;
}

}  // namespace coif
