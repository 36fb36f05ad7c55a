#include <coif/skinning.h>

#include <cstddef>

namespace coif {
namespace {

struct RestVertex {
  Vec3 position;
  Vec3 normal;
  Vec3 tangent;
};

// OpenGL's conversion of a normalised short: -32768 and -32767 both mean -1.
float from_snorm16(std::int16_t value) {
  const float fraction = float(value) / 32767.0f;
  return fraction < -1.0f ? -1.0f : fraction;
}

Vec3 from_snorm16(const std::int16_t (&v)[4]) { return {from_snorm16(v[0]), from_snorm16(v[1]), from_snorm16(v[2])}; }

RestVertex at_rest(const VertexRecord& vertex) {
  const auto& p = vertex.position;
  return {{p[0], p[1], p[2]}, from_snorm16(vertex.normal), from_snorm16(vertex.tangent)};
}

float dot(const float (&row)[4], const Vec3& v) { return row[0] * v.x + row[1] * v.y + row[2] * v.z; }

Vec3 turned(const Mat34& rows, const Vec3& v) { return {dot(rows.m[0], v), dot(rows.m[1], v), dot(rows.m[2], v)}; }

Vec3 moved(const Mat34& rows, const Vec3& v) {
  const Vec3 t = turned(rows, v);
  return {t.x + rows.m[0][3], t.y + rows.m[1][3], t.z + rows.m[2][3]};
}

Mat34 blended(const SkinRecord& skin, const Mat34* palette) {
  const Mat34 &a = palette[skin.bone[0]], &b = palette[skin.bone[1]];
  const Mat34 &c = palette[skin.bone[2]], &d = palette[skin.bone[3]];
  float w[4];
  for (int k = 0; k < 4; ++k) w[k] = float(skin.weight[k]) / 255.0f;
  Mat34 sum;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      sum.m[row][column] =
          w[0] * a.m[row][column] + w[1] * b.m[row][column] + w[2] * c.m[row][column] + w[3] * d.m[row][column];
    }
  }
  return sum;
}

SkinnedVertex skinned(const RestVertex& rest, const Mat34& rows) {
  return {moved(rows, rest.position), turned(rows, rest.normal), turned(rows, rest.tangent)};
}

Status check(const Asset& asset, std::span<const Mat34> palette, std::uint32_t first, std::size_t count) {
  const std::size_t vertices = asset.vertices().size();
  if (vertices == 0) return Status::kAssetLacksData;
  if (first > vertices || count > vertices - first) return Status::kBadIndex;
  const bool may_lack = asset.skin().empty() && palette.empty();
  return may_lack || palette.size() == asset.bones().size() ? Status::kOk : Status::kSizeMismatch;
}

}  // namespace

Status skin_vertices(const Asset& asset, std::span<const Mat34> palette, std::uint32_t first,
                     std::span<SkinnedVertex> out) {
  if (const Status status = check(asset, palette, first, out.size()); status != Status::kOk) return status;

  const VertexRecord* vertex = asset.vertices().data() + first;
  if (asset.skin().empty()) {
    for (SkinnedVertex& result : out) {
      const RestVertex rest = at_rest(*vertex++);
      result = {rest.position, rest.normal, rest.tangent};
    }
    return Status::kOk;
  }
  const SkinRecord* skin = asset.skin().data() + first;
  for (SkinnedVertex& result : out) {
    const bool one_bone = skin->weight[0] == 255;
    const RestVertex rest = at_rest(*vertex++);
    result = one_bone ? skinned(rest, palette[skin->bone[0]]) : skinned(rest, blended(*skin, palette.data()));
    ++skin;
  }
  return Status::kOk;
}

}  // namespace coif
