#pragma once
// From the matrix of an engine's head bone to the pose of a head. A program that does not call this does not link it.

#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

namespace coif {

/// A bone's affine matrix for column vectors, three rows of four, row-major: p' = rows * (p, 1). Its columns are the
/// bone's three axes, each as long as the bone is scaled along it, and the bone's origin.
struct BoneMatrix {
  double m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
};

/// From a 4 x 4 matrix that is stored column after column, 16 numbers of which the last of each four are not read:
/// glTF, OpenGL, GLM, Eigen, Unity, three.js. Matrices for row vectors that are stored row after row (Unreal,
/// DirectXMath) are the same 16 numbers.
template <typename Number>
[[nodiscard]] constexpr BoneMatrix bone_matrix_of_columns(const Number* columns) {
  BoneMatrix matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix.m[row][column] = double(columns[4 * column + row]);
  }
  return matrix;
}

/// From a matrix for column vectors that is stored row after row: the 12 numbers of a 3 x 4 matrix, or the first 12 of
/// a 4 x 4 matrix.
template <typename Number>
[[nodiscard]] constexpr BoneMatrix bone_matrix_of_rows(const Number* rows) {
  BoneMatrix matrix;
  for (int i = 0; i < 12; ++i) matrix.m[i / 4][i % 4] = double(rows[i]);
  return matrix;
}

/// What stays the same while a head bone moves. The defaults are for a bone that has the axes of head space at rest, at
/// the head's joint, in a world of metres.
struct HeadBone {
  /// The bone's matrix in the rest (bind) pose, in the space of the model that the hair was made on: right-handed, +Y
  /// up, as the asset has it. It is the bone's world matrix while the model stands at the world's origin, unturned and
  /// in its own size. Scales of the rig belong to it: of a rig in centimetres under a scale of 0.01, the axes have a
  /// length of 0.01 here too. The translation is not used.
  ///
  /// An engine that has the inverse bind matrix calls invert(). In an engine with other axes (left-handed, or +Z up)
  /// the bone's matrices map to the engine's axes: multiply both from the left by the matrix from the engine's axes to
  /// those of the asset. The pose then has the asset's axes too. To simulate in the engine's own right-handed axes,
  /// multiply only `rest`.
  BoneMatrix rest = {};
  /// Where head space has its origin at rest, from the bone's own origin: metres, the model's axes. Zero if the asset
  /// was cooked with this bone as its head. If the hair was modelled in place but cooked without the bone:
  /// asset.skeleton().head_joint minus the bone's place at rest.
  double origin[3] = {0, 0, 0};
  double metres_per_unit = 1;  ///< The unit of the world's lengths: 0.01 for centimetres. Finite, above 0.
  /// How far the lengths of the head's axes may be from their mean, as a share of it, and their angles from right
  /// angles, in radians: engines' rounding and a little more. 0 or more; infinity takes every matrix that has a volume.
  double largest_stretch = 0.01;
};

/// Computes the pose of a head that follows a bone, so that hair that was modelled around the head at rest sits on it.
/// `bone` is the bone's world matrix now. With T = bone * inverse(rest), which maps the model at rest to the world:
///
///   rotation  the rotation that is nearest to T, unit, w >= 0
///   scale     the mean (root mean square) length of T's three axes, so 1 at rest
///   position  metres_per_unit * bone's origin + rotation (scale * origin)
///
/// A mirrored head has no rotation. T mirrors if exactly one of `bone` and `rest` does, for example below a node with a
/// scale of -1. Then T's first axis and the x of `origin`, the head's left and right, count reversed: the head's top
/// (+Y), its face (+Z) and its place are exact, and the hair sits on it as it was modelled, not mirrored. Simulated
/// bones cannot be mirrored, and an error would leave the hair behind in the air. is_mirrored() tells.
///
/// Errors leave `pose` as it was; numbers beyond 1e30 count as infinite. kBadArgument: a number of `head_bone` is not
/// finite or out of its range, or `rest` has no inverse. kBadPose: `bone` has a NaN or an infinity, or T is sheared or
/// stretched by more than largest_stretch, or flat. kBadScale: the scale is outside kSmallestScale..kLargestScale; a
/// scale of 0.01 or 100 is that of a rig whose unit `rest` lacks. Allocates nothing.
COIF_API Status head_pose_of_bone(const BoneMatrix& bone, const HeadBone& head_bone, HeadPose& pose);

/// Whether the head is a mirror image of the one at rest. False where a matrix is not finite or flat.
[[nodiscard]] COIF_API bool is_mirrored(const BoneMatrix& bone, const HeadBone& head_bone);

/// The inverse, for engines that have inverse bind matrices. kBadArgument, with `inverse` as it was, for a matrix that
/// is not finite or has none, because its axes lie in one plane or an axis is shorter than 1e-30.
COIF_API Status invert(const BoneMatrix& matrix, BoneMatrix& inverse);

}  // namespace coif
