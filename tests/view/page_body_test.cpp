#include "view/body/page_body.h"

#include "view/body/compact_body.h"
#include "view/view_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace coif::view::page_body_test {

using Eigen::Vector3f;

/// A ball of so many rings and sectors about (0, 1.6, 0), 0.1 m in radius, on a head bone above a neck.
importer::SourceModel ball_on_neck(int rings, int sectors) {
  importer::SourceModel model;
  model.nodes = {{"root", importer::kNoIndex, Eigen::Affine3d::Identity()},
                 {"neck", 0, Eigen::Affine3d::Identity()},
                 {"head", 1, Eigen::Affine3d::Identity()}};
  importer::SourceMesh mesh;
  mesh.name = "ball";
  mesh.influence_begin.push_back(0);
  for (int ring = 0; ring <= rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const float polar = float(M_PI) * float(ring) / float(rings),
                  around = 2 * float(M_PI) * float(sector) / float(sectors);
      const Vector3f unit(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around));
      mesh.positions.emplace_back(Vector3f(0, 1.6f, 0) + 0.1f * unit);
      mesh.normals.push_back(unit);
      mesh.influences.push_back({unit.y() > 0 ? 2u : unit.y() > -0.5f ? 1u : 0u, 1.0f});
      mesh.influence_begin.push_back(std::uint32_t(mesh.influences.size()));
    }
  }
  const auto at = [&](int ring, int sector) { return std::uint32_t(ring * sectors + sector % sectors); };
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const std::uint32_t a = at(ring, sector), b = at(ring, sector + 1), c = at(ring + 1, sector),
                          d = at(ring + 1, sector + 1);
      mesh.triangles.insert(mesh.triangles.end(), {a, c, d, a, d, b});
    }
  }
  model.meshes.push_back(std::move(mesh));
  return model;
}

TEST(PageBody, BytesKeepShapeTurnAndLook) {
  const CompactBody compact = compact_body(ball_on_neck(16, 24), {}, "head");
  ASSERT_EQ(compact.body.meshes.size(), 1u);
  PageBody body = compact.body;
  body.meshes[0].image = 3;
  body.meshes[0].mesh.color = Vector3f(0.25f, 0.5f, 0.75f);
  body.meshes[0].mesh.roughness = 0.3f;
  const auto back = page_body(body_bytes(body));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->meshes.size(), 1u);
  const PageBodyMesh &before = body.meshes[0], &after = back->meshes[0];
  EXPECT_EQ(after.mesh.triangles, before.mesh.triangles);
  EXPECT_EQ(after.image, before.image);
  EXPECT_EQ(after.mesh.color, before.mesh.color);
  EXPECT_EQ(after.mesh.roughness, before.mesh.roughness);
  ASSERT_EQ(after.mesh.vertices.size(), before.mesh.vertices.size());
  ASSERT_EQ(after.turning.size(), before.mesh.vertices.size());
  for (std::size_t i = 0; i < after.mesh.vertices.size(); ++i) {
    EXPECT_LT((after.mesh.vertices[i].position - before.mesh.vertices[i].position).norm(), 4e-6f) << "metres";
    EXPECT_GT(after.mesh.vertices[i].normal.dot(before.mesh.vertices[i].normal), 1 - 1e-6f);
    EXPECT_NEAR(after.turning[i], before.turning[i], 0.003f);
  }
}

TEST(PageBody, DamagedBytesAreRefused) {
  const std::vector<std::byte> good = body_bytes(compact_body(ball_on_neck(4, 6), {}, "head").body);
  ASSERT_TRUE(page_body(good));
  for (std::size_t n = 1; n < good.size(); ++n) {
    const std::vector<std::byte> cut(good.begin(), good.begin() + std::ptrdiff_t(n));
    EXPECT_FALSE(page_body(cut)) << n << " of " << good.size() << " bytes";
  }
  std::vector<std::byte> longer = good;
  longer.push_back(std::byte{});
  EXPECT_FALSE(page_body(longer));
  std::vector<std::byte> other = good;
  other.back() = std::byte{0xFF};  // the last triangle's last corner: no such vertex
  EXPECT_FALSE(page_body(other));
}

TEST(PageBody, LargeModelsLoseTrianglesAndKeepTheirShape) {
  const CompactBody compact = compact_body(ball_on_neck(200, 300), {}, "head");
  ASSERT_EQ(compact.body.meshes.size(), 1u);
  const render::SolidMesh& mesh = compact.body.meshes[0].mesh;
  EXPECT_LE(mesh.triangles.size() / 3, kMostBodyTriangles);
  EXPECT_GT(mesh.triangles.size() / 3, kMostBodyTriangles / 4);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    Vector3f middle = Vector3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.vertices[mesh.triangles[i + k]].position / 3;
    EXPECT_NEAR((middle - Vector3f(0, 1.6f, 0)).norm(), 0.1f, 0.0005f);
  }
  EXPECT_LT(body_json(compact).size(), 500'000u) << "bytes in the page";
}

TEST(PageBody, PartsTurnAsTheirBonesSay) {
  const auto turning = [](const std::string& bone) {
    return compact_body(ball_on_neck(8, 8), {}, bone).body.meshes[0].turning;
  };
  const std::vector<float> shares = turning("head");
  for (const float share : {0.0f, 0.5f, 1.0f}) EXPECT_TRUE(std::ranges::count(shares, share) > 0) << share;
  EXPECT_TRUE(turning("another").empty()) << "all turns";

  std::vector<render::SolidVertex> vertices(3);
  for (render::SolidVertex& vertex : vertices) vertex = {Vector3f::UnitX(), Vector3f::UnitX()};
  const float half = std::sqrt(0.5f);
  render::turn_back(std::vector<float>{1, 0.5f, 0}, Quat{0, half, 0, half}, vertices);  // the head: 90 degrees about Y
  EXPECT_LT((vertices[0].position - Vector3f::UnitX()).norm(), 1e-5f) << "turns with the head";
  EXPECT_LT((vertices[1].position - Vector3f(half, 0, half)).norm(), 1e-5f) << "half as far";
  EXPECT_LT((vertices[2].normal - Vector3f::UnitZ()).norm(), 1e-5f) << "stays in the world";
}

TEST(PageBody, IsPutIntoThePageOnce) {
  EXPECT_EQ(with_body("<script>@BODY@</script>@BODY@", "{}").value(), "<script>{}</script>@BODY@");
  const auto older = with_body("@NAME@|@ASSET@", "{}");
  ASSERT_FALSE(older);
  EXPECT_NE(older.error().message.find("knows bodies"), std::string::npos);
}

}  // namespace coif::view::page_body_test
