// Vectors of motion against those that skin_vertices() and both frames' matrices give.

#include "gl/motion_scene.h"
#include "models/skinned_asset.h"

#include <coif/skinning.h>

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace coif::motion_vectors_test {

using Point = std::array<double, 4>;

/// In clip space, double precision.
std::vector<Point> projected(const Asset& asset, const Frame& frame) {
  std::vector<SkinnedVertex> vertices(asset.vertices().size());
  EXPECT_EQ(skin_vertices(asset, frame.palette, 0, vertices), Status::kOk);
  std::vector<Point> points;
  const Quat& q = frame.head.rotation;
  for (const SkinnedVertex& vertex : vertices) {
    const double v[3] = {vertex.position.x, vertex.position.y, vertex.position.z}, u[3] = {q.x, q.y, q.z};
    const double t[3] = {2 * (u[1] * v[2] - u[2] * v[1]), 2 * (u[2] * v[0] - u[0] * v[2]),
                         2 * (u[0] * v[1] - u[1] * v[0])};
    double world[4] = {0, 0, 0, 1};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      world[i] =
          frame.head.position[i] + double(frame.head.scale) * (v[i] + double(q.w) * t[i] + u[j] * t[k] - u[k] * t[j]);
    }
    Point clip{};
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = 0; column < 4; ++column)
        clip[row] += double(frame.clip[4 * column + row]) * world[column];
    }
    points.push_back(clip);
  }
  return points;
}

class MotionVectors : public MotionScene {
 protected:
  /// What a pixel's nearest triangle says; nothing where none is there, or an edge or another triangle is too near to
  /// tell.
  struct Expected {
    std::optional<Vector> vector;
    double depth = 1;
  };

  static std::vector<Expected> expected(const Asset& asset, const Frame& now, const Frame& before);
  static std::vector<Vector> vectors_at(const Asset& asset, std::span<const Point> is, std::span<const Point> was,
                                        std::size_t pixel);
  static int compare(const std::vector<Vector>& found, const std::vector<Expected>& expected);
};

/// Where a pixel's centre lies in a triangle on the screen: the corners' shares, perspective taken into account, and
/// its depth.
struct Inside {
  std::array<double, 3> share;
  double depth;
  double from_edge;  ///< The smallest share on the screen.
};

std::optional<Inside> inside(const std::array<Point, 3>& corners, double x, double y) {
  double px[3], py[3];
  for (std::size_t k = 0; k < 3; ++k) px[k] = corners[k][0] / corners[k][3], py[k] = corners[k][1] / corners[k][3];
  const double area = (px[1] - px[0]) * (py[2] - py[0]) - (px[2] - px[0]) * (py[1] - py[0]);
  if (std::fabs(area) < 1e-7) return std::nullopt;
  Inside found{{}, 0, 1};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const double flat = ((px[a] - x) * (py[b] - y) - (px[b] - x) * (py[a] - y)) / area;
    found.from_edge = std::min(found.from_edge, flat);
    found.depth += flat * corners[k][2] / corners[k][3];
    found.share[k] = flat / corners[k][3];
    sum += found.share[k];
  }
  for (double& share : found.share) share /= sum;
  return found;
}

std::vector<MotionVectors::Expected> MotionVectors::expected(const Asset& asset, const Frame& now,
                                                             const Frame& before) {
  const std::vector<Point> is = projected(asset, now), was = projected(asset, before);
  const std::span<const std::uint32_t> indices = asset.lod_indices(0);
  std::vector<Expected> all(kSide * kSide);
  for (std::size_t pixel = 0; pixel < all.size(); ++pixel) {
    const double x = (double(pixel % kSide) + 0.5) * 2 / kSide - 1, y = (double(pixel / kSide) + 0.5) * 2 / kSide - 1;
    bool is_clear = true;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const std::uint32_t* const c = &indices[i];
      const auto at = inside({is[c[0]], is[c[1]], is[c[2]]}, x, y);
      if (!at || at->from_edge < -0.05) continue;
      if (at->from_edge < 0.05 && at->depth < all[pixel].depth + 1e-4) is_clear = false;
      if (at->from_edge < 0 || at->depth > all[pixel].depth) continue;
      if (at->depth > all[pixel].depth - 1e-4) is_clear = false;
      all[pixel].depth = at->depth;
      Point then{};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t row = 0; row < 4; ++row) then[row] += at->share[k] * was[c[k]][row];
      }
      all[pixel].vector = {float((x - then[0] / then[3]) / 2), float((y - then[1] / then[3]) / 2)};
    }
    if (!is_clear) all[pixel].vector.reset();
  }
  return all;
}

/// The vectors of all triangles that contain a pixel's centre, edges included.
std::vector<MotionVectors::Vector> MotionVectors::vectors_at(const Asset& asset, std::span<const Point> is,
                                                             std::span<const Point> was, std::size_t pixel) {
  const double x = (double(pixel % kSide) + 0.5) * 2 / kSide - 1, y = (double(pixel / kSide) + 0.5) * 2 / kSide - 1;
  const std::span<const std::uint32_t> indices = asset.lod_indices(0);
  std::vector<Vector> all;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const std::uint32_t* const c = &indices[i];
    const auto at = inside({is[c[0]], is[c[1]], is[c[2]]}, x, y);
    if (!at || at->from_edge < -1e-2) continue;
    Point then{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t row = 0; row < 4; ++row) then[row] += at->share[k] * was[c[k]][row];
    }
    all.push_back({float((x - then[0] / then[3]) / 2), float((y - then[1] / then[3]) / 2)});
  }
  return all;
}

/// How many pixels were compared.
int MotionVectors::compare(const std::vector<Vector>& found, const std::vector<Expected>& expected) {
  int compared = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!expected[i].vector) continue;
    ++compared;
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(found[i][k], (*expected[i].vector)[k], 0.002 / kSide) << i;
  }
  return compared;
}

AssetContents opaque_wig() {
  std::vector<DrawnCard> cards(12);
  for (std::size_t i = 0; i < cards.size(); ++i) {
    cards[i].center = {0.09f * float(i % 4) - 0.13f, 0.1f * float(i / 4) - 0.15f, 0.02f * float(i % 5)};
    cards[i].half_size = 0.04f;
    cards[i].skin = {{std::uint16_t(1 + i % 4), std::uint16_t(1 + i % 3), 0, 0}, {155, 100, 0, 0}};
  }
  return card_contents(cards, 5);
}

TEST_F(MotionVectors, AreThoseOfSkinnedVerticesInBothFrames) {
  const DrawnAsset asset(opaque_wig());
  Frame now = frame_of(*asset, 0, 0.3f), before = frame_of(*asset, 0, 0.2f);
  now.palette = bent_palette(5);
  for (Mat34& matrix : now.palette) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) matrix.m[r][c] = (r == c ? 1.0f : 0.0f) + 0.05f * matrix.m[r][c];
    }
  }
  now.head.position[0] = 0.02;
  now.head.scale = 1.1f;
  before.head.position[1] = -0.03;
  look_from(before, {0.05f, 0, 1.1f});
  EXPECT_GT(compare(vectors(*asset, now, before), expected(*asset, now, before)), 150);
}

TEST_F(MotionVectors, OfLockedHairThatSwingsAreThoseOfEachLock) {
  const DrawnAsset wig(made_up_wig({.strips = 24, .bones_per_chain = 3, .texture_size = 64}));
  const Frame now = frame_of(*wig, 0.1f, 0), before = frame_of(*wig, 0.02f, 0.1f);
  const auto found = vectors(*wig, now, before);
  // Strips have soft texels, which the geometry does not know: the vector is that of one of those that are there.
  const std::vector<Point> is = projected(*wig, now), was = projected(*wig, before);
  int drawn = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i][0] == kUntouched) continue;
    ++drawn;
    double nearest = 9;
    for (const Vector& v : vectors_at(*wig, is, was, i)) {
      nearest = std::min(nearest, std::hypot(double(found[i][0] - v[0]), double(found[i][1] - v[1])));
    }
    EXPECT_LT(nearest, 0.01 / kSide) << i;
  }
  EXPECT_GT(drawn, 200);
}

TEST_F(MotionVectors, AreNothingForAStandingHeadUnderAStandingCamera) {
  const DrawnAsset wig(made_up_wig({.strips = 24, .bones_per_chain = 3, .texture_size = 64}));
  const Frame frame = frame_of(*wig, 0.05f, 0.4f);
  int drawn = 0;
  for (const Vector& vector : vectors(*wig, frame, frame)) {
    if (vector[0] == kUntouched) continue;
    ++drawn;
    EXPECT_NEAR(vector[0], 0, 1e-7);
    EXPECT_NEAR(vector[1], 0, 1e-7);
  }
  EXPECT_GT(drawn, 200);
}

TEST_F(MotionVectors, OfAStandingHeadAreTheCamerasMotion) {
  const DrawnAsset asset(opaque_wig());
  Frame now = frame_of(*asset, 0, 0), before = now;
  look_from(before, {0.1f, -0.02f, 1.3f});
  EXPECT_GT(compare(vectors(*asset, now, before), expected(*asset, now, before)), 150);
  // Flat hair straight ahead of a camera that moves sideways: the same everywhere.
  const std::array card{DrawnCard{.half_size = 0.2f}};
  const DrawnAsset flat(card_contents(card));
  now.palette.resize(1);
  look_from(now, {0, 0, 1});
  look_from(before = now, {-0.1f, 0, 1});
  for (const Vector& vector : vectors(*flat, now, before)) {
    if (vector[0] == kUntouched) continue;
    EXPECT_NEAR(vector[0], -0.5 * 2.5 * 0.1, 1e-6) << "the camera went right, and what it sees left";
    EXPECT_NEAR(vector[1], 0, 1e-6);
  }
}

TEST_F(MotionVectors, AJitterThatBothMatricesHaveStaysOut) {
  const DrawnAsset asset(opaque_wig());
  Frame frame = frame_of(*asset, 0, 0.1f);
  for (std::size_t column = 0; column < 4; ++column) frame.clip[4 * column] += 0.01f * frame.clip[4 * column + 3];
  for (const Vector& vector : vectors(*asset, frame, frame)) {
    if (vector[0] == kUntouched) continue;
    EXPECT_NEAR(vector[0], 0, 1e-7);  // graphics cards divide by way of reciprocals
    EXPECT_NEAR(vector[1], 0, 1e-7);
  }
}

TEST_F(MotionVectors, WhatWasBehindTheEyeComesFromOutsideOfThePicture) {
  const std::array card{DrawnCard{}};
  const DrawnAsset flat(card_contents(card));
  Frame now = frame_of(*flat, 0, 0), before = now;
  before.head.position[2] = 4;
  const auto found = vectors(*flat, now, before);
  EXPECT_EQ(found[kMiddle], (Vector{2, 2}));
}

TEST_F(MotionVectors, AreOfTexelsFromTheThresholdOn) {
  DrawnCard card;
  card.rgba[3] = 128;
  const std::array cards{card};
  const DrawnAsset soft(card_contents(cards));
  const Frame frame = frame_of(*soft, 0, 0);
  MotionDesc desc = desc_of(frame, frame);
  EXPECT_EQ(vectors(*soft, frame, frame, &desc)[kMiddle], (Vector{0, 0})) << "0.502 of 0.5";
  desc.alpha = 0.51f;
  EXPECT_EQ(vectors(*soft, frame, frame, &desc)[kMiddle], (Vector{kUntouched, kUntouched}));
}

TEST_F(MotionVectors, LieBehindWhatIsSolidInFrontOfTheHair) {
  const std::array card{DrawnCard{}};
  const DrawnAsset flat(card_contents(card));
  const Frame frame = frame_of(*flat, 0, 0);
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *flat), Status::kOk);
  const HairInstance one{frame.head, frame.palette, 0};
  clear_vectors();
  constexpr GLfloat kNear = 0;
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, kSide / 2, kSide);
  glClearBufferfv(GL_DEPTH, 0, &kNear);
  glDisable(GL_SCISSOR_TEST);
  ASSERT_EQ(draw_motion_vectors(renderer_, model, {&one, 1}, {&one, 1}, desc_of(frame, frame)), Status::kOk);
  const auto found = read_vectors();
  EXPECT_EQ(found[kSide * kSide / 2 + 10][0], kUntouched);
  EXPECT_EQ(found[kSide * kSide / 2 + kSide - 10][0], 0);
  model.destroy();
}

// A crowd in one call, and more bones than a block holds.

TEST_F(MotionVectors, EachHeadOfACrowdHasItsOwnPast) {
  const std::array card{DrawnCard{.half_size = 0.1f}};
  const DrawnAsset flat(card_contents(card, 3));
  const Frame frame = frame_of(*flat, 0, 0);
  std::vector<HairInstance> now(3, {frame.head, frame.palette, 0}), before = now;
  for (int i = 0; i < 3; ++i) {
    now[std::size_t(i)].head.position[0] = before[std::size_t(i)].head.position[0] = 0.25 * (i - 1);
    before[std::size_t(i)].head.position[1] = -0.02 * (i - 1);
  }
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *flat), Status::kOk);
  MotionDesc desc = desc_of(frame, frame);
  ASSERT_EQ(prepare_motion_vectors(renderer_, model, desc), Status::kOk);
  clear_vectors();
  calls_->forget();
  ASSERT_EQ(draw_motion_vectors(renderer_, model, now, before, desc), Status::kOk);
  EXPECT_EQ(calls_->draws, 1);
  EXPECT_EQ(calls_->links, 0) << "prepared";
  EXPECT_EQ(calls_->objects, 0);
  const auto found = read_vectors();
  for (int i = 0; i < 3; ++i) {
    const int x = int((2.5 * 0.25 * (i - 1) + 1) / 2 * kSide), y = int((2.5 * 0.05 + 1) / 2 * kSide);
    EXPECT_NEAR(found[std::size_t(y * kSide + x)][1], 0.5 * 2.5 * 0.02 * (i - 1), 1e-6) << i;
  }
  model.destroy();
}

TEST_F(MotionVectors, BonesTooManyForABlockHaveTheirPast) {
  // Two frames of 200 bones exceed a block that one frame of them fits into; of 600 one does, and takes three rows.
  for (const std::uint32_t bones : {200u, 600u}) {
    DrawnCard card;
    card.half_size = 0.2f;
    card.skin.bone[0] = std::uint16_t(bones - 1);
    const DrawnAsset asset(card_contents(std::span(&card, 1), bones));
    const Frame now = frame_of(*asset, 0, 0);
    Frame before = now;
    before.palette[bones - 1].m[0][3] = -0.04f;
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, *asset), Status::kOk);
    const HairInstance is{now.head, now.palette, 0}, was{before.head, before.palette, 0};
    for (int frame = 0; frame < 2; ++frame) {
      clear_vectors();
      calls_->forget();
      ASSERT_EQ(draw_motion_vectors(renderer_, model, {&is, 1}, {&was, 1}, desc_of(now, before)), Status::kOk);
      EXPECT_EQ(calls_->objects, frame == 0 ? 1 : 0) << "the texture is made once";
      EXPECT_NEAR(read_vectors()[kMiddle][0], 0.5 * 2.5 * 0.04, 1e-6) << bones;
    }
    model.destroy();
  }
}

TEST_F(MotionVectors, OfHairWithoutSkinAreItsHeads) {
  const std::array card{DrawnCard{}};
  AssetContents contents = card_contents(card, 2);
  contents.skin.clear();
  const DrawnAsset rigid(contents);
  const Frame now = frame_of(*rigid, 0, 0);
  Frame before = now;
  before.head.position[1] = -0.1;
  before.palette[0].m[0][3] = 5;  // moves nothing
  EXPECT_NEAR(vectors(*rigid, now, before)[kMiddle][1], 0.5 * 2.5 * 0.1, 1e-6);
}

}  // namespace coif::motion_vectors_test
