#include "report/cards/groom_views.h"

#include "cards/hair_picture.h"
#include "cards/made_up_cards.h"
#include "cards/made_up_groom.h"
#include "lab/rig.h"
#include "report/cards/asset_surface.h"
#include "report/cards_asset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace coif::report::cards_views_test {

/// Squares of a side of 0.2 m that look along Z, one behind the other from `first` on.
cards::CardSurface squares(int count, float first = 0) {
  cards::CardSurface surface;
  for (int i = 0; i < count; ++i) {
    const auto corner = std::uint32_t(surface.positions.size());
    for (const auto& [x, y] : {std::pair{0.f, 0.f}, {1.f, 0.f}, {1.f, 1.f}, {0.f, 1.f}}) {
      surface.positions.emplace_back(0.2f * x - 0.1f, 0.1f - 0.2f * y, first - 0.02f * float(i));
      surface.uvs.emplace_back(x, y);
      surface.across.push_back(Eigen::Vector3f::UnitX());
      surface.along.push_back(-Eigen::Vector3f::UnitY());
    }
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) surface.triangles.push_back(corner + k);
  }
  surface.width = surface.height = 2;
  surface.opacity = {1, 0.4f, 0.8f, 0.2f};
  return surface;
}

/// Takes Z to Y.
Eigen::Matrix3f z_up() {
  Eigen::Matrix3f turn;
  turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return turn;
}

cards::PictureFrame frame_of(const cards::CardSurface& surface, const Eigen::Vector3f& towards) {
  return cards::frame_along(towards, cards::ball_around(surface.positions), 100);
}

TEST(SurfaceCost, CountsEachLayer) {
  const cards::CardSurface one = squares(1), three = squares(3);
  const cards::PictureFrame frame = frame_of(three, {0, 0, -1});
  const cards::SurfaceCost of_one = cards::cost_of(one, frame), of_three = cards::cost_of(three, frame);
  const double pixels = std::pow(0.2 * double(frame.pixels_of_metre), 2);
  EXPECT_NEAR(of_one.fragments / pixels, 1, 0.05);
  EXPECT_NEAR(of_one.layers, 1, 0.03) << "samples on the diagonal are in both triangles";
  EXPECT_DOUBLE_EQ(of_three.fragments, 3 * of_one.fragments);
  EXPECT_NEAR(of_three.layers, 3, 0.09);
  const cards::SurfaceCost from_edge = cards::cost_of(one, frame_of(one, {1, 0, 0}));
  EXPECT_EQ(from_edge.fragments, 0);
  EXPECT_EQ(from_edge.layers, 0);
}

TEST(HairPictures, OfASurfaceAreLikeItself) {
  const cards::CardSurface surface = squares(2);
  for (const Eigen::Vector3f& direction : cards::spread_directions(5)) {
    const cards::HairPicture picture = cards::draw_cards(surface, frame_of(surface, direction), 2);
    const cards::HairLikeness same = cards::compare_hair(picture, picture);
    EXPECT_EQ(same.coverage_iou, 1);
    EXPECT_EQ(same.error, 0);
  }
}

/// A square with stripes of a texel.
cards::CardSurface striped_square() {
  cards::CardSurface surface = squares(1);
  surface.width = surface.height = 256;
  surface.opacity.clear();
  for (std::size_t i = 0; i < std::size_t{256} * 256; ++i) surface.opacity.push_back(i % 4 == 0 ? 1.0f : 0.0f);
  return surface;
}

TEST(SurfaceAsCooked, CoversAsMuchFromAfarAsCloseUp) {
  cards::CardSurface surface = striped_square();
  cards::draw_as_cooked(surface);
  ASSERT_EQ(surface.smaller_opacity.size(), 8u);
  EXPECT_GT(surface.opaque_from, 0.4f);
  EXPECT_GT(surface.discard_below, 0);
  const auto coverage_of = [&](std::uint32_t size, std::uint32_t side) {
    const auto frame = cards::frame_along({0, 0, -1}, cards::ball_around(surface.positions), size);
    const auto picture = cards::draw_cards(surface, frame, 2, side);
    return std::accumulate(picture.coverage.begin(), picture.coverage.end(), 0.0) / double(size) / double(size);
  };
  const double close = coverage_of(512, 1);
  EXPECT_GT(close, 0);
  EXPECT_NEAR(coverage_of(32, 4) / close, 1, 0.15);
}

TEST(HairPictures, AreSolidFromTheOpaqueThresholdOnAndEmptyBelowTheOther) {
  cards::CardSurface surface = squares(1);
  surface.opacity.assign(4, 0.6f);
  const auto coverage = [&] {  // At a pixel beside the diagonal.
    return cards::draw_cards(surface, frame_of(surface, {0, 0, -1}), 2).coverage[40 * 100 + 60];
  };
  EXPECT_NEAR(coverage(), 0.6f, 1e-3f);
  surface.opaque_from = 0.5f;
  EXPECT_NEAR(coverage(), 1, 1e-3f);
  surface.opaque_from = 2;
  surface.discard_below = 0.7f;
  EXPECT_EQ(coverage(), 0);
}

TEST(CloserFrame, HoldsAllStrandsAndFillsThePicture) {
  const groom::Groom groom = cards::test::groom_of(cards::test::strands_of_a_head(60));
  const auto directions = cards::spread_directions(5);
  for (const cards::PictureFrame& frame : frames_around(groom, z_up(), directions, 64)) {
    const cards::PictureFrame close = closer(frame, groom);
    EXPECT_GT(close.pixels_of_metre, frame.pixels_of_metre);
    Eigen::AlignedBox2f seen;
    for (const Eigen::Vector3f& point : groom.points) seen.extend(close.place(point).head<2>().eval());
    EXPECT_GE(seen.min().minCoeff(), 0);
    EXPECT_LE(seen.max().maxCoeff(), 64);
    EXPECT_GT(seen.sizes().maxCoeff(), 60);
  }
}

TEST(FramesAround, LookAlongTheTurnedAxes) {
  const groom::Groom groom = cards::test::groom_of(cards::test::strands_of_a_head(10));
  const cards::PictureFrame frame = frames_around(groom, z_up(), {{{0, 0, -1}}}, 64)[0];
  const Eigen::Vector3f down = frame.axes.row(1).transpose();
  EXPECT_NEAR((down + Eigen::Vector3f::UnitZ()).norm(), 0, 1e-5) << "the groom's own Z is up";
}

/// A groom as large as squares(), whose file says nothing of its unit.
groom::Groom groom_around_squares(const cards::CardSurface& surface) {
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (std::size_t v = 0; v < surface.positions.size(); v += 4) {
    strands.push_back({surface.positions[v], surface.positions[v + 3]});
    strands.push_back({surface.positions[v + 1], surface.positions[v + 2]});
  }
  groom::Groom groom = cards::test::groom_of(strands);
  groom.path = "strands.obj";
  groom.space.unit = groom.space.up = importer::Statement::kUnsaid;
  return groom;
}

TEST(CookedPlace, IsFoundWhateverTheCookDidToUnitAndUp) {
  const cards::CardSurface surface = squares(3, 0.5f);
  const groom::Groom groom = groom_around_squares(surface);
  const Eigen::Matrix3f half_turn =
      Eigen::AngleAxisf(std::numbers::pi_v<float>, Eigen::Vector3f::UnitX()).toRotationMatrix();
  for (const float factor : {1.0f, 0.01f, 10.0f}) {
    for (const Eigen::Matrix3f& turn : {Eigen::Matrix3f(Eigen::Matrix3f::Identity()), z_up(), half_turn}) {
      const lab::OpenedAsset asset(asset_of_surface(surface, {factor, turn, {0.1f, 0.3f, -0.2f}}));
      ASSERT_TRUE(asset.asset().is_open());
      const auto place = find_cooked_place(asset.asset(), groom);
      ASSERT_TRUE(place.has_value()) << place.error().message;
      EXPECT_NEAR(place->factor, double(factor), 1e-6 * double(factor));
      const cards::CardSurface back = surface_of_asset(asset.asset(), 0, *place);
      ASSERT_EQ(back.triangles.size(), surface.triangles.size());
      for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const std::uint32_t there = back.triangles[i], here = surface.triangles[i];
        EXPECT_LT((back.positions[there] - surface.positions[here]).norm(), 1e-4);
        EXPECT_LT((back.along[there] - surface.along[here]).norm(), 1e-3);
      }
    }
  }
}

TEST(CookedPlace, IsFoundOfStrandsInAUnitOfTheirOwn) {
  auto strands = cards::test::strands_of_a_head(200);
  for (std::vector<Eigen::Vector3f>& strand : strands) {
    for (Eigen::Vector3f& point : strand) point *= 350;
  }
  groom::Groom groom = cards::test::groom_of(strands);
  groom.space.unit = groom.space.up = importer::Statement::kUnsaid;
  const cards::Cards cards = cards::test::unfitted_cards(groom, 0.5f, 40, 160, std::size_t{1} << 16);
  const float factor = 0.0027f;  // 0.095 m over 35
  const lab::OpenedAsset asset(
      asset_of_surface(cards::surface_of(cards), {factor, Eigen::Matrix3f::Identity(), {0, 0.1f, 0}}));
  ASSERT_TRUE(asset.asset().is_open());
  const auto place = find_cooked_place(asset.asset(), groom);
  ASSERT_TRUE(place.has_value()) << place.error().message;
  EXPECT_NEAR(place->factor, double(factor), 1e-6);
}

TEST(CookedPlace, OfOtherStrandsIsNone) {
  const lab::OpenedAsset asset(asset_of_surface(squares(1), {}));
  const groom::Groom other = groom_around_squares(squares(1, 7));
  const auto place = find_cooked_place(asset.asset(), other);
  ASSERT_FALSE(place.has_value());
  EXPECT_EQ(place.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(place.error().message.find("strands.obj"), std::string::npos) << place.error().message;
  EXPECT_NE(place.error().message.find("--recipe"), std::string::npos) << place.error().message;
}

TEST(SurfaceOfAsset, LooksLikeTheOneThatWasCooked) {
  const cards::CardSurface surface = squares(2);
  const lab::OpenedAsset asset(asset_of_surface(surface, {}));
  const cards::CardSurface back = surface_of_asset(asset.asset(), 0, {});
  EXPECT_EQ(back.positions.size(), surface.positions.size());
  for (const Eigen::Vector3f& direction : cards::spread_directions(4)) {
    const cards::PictureFrame frame = frame_of(surface, direction);
    const cards::HairLikeness likeness =
        cards::compare_hair(cards::draw_cards(surface, frame, 2), cards::draw_cards(back, frame, 2));
    EXPECT_GT(likeness.coverage_iou, 0.995);
    EXPECT_LT(likeness.error, 0.005);
  }
}

}  // namespace coif::report::cards_views_test
