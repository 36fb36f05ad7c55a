// The portrait: a face whose parts are where they should be, and a file that any tool reads.

#include "mannequin/portrait.h"
#include "import/import.h"
#include "mannequin/portrait_head.h"
#include "models/small_asset.h"
#include "research/sample/bob.h"
#include "research/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace coif::research::portrait_test {

using namespace mannequin;

using Eigen::Vector3d;

TEST(Portrait, IsTheCommittedFile) {
  const std::vector<std::uint8_t> committed = read_bytes(COIF_SAMPLE_ASSETS "/portrait/portrait.glb");
  ASSERT_FALSE(committed.empty()) << COIF_SAMPLE_ASSETS "/portrait/portrait.glb is absent";
  EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(committed)), make_portrait()))
      << "renew it: coif_make_sample portrait sample_assets/portrait/portrait.glb";
}

TEST(Portrait, HasTheProportionsOfAHead) {
  const double height = kCrown - kChin;
  EXPECT_NEAR(kEyeLine, kChin + height / 2, 0.0025) << "eyes at half the height";
  EXPECT_NEAR(kBrowLine - kNoseBase, kNoseBase - kChin, 0.005) << "brow to nose as nose to chin";
  EXPECT_NEAR(kNoseBase - kMouthLine, (kNoseBase - kChin) / 3, 0.002) << "mouth at a third";
  EXPECT_NEAR(2 * (kOpeningMiddle - kOpeningHalf), 2 * kOpeningHalf, 0.006) << "an eye's width between the eyes";
  EXPECT_NEAR(portrait_distance({0, kCrown, -0.012}), 0, 0.003);
  EXPECT_NEAR(portrait_distance({0, kChin, 0.068}), 0, 0.004);
}

TEST(Portrait, IsTheSameOnBothSides) {
  for (int i = 0; i < 500; ++i) {
    const Vector3d p(0.11 * std::sin(i), 1.25 + 0.001 * i, 0.12 * std::cos(2.7 * i));
    EXPECT_EQ(portrait_distance(p), portrait_distance({-p.x(), p.y(), p.z()}));
    EXPECT_EQ(skin_place(p), skin_place({-p.x(), p.y(), p.z()}));
  }
}

TEST(Portrait, EyesAreSeenBetweenTheirLids) {
  const LidEdges middle = lid_edges(kOpeningMiddle);
  EXPECT_NEAR(middle.across, 0, 1e-12);
  EXPECT_GT(middle.upper - middle.lower, 0.010);
  // Straight in front of the eye there is no skin before it, above and below there is.
  const auto is_free = [](double y) {
    for (double z = kEyeCenter.z() + kEyeRadii.z() + 0.001; z < 0.15; z += 0.0005) {
      if (portrait_distance({kOpeningMiddle, y, z}) < 0) return false;
    }
    return true;
  };
  EXPECT_TRUE(is_free(0.5 * (middle.upper + middle.lower)));
  EXPECT_FALSE(is_free(middle.upper + 0.004));
  EXPECT_FALSE(is_free(middle.lower - 0.004));
}

const std::vector<PortraitPart>& coarse_parts() {
  static const auto parts = make_portrait_parts({.spacing = 2, .texels = 96});
  return parts;
}

TEST(Portrait, SkinIsClosedAndInFrontOfWhatItCovers) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  const mannequin::SurfaceMesh& skin = coarse_parts().front().mesh;
  for (std::size_t i = 0; i < skin.triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{skin.triangles[i + k], skin.triangles[i + (k + 1) % 3]}];
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : edges) open += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
  EXPECT_EQ(open, 0u);
  for (std::size_t i = 0; i < skin.positions.size(); ++i) {
    const bool is_cut = skin.positions[i].y() < 1.330;  // under the shirt
    EXPECT_TRUE(is_cut || std::abs(portrait_distance(skin.positions[i])) < 0.002) << skin.positions[i].transpose();
    EXPECT_NEAR(skin.normals[i].norm(), 1, 1e-9);
    EXPECT_TRUE((skin.uvs[i].array() >= 0).all() && (skin.uvs[i].array() <= 1).all());
  }
}

TEST(Portrait, LashesStandBeforeTheLids) {
  const mannequin::SurfaceMesh& lashes = coarse_parts()[2].mesh;
  std::size_t inside = 0;
  for (const Vector3d& p : lashes.positions) inside += portrait_distance(p) < -0.0006 ? 1 : 0;
  EXPECT_LT(double(inside), 0.05 * double(lashes.positions.size()));
}

TEST(Portrait, LipsAreRedderThanCheeksAndBrowsDarker) {
  const Vector3d cheek = skin_color({0.030, 1.545, 0.070}), lip = skin_color({0.004, kMouthLine - 0.005, 0.092}),
                 brow = skin_color({0.030, kBrowLine + 0.002, 0.075});
  EXPECT_GT(lip.x() / lip.y(), 1.3 * cheek.x() / cheek.y());
  EXPECT_LT(brow.sum(), 0.7 * cheek.sum());
}

TEST(Portrait, IsReadAsABodyWithItsTexturesAndItsHead) {
  const std::vector<std::byte> bytes = make_portrait();
  EXPECT_LT(bytes.size(), 2500000u);
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "coif_portrait.glb";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  const auto model = importer::import_model(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->meshes.size(), 4u);
  EXPECT_EQ(model->images.size(), 2u);
  EXPECT_TRUE(std::ranges::any_of(model->nodes, [](const importer::SourceNode& node) { return node.name == "Head"; }));
  for (const importer::SourceMesh& mesh : model->meshes) {
    EXPECT_FALSE(mesh.influences.empty()) << mesh.name;
    const float roughness = model->materials[mesh.material].roughness;
    EXPECT_EQ(roughness < 0.3f, mesh.name == "eyes") << mesh.name;
  }
}

}  // namespace coif::research::portrait_test
