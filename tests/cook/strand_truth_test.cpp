// How often the cooker is right about which end of a strip is the root, where that is known otherwise: from strands
// that the strips were made along, or from the bones of rigged files, which it is not shown.

#include "cook/built_models.h"
#include "cook/hair_styles.h"
#include "cook/recipe/recipe.h"
#include "cook/select/select_hair.h"
#include "cook/strands/patches.h"
#include "cook/strands/strand_direction.h"
#include "cook/strands/strand_evidence.h"
#include "cook/texture/strand_lines.h"
#include "import/import.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace coif::cook::strand_truth_test {

/// Patches, by how their strands were found to run.
struct Tally {
  std::size_t right = 0, reversed = 0, sideways = 0;

  void add(double cosine) { ++(cosine > 0.5 ? right : cosine < -0.5 ? reversed : sideways); }
  void add(const Tally& other) {
    right += other.right;
    reversed += other.reversed;
    sideways += other.sideways;
  }
  [[nodiscard]] std::size_t all() const { return right + reversed + sideways; }
  [[nodiscard]] double share() const { return all() == 0 ? 1 : double(right) / double(all()); }
  [[nodiscard]] std::string text() const {
    return fmt::format("{:6} patches, {:5.1f} % right, {:4.1f} % reversed, {:4.1f} % sideways", all(), 100 * share(),
                       100.0 * double(reversed) / double(all()), 100.0 * double(sideways) / double(all()));
  }
};

struct Found {
  HairStrips hair;
  StrandField strands;
};

/// What the cook finds before it looks at any bone of the hair.
Found find(HairMesh mesh, const BaseColor& color, const FittedHead& head, std::size_t nodes) {
  Found found;
  found.hair.mesh = std::move(mesh);
  found.hair.welded = weld_places(found.hair.mesh.positions, 0);
  const ExtractedPatches extracted = find_patches(found.hair, Connectivity::kAuto, unheard());
  StrandSettings settings;
  settings.trust_texture = extracted.chosen != Connectivity::kPosition;
  settings.depth_of_node.assign(nodes, 0.0f);
  if (settings.trust_texture) (void)split_folds(found.hair, unheard());
  found.hair.complete_normals();
  const auto find_strands = [&] {
    settings.seen = find_strand_lines(found.hair, color, 1);
    return find_strand_direction(found.hair, head, settings, unheard());
  };
  found.hair.strands = find_strands();
  const std::vector<std::string> roots(found.hair.patches.count, "auto");
  if (split_partings(found.hair, head, roots, unheard()) > 0) found.hair.strands = find_strands();
  found.strands = found.hair.strands;
  return found;
}

/// By area, how far the found way of each patch agrees with `truth`, a way per triangle.
Tally judge(const Found& found, const std::vector<Eigen::Vector3f>& truth) {
  Tally tally;
  for (const PatchView& view : found.hair.views()) {
    double sum = 0, all = 0;
    for (const std::size_t t : view.triangles) {
      const Eigen::Vector3f& way = truth[t / 3];
      const double area = double(doubled_area(found.hair.mesh, t));
      Eigen::Vector3f tangent = Eigen::Vector3f::Zero();
      for (std::size_t k = 0; k < 3; ++k) tangent += found.strands.tangent[found.hair.mesh.triangles[t + k]];
      sum += area * double(tangent.stableNormalized().dot(way.normalized()));
      all += area;
    }
    if (all > 0) tally.add(sum / all);
  }
  return tally;
}

Tally judge_style(const StyledHair& style) {
  HairMesh mesh = hair_from(style.source.meshes.front());
  importer::SourceModel source = style.source;
  source.nodes.resize(1);
  const FittedHead head = fit_head(source, mesh, {}, default_recipe(), unheard());
  BaseColor color;
  color.image = style.image;
  const Found found = find(std::move(mesh), color, head, 1);
  std::vector<Eigen::Vector3f> truth;
  for (std::size_t t = 0; t < found.hair.mesh.triangle_count(); ++t) {
    Eigen::Vector3f way = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) way += style.growth[found.hair.mesh.triangles[3 * t + k]];
    truth.push_back(way);
  }
  return judge(found, truth);
}

/// Few enough to wait for, or as many as COIF_STYLES says.
std::uint32_t style_count() {
  const char* const asked = std::getenv("COIF_STYLES");
  return asked != nullptr ? std::uint32_t(std::strtoul(asked, nullptr, 10)) : 140;
}

TEST(StrandTruth, OfStripsMadeAlongStrands) {
  std::map<std::string, Tally> families;
  Tally all;
  const std::uint32_t count = style_count();
  ASSERT_GT(count, 0u);
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    const StyledHair style = make_style(seed);
    const Tally tally = judge_style(style);
    families[style.family].add(tally);
    all.add(tally);
  }
  for (const auto& [family, tally] : families) fmt::print("{:10} {}\n", family, tally.text());
  fmt::print("{:10} {}\n", "all", all.text());
  EXPECT_GE(all.share(), 0.97);
}

constexpr float kSpeaks = 0.5f;  ///< Bones from one end of a patch to the other; with less they say nothing about it.

/// Bones between each vertex and the head, as its weights have it.
std::vector<float> depth_of_vertices(const HairMesh& mesh, std::span<const float> depth_of_node) {
  std::vector<float> depth;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    float sum = 0;
    for (const importer::SourceInfluence& influence : mesh.influences_of(v))
      sum += influence.weight * depth_of_node[influence.node];
    depth.push_back(sum);
  }
  return depth;
}

/// A patch is right where bones at its tips are farther from the head than at its roots, by a tenth of all that move
/// it.
Tally judge_by_bones(const Found& found, std::span<const float> depth_of_node) {
  const std::vector<float> depth = depth_of_vertices(found.hair.mesh, depth_of_node);
  Tally tally;
  for (const PatchView& view : found.hair.views()) {
    double low = 1e9, high = -1e9;
    std::array<double, 2> sum{}, count{};
    for (const std::uint32_t v : view.vertices) {
      low = std::min(low, double(depth[v]));
      high = std::max(high, double(depth[v]));
      const float place = found.strands.place[v];
      if (place > 0.25f && place < 0.75f) continue;
      sum[place > 0.5f ? 1 : 0] += double(depth[v]);
      count[place > 0.5f ? 1 : 0] += 1;
    }
    if (high - low < kSpeaks) continue;
    const double grows = (sum[1] / count[1] - sum[0] / count[0]) / (high - low);
    ++(grows > 0.1 ? tally.right : grows < -0.1 ? tally.reversed : tally.sideways);
  }
  return tally;
}

constexpr const char* kRigged[] = {"mh_ponytail01/ponytail01_skinned.glb", "unitychan/UnityChan.fbx",
                                   "seedsan/new_seedsan_betterfbx.fbx", "godette/Godette_vrm_v4.vrm",
                                   "churro/ChurroChurro.vrm"};

Tally judge_file(const std::filesystem::path& path) {
  const auto source = importer::import_model(path);
  EXPECT_TRUE(source);
  const Recipe recipe = default_recipe();
  auto mesh = select_hair(*source, recipe, unheard());
  EXPECT_TRUE(mesh);
  const auto color = find_base_color(*source, *mesh, recipe, {}, unheard());
  EXPECT_TRUE(color);
  const auto bone = find_head_bone(*source, *mesh, "");
  EXPECT_TRUE(bone);
  const FittedHead head = fit_head(*source, *mesh, *bone, recipe, unheard());
  const Found found = find(*std::move(mesh), *color, head, source->nodes.size());
  return judge_by_bones(found, depths_below(*source, bone->node));
}

// Bones are truth here and no evidence: the cook itself would look at them.
TEST(StrandTruth, OfRiggedFilesWhoseBonesAreNotLookedAt) {
  const auto folder = std::filesystem::path(COIF_TEST_ASSETS) / "hair";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << ": no corpus of artists' files here";
  Tally all;
  for (const char* name : kRigged) {
    const Tally tally = judge_file(folder / name);
    fmt::print("{:40} {}\n", name, tally.text());
    all.add(tally);
  }
  fmt::print("{:40} {}\n", "all", all.text());
  EXPECT_GE(all.share(), 0.95);
}

}  // namespace coif::cook::strand_truth_test
