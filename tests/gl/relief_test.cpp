// Hair that is lit by maps of normals and strands.

#include "gl/gl_test.h"

#include <coif/shading_models.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace coif::relief_test {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979;

/// A card whose texture lies on it as `uv_of_place` says: place from -1 to 1 along +X and +Y.
struct ReliefCard {
  DrawnCard card;
  Matrix2d uv_of_place{{0.4, 0}, {0, -0.4}};
  ShadingModel model = ShadingModel::kThesis;
};

ReliefCard leaning_card() {
  ReliefCard relief;
  relief.card.half_size = 0.95f;
  relief.card.rgba = {180, 120, 70, 255};
  relief.card.shift_mask = {150, 200};
  relief.card.tangent = {0.28f, -0.96f, 0};
  return relief;
}

std::uint8_t byte_of(double value) { return std::uint8_t(std::lround(127 * value) + 128); }

/// One texel, the same everywhere.
void add_map(TextureRole role, const Vector2d& value, AssetContents& contents) {
  const std::uint64_t offset = contents.relief_texels.size();
  contents.relief_texels.resize(offset + 16);
  contents.relief_texels[offset] = std::byte(byte_of(value.x()));
  contents.relief_texels[offset + 1] = std::byte(byte_of(value.y()));
  contents.reliefs.push_back({role, TexelFormat::kRg8, 1, 1, 1, 0, offset, 2});
}

AssetContents contents_of(const ReliefCard& relief) {
  AssetContents contents = card_contents(std::span(&relief.card, 1));
  for (VertexRecord& v : contents.vertices) {
    const Vector2d place(v.position[0] / relief.card.half_size, v.position[1] / relief.card.half_size);
    const Vector2d uv = Vector2d(0.5, 0.5) + relief.uv_of_place * place;
    for (int k = 0; k < 2; ++k) v.uv[k] = float(uv[k]);
  }
  MaterialRecord& m = contents.material[0];
  m.shading = relief.model;
  m.primary_exponent = 20;
  m.secondary_exponent = 8;
  m.primary_shift = 0.3f;
  m.secondary_shift = -0.2f;
  m.roughness = 0.3f;
  m.tilt = 0.06f;
  m.scatter = 0.4f;
  for (int k = 0; k < 3; ++k) m.ambient[k] = 0.05f, m.primary_color[k] = 0.5f, m.secondary_color[k] = 0.3f;
  return contents;
}

/// The unit vector of the card's plane along which U or V grows, the other one standing still or not.
Vector3d axis(const ReliefCard& relief, int of) {
  const Vector2d way = relief.uv_of_place.inverse().col(of).normalized();
  return {way.x(), way.y(), 0};
}

std::array<float, 3> floats(const Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

/// The card as its vertices say what a map of the normal `lean` says. A card that is turned is seen from behind.
ReliefCard bent(ReliefCard relief, const Vector2d& lean) {
  const double up = std::sqrt(1 - lean.squaredNorm());
  const Vector3d t(relief.card.tangent[0], relief.card.tangent[1], relief.card.tangent[2]);
  const Vector3d seen = lean.x() * axis(relief, 0) + lean.y() * axis(relief, 1) + up * Vector3d::UnitZ();
  relief.card.tangent = floats((t - t.dot(seen) * seen).normalized());
  relief.card.normal = floats(relief.card.turned ? Vector3d(-seen) : seen);
  return relief;
}

class Relief : public GlTest {
 protected:
  Pixel drawn(const AssetContents& contents) {
    clear();
    const Light lights[] = {{Light::Kind::kDirectional, {0.5f, 0.6f, 0.8f}, {0.5f, 0.5f, 0.5f}},
                            {Light::Kind::kPoint, {-0.8f, 0.1f, 0.6f}, {0.2f, 0.3f, 0.2f}}};
    HeadDraw desc = at_rest();
    desc.lights = lights;
    draw(contents, desc);
    return pixel(20, 11);
  }
  Pixel drawn(const ReliefCard& relief) { return drawn(contents_of(relief)); }
  Pixel drawn_with(const ReliefCard& relief, TextureRole role, const Vector2d& value) {
    AssetContents contents = contents_of(relief);
    add_map(role, value, contents);
    return drawn(contents);
  }
};

std::vector<Matrix2d> ways_to_lie() {
  return {Matrix2d{{0.4, 0}, {0, -0.4}},   // upright
          Matrix2d{{-0.4, 0}, {0, -0.4}},  // mirrored
          Matrix2d{{0, 0.4}, {0.4, 0}},    // strands along U
          Matrix2d{{0.02, 0}, {0, -0.4}},  // stretched
          Matrix2d{{0.3, 0.2}, {-0.2, 0.3}}};
}

TEST_F(Relief, NormalsOfAMapAreLitAsThoseOfVerticesInEveryModel) {
  for (std::uint32_t model = 0; model < kShadingModelCount; ++model) {
    for (const Matrix2d& uv : ways_to_lie()) {
      for (const Vector2d& lean : {Vector2d(0.5, 0), Vector2d(0, 0.5), Vector2d(-0.4, 0.3)}) {
        ReliefCard relief = leaning_card();
        relief.model = ShadingModel(model);
        relief.uv_of_place = uv;
        const std::string what = "model " + std::to_string(model) + ", U " + std::to_string(uv(0, 0));
        EXPECT_TRUE(near(drawn_with(relief, TextureRole::kNormal, lean), drawn(bent(relief, lean)))) << what;
      }
    }
  }
}

TEST_F(Relief, ALeanIsSeenAtAll) {
  const Pixel flat = drawn(leaning_card());
  EXPECT_FALSE(near(drawn_with(leaning_card(), TextureRole::kNormal, {0.5, 0.3}), flat));
  EXPECT_FALSE(near(drawn_with(leaning_card(), TextureRole::kStrandAxis, {0, 1}), flat));
}

TEST_F(Relief, RidgesAreRidgesFromBehindToo) {
  ReliefCard relief = leaning_card();
  relief.card.turned = true;
  relief.card.normal = {0, 0, -1};
  const Vector2d lean(0.5, 0.2);
  EXPECT_TRUE(near(drawn_with(relief, TextureRole::kNormal, lean), drawn(bent(relief, lean))));
}

TEST_F(Relief, StrandsOfAMapAreLitAsThoseOfVerticesInEveryModel) {
  for (std::uint32_t model = 0; model < kShadingModelCount; ++model) {
    for (const Matrix2d& uv : ways_to_lie()) {
      if (std::abs(uv.col(0).dot(uv.col(1))) > 1e-6) continue;  // U and V at right angles, as on the card
      for (const double degrees : {0.0, 40.0, 90.0, 130.0}) {
        ReliefCard relief = leaning_card();
        relief.model = ShadingModel(model);
        relief.uv_of_place = uv;
        const double angle = degrees * kPi / 180;
        const Pixel mapped = drawn_with(relief, TextureRole::kStrandAxis, {std::cos(2 * angle), std::sin(2 * angle)});
        const Vector3d t(relief.card.tangent[0], relief.card.tangent[1], 0);
        const Vector3d strand = std::cos(angle) * axis(relief, 0) + std::sin(angle) * axis(relief, 1);
        relief.card.tangent = floats(strand.dot(t) < 0 ? Vector3d(-strand) : strand);
        EXPECT_TRUE(near(mapped, drawn(relief), 3)) << "model " << model << ", " << degrees << " degrees";
      }
    }
  }
}

TEST_F(Relief, MapsThatSayNothingChangeNothing) {
  for (const Matrix2d& uv : {ways_to_lie()[0], Matrix2d(Matrix2d::Zero())}) {  // or the texture stands still
    ReliefCard relief = leaning_card();
    relief.uv_of_place = uv;
    const Pixel plain = drawn(relief);
    EXPECT_TRUE(near(drawn_with(relief, TextureRole::kNormal, {0, 0}), plain));
    EXPECT_TRUE(near(drawn_with(relief, TextureRole::kStrandAxis, {0, 0}), plain));
  }
  ReliefCard standing = leaning_card();
  standing.uv_of_place.setZero();
  const Pixel plain = drawn(standing);
  EXPECT_TRUE(near(drawn_with(standing, TextureRole::kNormal, {0.5, 0.3}), plain)) << "no axes to lean along";
}

}  // namespace coif::relief_test
