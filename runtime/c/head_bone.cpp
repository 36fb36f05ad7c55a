// Poses of heads that follow an engine's bones, in C.
#include "asset_view.h"

#include <coif/head_bone.h>

namespace {

COIF_SAME(coif_bone_matrix, m, coif::BoneMatrix, m);
COIF_SAME(coif_head_bone, rest, coif::HeadBone, rest);
COIF_SAME(coif_head_bone, origin, coif::HeadBone, origin);
COIF_SAME(coif_head_bone, metres_per_unit, coif::HeadBone, metres_per_unit);
COIF_SAME(coif_head_bone, largest_stretch, coif::HeadBone, largest_stretch);

using coif::c::code;
using coif::c::copied;

coif::BoneMatrix matrix_of(const coif_bone_matrix& from) { return copied<coif::BoneMatrix>(from); }

coif::HeadBone head_bone_of(const coif_head_bone& from) { return copied<coif::HeadBone>(from); }

}  // namespace

extern "C" {

void coif_head_bone_init(coif_head_bone* head_bone) {
  if (head_bone != nullptr) *head_bone = copied<coif_head_bone>(coif::HeadBone{});
}

void coif_bone_matrix_of_columns(coif_bone_matrix* matrix, const float columns[16]) {
  if (matrix == nullptr || columns == nullptr) return;
  *matrix = copied<coif_bone_matrix>(coif::bone_matrix_of_columns(columns));
}

void coif_bone_matrix_of_rows(coif_bone_matrix* matrix, const float rows[12]) {
  if (matrix == nullptr || rows == nullptr) return;
  *matrix = copied<coif_bone_matrix>(coif::bone_matrix_of_rows(rows));
}

coif_status coif_head_pose_of_bone(const coif_bone_matrix* bone, const coif_head_bone* head_bone,
                                   coif_head_pose* pose) {
  if (bone == nullptr || head_bone == nullptr || pose == nullptr) return COIF_BAD_ARGUMENT;
  coif::HeadPose found;
  const coif::Status status = coif::head_pose_of_bone(matrix_of(*bone), head_bone_of(*head_bone), found);
  if (status == coif::Status::kOk) *pose = copied<coif_head_pose>(found);
  return code(status);
}

int coif_bone_is_mirrored(const coif_bone_matrix* bone, const coif_head_bone* head_bone) {
  if (bone == nullptr || head_bone == nullptr) return 0;
  return coif::is_mirrored(matrix_of(*bone), head_bone_of(*head_bone)) ? 1 : 0;
}

coif_status coif_invert_bone_matrix(const coif_bone_matrix* matrix, coif_bone_matrix* inverse) {
  if (matrix == nullptr || inverse == nullptr) return COIF_BAD_ARGUMENT;
  coif::BoneMatrix found;
  const coif::Status status = coif::invert(matrix_of(*matrix), found);
  if (status == coif::Status::kOk) *inverse = copied<coif_bone_matrix>(found);
  return code(status);
}

}  // extern "C"
