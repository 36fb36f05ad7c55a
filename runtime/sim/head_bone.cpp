#include <coif/head_bone.h>

#include <cmath>

namespace coif {
namespace {

constexpr double kLargest = 1e30, kShortestAxis = 1e-30;  ///< Products of three neither overflow nor vanish.
constexpr double kFlat = 1e-6;  ///< The volume of three axes that counts as none, as a share of their lengths' product.

/// The axes of a matrix: its columns.
struct Axes {
  double m[3][3];

  [[nodiscard]] double length(int column) const {
    return std::sqrt(m[0][column] * m[0][column] + m[1][column] * m[1][column] + m[2][column] * m[2][column]);
  }
};

Axes axes_of(const BoneMatrix& matrix) {
  Axes axes;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) axes.m[i][k] = matrix.m[i][k];
  }
  return axes;
}

/// False for NaN, which is compared only in ways that do not trap.
bool is_usual(double number) { return std::islessequal(std::fabs(number), kLargest); }

bool is_usual(const BoneMatrix& matrix) {
  for (const auto& row : matrix.m) {
    for (const double number : row) {
      if (!is_usual(number)) return false;
    }
  }
  return true;
}

/// The transposed inverse times the determinant.
Axes cofactors(const Axes& a) {
  Axes c;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int k = 0; k < 3; ++k) {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      c.m[i][k] = a.m[i1][k1] * a.m[i2][k2] - a.m[i1][k2] * a.m[i2][k1];
    }
  }
  return c;
}

double determinant(const Axes& a, const Axes& its_cofactors) {
  return a.m[0][0] * its_cofactors.m[0][0] + a.m[0][1] * its_cofactors.m[0][1] + a.m[0][2] * its_cofactors.m[0][2];
}

double determinant(const Axes& a) { return determinant(a, cofactors(a)); }

/// The axes have lengths and a volume that can be divided by.
bool has_inverse(const Axes& axes) {
  double box = 1;
  for (int k = 0; k < 3; ++k) {
    const double length = axes.length(k);
    if (!(length >= kShortestAxis)) return false;
    box *= length;
  }
  return std::fabs(determinant(axes)) > kFlat * box;
}

Axes inverse_of(const Axes& axes) {
  const Axes c = cofactors(axes);
  const double scale = 1 / determinant(axes, c);
  Axes inverse;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) inverse.m[i][k] = scale * c.m[k][i];
  }
  return inverse;
}

Axes product(const Axes& a, const Axes& b) {
  Axes c;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) c.m[i][k] = a.m[i][0] * b.m[0][k] + a.m[i][1] * b.m[1][k] + a.m[i][2] * b.m[2][k];
  }
  return c;
}

bool is_valid(const HeadBone& head_bone) {
  const double(&origin)[3] = head_bone.origin;
  return is_usual(head_bone.rest) && has_inverse(axes_of(head_bone.rest)) && is_usual(origin[0]) &&
         is_usual(origin[1]) && is_usual(origin[2]) && is_usual(head_bone.metres_per_unit) &&
         head_bone.metres_per_unit > 0 && std::isgreaterequal(head_bone.largest_stretch, 0.0);
}

double mean_length(const Axes& axes) {
  double square = 0;
  for (int k = 0; k < 3; ++k) square += axes.length(k) * axes.length(k);
  return std::sqrt(square / 3);
}

/// The axes are of equal length, 1, and at right angles.
bool is_even(const Axes& axes, double tolerance) {
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const double length = axes.length(k), other = axes.length(next);
    double product = 0;
    for (int i = 0; i < 3; ++i) product += axes.m[i][k] * axes.m[i][next];
    if (std::fabs(length - 1) > tolerance || std::fabs(product) > tolerance * length * other) return false;
  }
  return true;
}

/// The nearest rotation to axes with a positive volume, their polar factor, by Newton's method (Higham 1986): each
/// round takes the mean with the transposed inverse. Axes that are nearly a rotation take three rounds, those that are
/// flat by a factor of a million some 25.
Axes nearest_rotation(Axes a) {
  constexpr int kMostRounds = 60;
  for (int round = 0; round < kMostRounds; ++round) {
    const Axes c = cofactors(a);
    const double scale = 1 / determinant(a, c);
    double change = 0;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const double next = 0.5 * (a.m[i][k] + scale * c.m[i][k]);
        const double step = std::fabs(next - a.m[i][k]);
        change = step > change ? step : change;
        a.m[i][k] = next;
      }
    }
    if (change < 1e-14) break;
  }
  return a;
}

/// Unit, w >= 0. Starts from the largest of the four components, from which the others follow without cancellation.
Quat quaternion_of(const Axes& a) {
  double q[4];  // x, y, z, w
  const double trace = a.m[0][0] + a.m[1][1] + a.m[2][2];
  int i = a.m[1][1] > a.m[0][0] ? 1 : 0;
  if (a.m[2][2] > a.m[i][i]) i = 2;
  const int k = (i + 1) % 3, l = (i + 2) % 3;
  if (trace > a.m[i][i]) {
    for (int n = 0; n < 3; ++n) q[n] = a.m[(n + 2) % 3][(n + 1) % 3] - a.m[(n + 1) % 3][(n + 2) % 3];
    q[3] = 1 + trace;
  } else {
    q[i] = 1 + a.m[i][i] - a.m[k][k] - a.m[l][l];
    q[k] = a.m[k][i] + a.m[i][k];
    q[l] = a.m[l][i] + a.m[i][l];
    q[3] = a.m[l][k] - a.m[k][l];
  }
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double by = q[3] < 0 ? -1 / length : 1 / length;
  return {float(q[0] * by), float(q[1] * by), float(q[2] * by), float(q[3] * by)};
}

}  // namespace

Status head_pose_of_bone(const BoneMatrix& bone, const HeadBone& head_bone, HeadPose& pose) {
  if (!is_valid(head_bone)) return Status::kBadArgument;
  if (!is_usual(bone)) return Status::kBadPose;
  Axes turn = product(axes_of(bone), inverse_of(axes_of(head_bone.rest)));
  const double scale = mean_length(turn);
  const auto in_float = static_cast<float>(scale < 1e6 ? scale : 1e6);  // far above the largest, and no overflow
  if (!(in_float >= kSmallestScale && in_float <= kLargestScale)) return Status::kBadScale;
  const double side = determinant(turn) < 0 ? -1 : 1;
  for (auto& row : turn.m) {
    row[0] *= side / scale;
    row[1] /= scale;
    row[2] /= scale;
  }
  if (!(determinant(turn) > kFlat && is_even(turn, head_bone.largest_stretch))) return Status::kBadPose;
  turn = nearest_rotation(turn);

  HeadPose found;
  for (int i = 0; i < 3; ++i) {
    double offset = 0;
    for (int k = 0; k < 3; ++k) offset += turn.m[i][k] * head_bone.origin[k] * (k == 0 ? side : 1);
    found.position[i] = head_bone.metres_per_unit * bone.m[i][3] + scale * offset;
  }
  found.rotation = quaternion_of(turn);
  found.scale = in_float;
  pose = found;
  return Status::kOk;
}

bool is_mirrored(const BoneMatrix& bone, const HeadBone& head_bone) {
  const Axes now = axes_of(bone), rest = axes_of(head_bone.rest);
  if (!is_usual(bone) || !is_usual(head_bone.rest) || !has_inverse(now) || !has_inverse(rest)) return false;
  return (determinant(now) < 0) != (determinant(rest) < 0);
}

Status invert(const BoneMatrix& matrix, BoneMatrix& inverse) {
  if (!is_usual(matrix) || !has_inverse(axes_of(matrix))) return Status::kBadArgument;
  const Axes axes = inverse_of(axes_of(matrix));
  BoneMatrix found;
  for (int i = 0; i < 3; ++i) {
    found.m[i][3] = 0;
    for (int k = 0; k < 3; ++k) {
      found.m[i][k] = axes.m[i][k];
      found.m[i][3] -= axes.m[i][k] * matrix.m[k][3];
    }
  }
  inverse = found;
  return Status::kOk;
}

}  // namespace coif
