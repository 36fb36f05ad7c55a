#include "cook/select_hair.h"

#include "cook/disjoint_sets.h"
#include "cook/name_pattern.h"
#include "cook/weld.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace coif {
namespace {

using Names = std::vector<std::string>;

tl::unexpected<ToolError> bad_input(const SourceModel& source, const std::string& what) {
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: {}", source.path, what)});
}

std::string material_name(const SourceModel& source, const SourceMesh& mesh) {
  return mesh.material < source.materials.size() ? source.materials[mesh.material].name : "";
}

/// An error that names the first pattern without a match and what there is to match.
tl::expected<void, ToolError> check_patterns(const SourceModel& source, const char* key, const Names& patterns,
                                             const std::set<std::string>& names) {
  for (const std::string& pattern : patterns) {
    if (std::ranges::any_of(names, [&](const std::string& name) { return matches(name, pattern); })) continue;
    return bad_input(source, fmt::format("recipe key \"hair.{}\": nothing is called '{}'; there are: {}", key, pattern,
                                         fmt::join(names, ", ")));
  }
  return {};
}

tl::expected<void, ToolError> check_all_patterns(const SourceModel& source, const Recipe& recipe) {
  std::set<std::string> meshes, materials, nodes;
  for (const SourceMesh& mesh : source.meshes) {
    meshes.insert(mesh.name);
    materials.insert(material_name(source, mesh));
  }
  for (const SourceNode& node : source.nodes) nodes.insert(node.name);
  if (auto ok = check_patterns(source, "meshes", recipe.hair_meshes, meshes); !ok) return ok;
  if (auto ok = check_patterns(source, "materials", recipe.hair_materials, materials); !ok) return ok;
  return check_patterns(source, "bones", recipe.hair_bones, nodes);
}

/// The meshes that may hold hair, before bones cut further.
std::vector<std::uint32_t> candidate_meshes(const SourceModel& source, const Recipe& recipe) {
  const Names hair_word{"*hair*"};
  const bool named = !recipe.hair_meshes.empty() || !recipe.hair_materials.empty();
  const bool by_word = !named && recipe.hair_bones.empty();
  std::vector<std::uint32_t> result;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const std::string& name = source.meshes[m].name;
    const std::string material = material_name(source, source.meshes[m]);
    const bool mesh_fits = recipe.hair_meshes.empty() || matches_any(name, recipe.hair_meshes);
    const bool material_fits = recipe.hair_materials.empty() || matches_any(material, recipe.hair_materials);
    const bool word_fits = !by_word || matches_any(name, hair_word) || matches_any(material, hair_word);
    if (mesh_fits && material_fits && word_fits) result.push_back(m);
  }
  if (result.empty() && by_word) {
    for (std::uint32_t m = 0; m < source.meshes.size(); ++m) result.push_back(m);
  }
  return result;
}

/// Per mesh and place, true where the connected piece has a triangle that the recipe's bones move more than others do.
std::vector<bool> vertices_near_bones(const SourceModel& source, const SourceMesh& mesh, const Recipe& recipe) {
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, recipe.patch_weld_distance);
  DisjointSets pieces(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    pieces.unite(place[mesh.triangles[t]], place[mesh.triangles[t + 1]]);
    pieces.unite(place[mesh.triangles[t]], place[mesh.triangles[t + 2]]);
  }
  const auto share = [&](std::uint32_t v) {
    if (mesh.influence_begin.empty()) return matches_any(source.nodes[mesh.node].name, recipe.hair_bones) ? 1.0f : 0.0f;
    float sum = 0;
    for (std::uint32_t k = mesh.influence_begin[v]; k < mesh.influence_begin[v + 1]; ++k) {
      const SourceInfluence& influence = mesh.influences[k];
      if (matches_any(source.nodes[influence.node].name, recipe.hair_bones)) sum += influence.weight;
    }
    return sum;
  };
  std::vector<bool> piece_is_hair(mesh.positions.size(), false), result(mesh.positions.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const float sum = share(mesh.triangles[t]) + share(mesh.triangles[t + 1]) + share(mesh.triangles[t + 2]);
    if (sum > 1.5f) piece_is_hair[pieces.find(place[mesh.triangles[t]])] = true;
  }
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) result[v] = piece_is_hair[pieces.find(place[v])];
  return result;
}

bool is_degenerate(const SourceMesh& mesh, std::size_t t) {
  const Eigen::Vector3f a = mesh.positions[mesh.triangles[t]];
  const Eigen::Vector3f edge1 = mesh.positions[mesh.triangles[t + 1]] - a;
  const Eigen::Vector3f edge2 = mesh.positions[mesh.triangles[t + 2]] - a;
  return edge1.cross(edge2).squaredNorm() <= 1.0e-20f;
}

/// Appends all vertices of `mesh`; attributes that only some meshes have are filled with zeros and mended later.
void append_vertices(const SourceMesh& mesh, bool with_normals, bool with_uvs, HairMesh& out) {
  const std::size_t count = mesh.positions.size();
  out.positions.insert(out.positions.end(), mesh.positions.begin(), mesh.positions.end());
  if (with_normals) {
    if (mesh.normals.empty()) out.normals.resize(out.normals.size() + count, Eigen::Vector3f::Zero());
    out.normals.insert(out.normals.end(), mesh.normals.begin(), mesh.normals.end());
  }
  if (with_uvs) {
    if (mesh.uvs.empty()) out.uvs.resize(out.uvs.size() + count, Eigen::Vector2f::Zero());
    out.uvs.insert(out.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
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
  std::size_t other = 0;
  std::size_t degenerate = 0;
};

TakenTriangles append_triangles(const SourceModel& source, const SourceMesh& mesh, const Recipe& recipe,
                                std::uint32_t base, HairMesh& out) {
  const bool cut = !recipe.hair_bones.empty();
  const std::vector<bool> hair = cut ? vertices_near_bones(source, mesh, recipe) : std::vector<bool>{};
  TakenTriangles result;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    if (cut && !hair[mesh.triangles[t]]) {
      ++result.other;
    } else if (is_degenerate(mesh, t)) {
      ++result.degenerate;
    } else {
      ++result.taken;
      for (int k = 0; k < 3; ++k) out.triangles.push_back(base + mesh.triangles[t + std::size_t(k)]);
    }
  }
  return result;
}

void note_left_out(const SourceMesh& mesh, const TakenTriangles& taken, SelectedHair& result) {
  if (taken.other > 0) {
    result.left_out.push_back(fmt::format("mesh '{}': {} triangles that no hair bone moves", mesh.name, taken.other));
  }
  if (taken.degenerate > 0) {
    result.left_out.push_back(fmt::format("mesh '{}': {} triangles without area", mesh.name, taken.degenerate));
  }
}

/// The material with most of the triangles taken.
std::uint32_t main_material(const SourceModel& source, std::span<const std::size_t> taken) {
  std::vector<std::size_t> triangles(source.materials.size(), 0);
  for (std::size_t m = 0; m < taken.size(); ++m) {
    if (source.meshes[m].material < triangles.size()) triangles[source.meshes[m].material] += taken[m];
  }
  const auto most = std::ranges::max_element(triangles);
  return most == triangles.end() || *most == 0 ? kNoIndex : std::uint32_t(most - triangles.begin());
}

struct Gathered {
  std::vector<std::size_t> taken;  ///< Triangles per source mesh.
  std::size_t degenerate = 0;
};

/// Joins the candidates' hair into result.mesh.
Gathered gather(const SourceModel& source, const Recipe& recipe, SelectedHair& result) {
  const std::vector<std::uint32_t> candidates = candidate_meshes(source, recipe);
  const auto any = [&](auto has) {
    return std::ranges::any_of(candidates, [&](std::uint32_t m) { return has(source.meshes[m]); });
  };
  const bool with_normals = any([](const SourceMesh& m) { return !m.normals.empty(); });
  const bool with_uvs = any([](const SourceMesh& m) { return !m.uvs.empty(); });
  Gathered gathered;
  gathered.taken.assign(source.meshes.size(), 0);
  for (std::uint32_t m : candidates) {
    const SourceMesh& mesh = source.meshes[m];
    const auto base = std::uint32_t(result.mesh.positions.size());
    append_vertices(mesh, with_normals, with_uvs, result.mesh);
    const TakenTriangles counts = append_triangles(source, mesh, recipe, base, result.mesh);
    gathered.taken[m] = counts.taken;
    gathered.degenerate += counts.degenerate;
    if (counts.taken == 0) continue;
    result.meshes.push_back(m);
    note_left_out(mesh, counts, result);
  }
  return gathered;
}

void note_other_meshes(const SourceModel& source, const Gathered& gathered, SelectedHair& result) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    if (gathered.taken[m] > 0) continue;
    const SourceMesh& mesh = source.meshes[m];
    result.left_out.push_back(fmt::format("mesh '{}' ({} triangles): not hair", mesh.name, mesh.triangles.size() / 3));
  }
}

void warn_of_materials(const SourceModel& source, SelectedHair& result) {
  std::set<std::uint32_t> materials;
  for (std::uint32_t m : result.meshes) materials.insert(source.meshes[m].material);
  if (materials.size() <= 1 || result.mesh.material == kNoIndex) return;
  result.warnings.push_back(fmt::format("the hair has {} materials; the asset keeps that with most triangles ('{}')",
                                        materials.size(), source.materials[result.mesh.material].name));
}

}  // namespace

tl::expected<SelectedHair, ToolError> select_hair(const SourceModel& source, const Recipe& recipe) {
  if (auto ok = check_all_patterns(source, recipe); !ok) return tl::unexpected(ok.error());
  SelectedHair result;
  result.mesh.influence_begin.push_back(0);
  const Gathered gathered = gather(source, recipe, result);
  if (result.mesh.triangles.empty()) {
    const std::string why =
        gathered.degenerate > 0
            ? fmt::format("all {} triangles are without area; scale the model up or export it again",
                          gathered.degenerate)
            : "no hair triangles; choose them by the recipe's \"hair\"";
    return bad_input(source, why);
  }
  note_other_meshes(source, gathered, result);
  result.mesh.material = main_material(source, gathered.taken);
  warn_of_materials(source, result);
  weld_vertices(result.mesh);
  return result;
}

}  // namespace coif
