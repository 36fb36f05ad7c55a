// Every number of a mesh is checked, and the first that is wrong is named.

#include "formats/refusal.h"

#include <cmath>
#include <functional>
#include <limits>

namespace coif {
namespace {

using Change = std::function<void(AssetContents&)>;

LoadStatus opened_after(const Change& change) {
  AssetContents contents = small_asset();
  change(contents);
  return open_written(contents);
}

TEST(OpenMesh, CoordinatesAreFiniteAndWithinTheirLimit) {
  constexpr float kLimit = 1.0e5f, kInfinity = std::numeric_limits<float>::infinity();
  const auto with = [](int field, float value) {
    return opened_after([=](AssetContents& a) {
      VertexRecord& v = a.vertices[7];
      (field < 3 ? v.position[field] : v.uv[field - 3]) = value;
    });
  };
  for (int field = 0; field < 5; ++field) {
    for (const float good : {kLimit, -kLimit, 0.0f, -0.0f, 1.0e-42f}) EXPECT_TRUE(with(field, good)) << field;
    for (const float bad : {std::nextafter(kLimit, kInfinity), std::nextafter(-kLimit, -kInfinity), kInfinity,
                            -kInfinity, std::nanf(""), -std::nanf("")}) {
      const LoadStatus status = with(field, bad);
      EXPECT_EQ(status.code, LoadCode::kNotFinite) << "field " << field << " = " << bad;
      EXPECT_EQ(status.item, 7u);
    }
  }
}

TEST(OpenMesh, DirectionsAreUnitVectorsAndSharesNotNegative) {
  const auto with = [](auto change) { return opened_after([=](AssetContents& a) { change(a.vertices[8]); }).code; };
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[2] = 32767 * 95 / 100; }), LoadCode::kOk);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[2] = 32767 * 94 / 100; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[1] = 0; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[1] = -32768; }), LoadCode::kOk);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[0] = v.tangent[1] = v.tangent[2] = -32768; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[3] = -1; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[3] = 0; }), LoadCode::kOk);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[3] = -1; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[3] = -32768; }), LoadCode::kNotFinite);
}

TEST(OpenMesh, WeightsAndBonesOfEverySlotAreChecked) {
  for (int slot = 0; slot < 4; ++slot) {
    const LoadStatus bone = opened_after([=](AssetContents& a) { a.skin[4].bone[slot] = 5; });
    EXPECT_EQ(bone.code, LoadCode::kReference) << slot;
    EXPECT_EQ(bone.found, 5u);
    const LoadStatus weight = opened_after([=](AssetContents& a) { a.skin[4].weight[slot] ^= 1; });
    EXPECT_EQ(weight.code, LoadCode::kWeightSum) << slot;
    EXPECT_EQ(weight.item, 4u);
  }
  const LoadStatus wraps = opened_after([](AssetContents& a) {
    for (std::uint8_t& weight : a.skin[4].weight) weight = 255;
  });
  EXPECT_EQ(wraps.code, LoadCode::kWeightSum);
  EXPECT_EQ(wraps.found, 1020u);
}

TEST(OpenMesh, TheFirstOfSeveralFaultsIsNamed) {
  const LoadStatus vertex = opened_after([](AssetContents& a) { a.vertices[3].uv[1] = a.vertices[6].uv[0] = NAN; });
  EXPECT_EQ(vertex.item, 3u);
  const LoadStatus index = opened_after([](AssetContents& a) { a.indices[5] = a.indices[8] = kNone; });
  EXPECT_EQ(index.code, LoadCode::kReference);
  EXPECT_EQ(index.item, 5u);
  EXPECT_EQ(index.found, kNone);
}

}  // namespace
}  // namespace coif
