#include <coif/bone_transforms.h>

#include <cmath>
#include <cstddef>

namespace coif {
namespace {

// Computed in double: a host that composes long chains adds up the rounding errors of each bone.
struct Turn {
  double x, y, z, w;
};

struct Frame {
  double origin[3];
  Turn turn;
};

Turn unit(const Turn& q) {
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const double by = q.w < 0 ? -1 / length : 1 / length;
  return {q.x * by, q.y * by, q.z * by, q.w * by};
}

/// Starts from the largest of the four components; the others follow without cancellation (Shepperd 1978).
Turn turn_of(const Mat34& matrix) {
  const auto m = [&](int row, int column) { return double(matrix.m[row][column]); };
  const double xx = m(0, 0), yy = m(1, 1), zz = m(2, 2), trace = xx + yy + zz;
  if (trace >= xx && trace >= yy && trace >= zz) {
    return unit({m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1), 1 + trace});
  }
  if (xx >= yy && xx >= zz) {
    return unit({1 + xx - yy - zz, m(0, 1) + m(1, 0), m(0, 2) + m(2, 0), m(2, 1) - m(1, 2)});
  }
  if (yy >= zz) return unit({m(0, 1) + m(1, 0), 1 + yy - xx - zz, m(1, 2) + m(2, 1), m(0, 2) - m(2, 0)});
  return unit({m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), 1 + zz - xx - yy, m(1, 0) - m(0, 1)});
}

/// A bone's own frame in head space. At rest it stands at the joint with the axes of head space.
Frame frame_of(const BoneRecord& bone, const Mat34& matrix) {
  Frame frame{{}, turn_of(matrix)};
  for (int i = 0; i < 3; ++i) {
    const float(&row)[4] = matrix.m[i];
    frame.origin[i] = double(row[3]);
    for (int k = 0; k < 3; ++k) frame.origin[i] += double(row[k]) * double(bone.joint[k]);
  }
  return frame;
}

/// The inverse of `a` times `b`.
Turn between(const Turn& a, const Turn& b) {
  return unit({a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y, a.w * b.y - a.y * b.w - a.z * b.x + a.x * b.z,
               a.w * b.z - a.z * b.w - a.x * b.y + a.y * b.x, a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z});
}

Vec3 turned_back(const Turn& q, const double (&v)[3]) {
  const double t[3] = {2 * (v[1] * q.z - v[2] * q.y), 2 * (v[2] * q.x - v[0] * q.z), 2 * (v[0] * q.y - v[1] * q.x)};
  return {static_cast<float>(v[0] + q.w * t[0] + t[1] * q.z - t[2] * q.y),
          static_cast<float>(v[1] + q.w * t[1] + t[2] * q.x - t[0] * q.z),
          static_cast<float>(v[2] + q.w * t[2] + t[0] * q.y - t[1] * q.x)};
}

}  // namespace

Status bone_transforms(const Asset& asset, std::span<const Mat34> palette, std::span<BoneTransform> transforms) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  const std::span<const BoneRecord> bones = asset.bones();
  if (palette.size() != bones.size() || transforms.size() != bones.size()) return Status::kSizeMismatch;
  for (std::size_t b = 0; b < bones.size(); ++b) {
    const std::uint32_t parent = bones[b].parent;
    constexpr Frame kHead{{}, {0, 0, 0, 1}};
    const Frame above = parent == kNone ? kHead : frame_of(bones[parent], palette[parent]);
    const Frame own = frame_of(bones[b], palette[b]);
    const double way[3] = {own.origin[0] - above.origin[0], own.origin[1] - above.origin[1],
                           own.origin[2] - above.origin[2]};
    const Turn turn = between(above.turn, own.turn);
    transforms[b] = {turned_back(above.turn, way),
                     {static_cast<float>(turn.x), static_cast<float>(turn.y), static_cast<float>(turn.z),
                      static_cast<float>(turn.w)}};
  }
  return Status::kOk;
}

}  // namespace coif
