#include "cook/select/select_hair.h"

#include "cook/recipe/hair_recipe.h"
#include "cook/select/mesh_topology.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cook {
namespace {

constexpr std::size_t kTriangleBytes = 3 * sizeof(std::uint32_t);  ///< Bytes in an asset's indices.

bool is_degenerate(const importer::SourceMesh& mesh, std::size_t t) {
  const Eigen::Vector3f a = mesh.positions[mesh.triangles[t]];
  const Eigen::Vector3f edge1 = mesh.positions[mesh.triangles[t + 1]] - a;
  const Eigen::Vector3f edge2 = mesh.positions[mesh.triangles[t + 2]] - a;
  return edge1.cross(edge2).squaredNorm() <= 1.0e-20f;
}

/// The attributes that at least one of the meshes has.
struct WantedAttributes {
  bool normals = false, uvs = false, colors = false;
};

/// Appends all vertices of `mesh`; attributes that only some meshes have are filled with zeros and mended later,
/// colours with white.
void append_vertices(const importer::SourceMesh& mesh, const WantedAttributes& wanted, HairMesh& out) {
  const std::size_t count = mesh.positions.size();
  out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
  if (wanted.normals) {
    if (mesh.normals.empty()) out.normals.resize(out.normals.size() + count, Eigen::Vector3f::Zero());
    out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
  }
  if (wanted.uvs) {
    if (mesh.uvs.empty()) out.uvs.resize(out.uvs.size() + count, Eigen::Vector2f::Zero());
    out.uvs.insert(out.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
  }
  if (wanted.colors) {
    if (mesh.colors.empty()) out.colors.resize(out.colors.size() + count, Eigen::Vector4f::Ones());
    out.colors.insert(out.colors.end(), mesh.colors.begin(), mesh.colors.end());
  }
  for (std::uint32_t v = 0; v < count; ++v) {
    if (mesh.influence_begin.empty()) {
      out.influences.push_back({mesh.node, 1.0f});
    } else {
      out.influences.insert(out.influences.end(), mesh.influences.begin() + mesh.influence_begin[v],
                            mesh.influences.begin() + mesh.influence_begin[v + 1]);
    }
    out.influence_begin.push_back(std::uint32_t(out.influences.size()));
  }
}

struct TakenTriangles {
  std::size_t taken = 0;
  std::size_t degenerate = 0;
};

TakenTriangles append_triangles(const importer::SourceModel& source, std::uint32_t m, const HairChoice& choice,
                                std::uint32_t base, HairMesh& out) {
  const importer::SourceMesh& mesh = source.meshes[m];
  TakenTriangles result;
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
    if (!choice.takes(m, t)) continue;
    if (is_degenerate(mesh, 3 * t)) {
      ++result.degenerate;
      continue;
    }
    ++result.taken;
    out.mesh_of_triangle.push_back(m);
    for (std::size_t k = 0; k < 3; ++k) out.triangles.push_back(base + mesh.triangles[3 * t + k]);
  }
  return result;
}

/// The material of most of the triangles taken.
std::uint32_t main_material(const importer::SourceModel& source, std::span<const std::size_t> taken) {
  std::vector<std::size_t> triangles(source.materials.size(), 0);
  for (std::size_t m = 0; m < taken.size(); ++m) {
    if (source.meshes[m].material < triangles.size()) triangles[source.meshes[m].material] += taken[m];
  }
  const auto most = std::ranges::max_element(triangles);
  return most == triangles.end() || *most == 0 ? importer::kNoIndex : std::uint32_t(most - triangles.begin());
}

/// The file's pose becomes the hair's shape at rest, though a pose is not meant for that.
void warn_of_pose(const importer::SourceModel& source, std::span<const std::size_t> taken, Findings& findings) {
  const importer::SourceMesh* farthest = nullptr;
  for (std::size_t m = 0; m < taken.size(); ++m) {
    const importer::SourceMesh& mesh = source.meshes[m];
    if (taken[m] == 0 || mesh.posed_node == importer::kNoIndex) continue;
    if (farthest == nullptr || mesh.posed_degrees > farthest->posed_degrees) farthest = &mesh;
  }
  if (farthest == nullptr) return;
  findings.warn("C114",
                fmt::format("mesh '{}': its bones stand otherwise than when it was bound to them ('{}' by {:.0f} "
                            "degrees): the file was saved in a "
                            "pose, and that pose is taken for the hair's shape at rest; put the armature into its rest "
                            "position and export "
                            "again where that is not meant",
                            farthest->name, source.nodes[farthest->posed_node].name, double(farthest->posed_degrees)));
}

struct Gathered {
  HairMesh mesh;
  std::vector<std::size_t> taken;  ///< Triangles per source mesh.
  std::size_t degenerate = 0;
};

/// Joins the chosen triangles.
Gathered gather(const importer::SourceModel& source, const HairChoice& choice, Findings& findings) {
  const auto any = [&](auto has) {
    for (std::size_t m = 0; m < source.meshes.size(); ++m) {
      if (!choice.taken[m].empty() && has(source.meshes[m])) return true;
    }
    return false;
  };
  const WantedAttributes wanted{any([](const importer::SourceMesh& m) { return !m.normals.empty(); }),
                                any([](const importer::SourceMesh& m) { return !m.uvs.empty(); }),
                                any([](const importer::SourceMesh& m) { return !m.colors.empty(); })};
  Gathered gathered;
  gathered.mesh.influence_begin.push_back(0);
  gathered.taken.assign(source.meshes.size(), 0);
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    if (choice.taken[m].empty()) continue;
    const auto base = std::uint32_t(gathered.mesh.positions.size());
    append_vertices(source.meshes[m], wanted, gathered.mesh);
    const TakenTriangles counts = append_triangles(source, m, choice, base, gathered.mesh);
    gathered.taken[m] = counts.taken;
    gathered.degenerate += counts.degenerate;
    if (counts.taken > 0) gathered.mesh.source_meshes.push_back(m);
    if (counts.degenerate == 0) continue;
    findings.leave_out(
        {fmt::format("mesh '{}', {} triangles", source.meshes[m].name, counts.degenerate), "without area"});
  }
  return gathered;
}

/// Share of the triangles. A file may have each strip several times, but not more copies than anything else.
constexpr double kMostCopies = 0.9;
constexpr std::size_t kFewCopies = 100;
/// Metres from end to end, in a file of any unit that a model may have.
constexpr double kLargestHair = 1000;

std::optional<std::string> why_damaged(const importer::SourceModel& source, const HairMesh& mesh, std::size_t copies,
                                       std::size_t triangles) {
  if (copies >= kFewCopies && double(copies) > kMostCopies * double(triangles)) {
    return fmt::format(
        "{} of the hair's {} triangles lie where others lie, so that {} are left: the file is damaged, or its strips "
        "were "
        "copied into one place; export it again",
        copies, triangles, mesh.triangle_count());
  }
  Eigen::AlignedBox3f box;
  for (const std::uint32_t vertex : mesh.triangles) box.extend(mesh.positions[vertex]);
  const double size = double(box.sizes().norm());
  if (!(size > kLargestHair)) return std::nullopt;
  return fmt::format(
      "the hair is {:.1f} km from end to end, at {} m per unit: a number in the file is damaged, or its unit is wrong; "
      "export it again, or set \"source.metres_per_unit\" in the recipe",
      size / 1000, source.space.metres_per_unit);
}

std::size_t merge_faces(const HairRecipe& recipe, HairMesh& mesh, Findings& findings) {
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, recipe.patch_weld_distance);
  const MergedFaces merged = merge_back_faces(mesh, place);
  if (merged.back_faces > 0) {
    findings.leave_out({fmt::format("{} triangles that only were the back of others", merged.back_faces),
                        "the hair is drawn double-sided", merged.back_faces * kTriangleBytes});
  }
  if (merged.copies > 0) {
    findings.leave_out({fmt::format("{} triangles", merged.copies), "there twice", merged.copies * kTriangleBytes});
  }
  if (!is_closed(mesh, place)) mesh.double_sided = true;
  return merged.copies;
}

}  // namespace

tl::expected<HairMesh, ToolError> select_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                              Findings& findings) {
  const auto choice = choose_hair(source, recipe, findings);
  if (!choice) return tl::unexpected(choice.error());
  Gathered gathered = gather(source, *choice, findings);
  warn_of_pose(source, gathered.taken, findings);
  warn_of_stacked_meshes(source, gathered.mesh.source_meshes, findings);
  if (gathered.mesh.triangles.empty()) {
    const std::string why =
        gathered.degenerate > 0
            ? fmt::format("all {} triangles are without area; scale the model up or export it again",
                          gathered.degenerate)
            : "no hair triangles; choose them by the recipe's \"hair\"";
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: {}", source.path, why)});
  }
  gathered.mesh.material = main_material(source, gathered.taken);
  const std::size_t triangles = gathered.mesh.triangle_count();
  const std::size_t copies = merge_faces(recipe, gathered.mesh, findings);
  if (const auto why = why_damaged(source, gathered.mesh, copies, triangles)) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: {}", source.path, *why)});
  }
  weld_vertices(gathered.mesh);
  return std::move(gathered.mesh);
}

}  // namespace coif::cook
