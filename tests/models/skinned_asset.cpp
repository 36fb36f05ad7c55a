#include "models/skinned_asset.h"

#include "models/small_asset.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

double from_snorm16(std::int16_t value) { return std::max(value / 32767.0, -1.0); }

VertexRecord vertex_number(std::size_t i) {
  const double t = 0.7 * double(i);
  VertexRecord vertex{};
  vertex.position[0] = float(0.1 * std::cos(t));
  vertex.position[1] = float(0.1 * std::sin(t));
  vertex.position[2] = float(0.01 * double(i));
  vertex.normal[0] = std::int16_t(std::lround(32767 * std::cos(t)));
  vertex.normal[1] = std::int16_t(std::lround(32767 * std::sin(t)));
  vertex.tangent[1] = std::int16_t(std::lround(-32767 * 0.6));
  vertex.tangent[2] = std::int16_t(std::lround(-32767 * 0.8));
  vertex.tangent[3] = 16384;
  return vertex;
}

/// matrix * (v, w)
void transform(const double (&matrix)[3][4], const double (&v)[3], double w, double (&out)[3]) {
  for (int row = 0; row < 3; ++row) {
    out[row] = matrix[row][3] * w;
    for (int k = 0; k < 3; ++k) out[row] += matrix[row][k] * v[k];
  }
}

}  // namespace

AssetContents skinned_contents(std::uint32_t bones, std::span<const SkinRecord> skin) {
  AssetContents contents;
  contents.skeleton.head_rotation[3] = 1;
  contents.bones = rigid_bones(bones);
  for (std::size_t i = 0; i < skin.size(); ++i) contents.vertices.push_back(vertex_number(i));
  contents.skin.assign(skin.begin(), skin.end());
  for (std::uint32_t i = 0; i + 2 < skin.size(); i += 3) {
    for (std::uint32_t k = 0; k < 3; ++k) contents.indices.push_back(i + k);
  }
  PatchRecord patch{};
  patch.index_count = std::uint32_t(contents.indices.size());
  contents.patches = {patch};
  return contents;
}

std::vector<Mat34> bent_palette(std::uint32_t bones) {
  std::vector<Mat34> palette(bones);
  for (std::uint32_t b = 0; b < bones; ++b) {
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 4; ++k) palette[b].m[row][k] += float(0.3 * std::sin(1.7 * (b + 1) * (4 * row + k + 1)));
    }
  }
  return palette;
}

ExactVertex exactly_skinned(const Asset& asset, std::span<const Mat34> palette, std::uint32_t vertex) {
  const VertexRecord& record = asset.vertices()[vertex];
  double matrix[3][4] = {};
  for (int k = 0; k < 4; ++k) {
    const SkinRecord& skin = asset.skin()[vertex];
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        matrix[row][column] += skin.weight[k] / 255.0 * double(palette[skin.bone[k]].m[row][column]);
      }
    }
  }
  double rest[3][3];
  for (int k = 0; k < 3; ++k) {
    rest[0][k] = double(record.position[k]);
    rest[1][k] = from_snorm16(record.normal[k]);
    rest[2][k] = from_snorm16(record.tangent[k]);
  }
  ExactVertex exact{};
  transform(matrix, rest[0], 1, exact.position);
  transform(matrix, rest[1], 0, exact.normal);
  transform(matrix, rest[2], 0, exact.tangent);
  return exact;
}

double difference(const SkinnedVertex& a, const ExactVertex& b) {
  const auto apart = [](const Vec3& v, const double(&exact)[3]) {
    return std::max(
        {std::abs(double(v.x) - exact[0]), std::abs(double(v.y) - exact[1]), std::abs(double(v.z) - exact[2])});
  };
  return std::max({apart(a.position, b.position), apart(a.normal, b.normal), apart(a.tangent, b.tangent)});
}

}  // namespace coif
