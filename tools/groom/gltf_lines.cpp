#include "groom/join_lines.h"
#include "groom/strand_files.h"

#include "base/files.h"
#include "import/gltf_document.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace coif {
namespace {

using nlohmann::json;

constexpr std::string_view kMembers[] = {"accessors", "bufferViews", "buffers", "meshes", "nodes", "scene", "scenes"};

// glTF 2.0, 3.7.2.1: what a primitive's vertices are.
enum Mode : std::uint32_t { kLines = 1, kLineLoop = 2, kLineStrip = 3 };

Eigen::Vector3d vector_or(const json& value, double otherwise) {
  return vector_of(value).value_or(Eigen::Vector3d::Constant(otherwise));
}

/// From the node's own space to its parent's; what is no such transform is none.
Eigen::Affine3d parent_from(const json& node) {
  Eigen::Affine3d out = Eigen::Affine3d::Identity();
  const json& matrix = list_of(member(node, "matrix"));
  if (matrix.size() == 16) {
    for (std::size_t i = 0; i < 16; ++i)
      out.matrix()(Eigen::Index(i % 4), Eigen::Index(i / 4)) = number_of(matrix[i]).value_or(0);
    return out.matrix().allFinite() ? out : Eigen::Affine3d::Identity();
  }
  const json& turn = list_of(member(node, "rotation"));
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  if (turn.size() == 4) {
    for (std::size_t i = 0; i < 4; ++i) rotation.coeffs()[Eigen::Index(i)] = number_of(turn[i]).value_or(0);
  }
  if (!(rotation.norm() > 1e-6)) rotation.setIdentity();
  return out.translate(vector_or(member(node, "translation"), 0))
      .rotate(rotation.normalized())
      .scale(vector_or(member(node, "scale"), 1));
}

class LineScene {
 public:
  LineScene(const json& document, GltfBuffers& buffers, Groom& groom)
      : document_(document),
        buffers_(buffers),
        builder_(groom),
        nodes_(list_of(member(document, "nodes"))),
        seen_(nodes_.size(), false) {}

  /// Of the scene's nodes and all below, each once: files may have loops.
  std::string read() {
    const json& scenes = list_of(member(document_, "scenes"));
    const json& chosen = member(document_, "scene");
    const auto scene = chosen.is_null() ? std::optional<std::uint32_t>(0) : index_of(chosen, scenes.size());
    if (!scene || *scene >= scenes.size()) return "has no scene";
    push(member(scenes[*scene], "nodes"), Eigen::Affine3d::Identity());
    while (!open_.empty()) {
      const auto [index, above] = open_.back();
      open_.pop_back();
      const json& node = nodes_[index];
      const Eigen::Affine3d placed = above * parent_from(node);
      if (std::string fault = read_mesh(node, placed); !fault.empty()) return fmt::format("node {}: {}", index, fault);
      push(member(node, "children"), placed);
    }
    return builder_.finish();
  }

 private:
  void push(const json& list, const Eigen::Affine3d& above) {
    const json& indices = list_of(list);
    for (std::size_t i = indices.size(); i-- > 0;) {
      const auto index = index_of(indices[i], nodes_.size());
      if (!index || seen_[*index]) continue;
      seen_[*index] = true;
      open_.emplace_back(*index, above);
    }
  }

  std::string read_mesh(const json& node, const Eigen::Affine3d& placed) {
    const json& meshes = list_of(member(document_, "meshes"));
    const auto mesh = index_of(member(node, "mesh"), meshes.size());
    if (!mesh) return {};
    std::string name = printable_text_of(member(node, "name"));
    builder_.begin_group(name.empty() ? printable_text_of(member(meshes[*mesh], "name")) : std::move(name));
    for (const json& primitive : list_of(member(meshes[*mesh], "primitives"))) {
      const json& mode = member(primitive, "mode");
      const auto kind = mode.is_null() ? std::optional<std::uint32_t>(4) : index_of(mode, 7);
      if (kind != kLines && kind != kLineLoop && kind != kLineStrip) continue;
      if (std::string fault = read_lines(primitive, *kind, placed); !fault.empty())
        return fmt::format("mesh {}: {}", *mesh, fault);
    }
    return {};
  }

  std::string read_lines(const json& primitive, std::uint32_t mode, const Eigen::Affine3d& placed) {
    const auto numbers = read_gltf_numbers(document_, buffers_, member(member(primitive, "attributes"), "POSITION"),
                                           {.type = "VEC3", .width = 3, .most_elements = kMostStrandPoints});
    if (!numbers) return numbers.error();
    std::vector<Eigen::Vector3f> places(numbers->size() / 3);
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] = (placed * Eigen::Vector3f(&(*numbers)[3 * i]).cast<double>()).cast<float>();
    }
    std::vector<std::uint32_t> indices(places.size());
    std::iota(indices.begin(), indices.end(), 0u);
    if (!member(primitive, "indices").is_null()) {
      auto listed = read_gltf_indices(document_, buffers_, member(primitive, "indices"), kMostStrandPoints);
      if (!listed) return listed.error();
      indices = std::move(*listed);
    }
    if (std::ranges::any_of(indices, [&](std::uint32_t v) { return v >= places.size(); }))
      return "an index beyond the vertices";
    add(mode, indices, places);
    return {};
  }

  void add(std::uint32_t mode, std::vector<std::uint32_t>& indices, const std::vector<Eigen::Vector3f>& places) {
    VertexLines lines;
    if (mode == kLineLoop && !indices.empty()) indices.push_back(indices.front());
    if (mode == kLines) {
      for (std::size_t i = 0; i + 1 < indices.size(); i += 2) lines.add(std::span(indices).subspan(i, 2));
      weld(lines, places);
    } else if (indices.size() > 1) {
      lines.add(indices);
    }
    std::vector<Eigen::Vector3f> points;
    const VertexLines strands = mode == kLines ? joined_lines(lines, places.size()).strands : std::move(lines);
    for (std::size_t i = 0; i < strands.count(); ++i) {
      points.clear();
      for (const std::uint32_t v : strands.line(i)) points.push_back(places[v]);
      builder_.add(points);
    }
  }

  /// Exporters may give each segment two vertices of its own: a segment that begins where the one before it ended goes on.
  static void weld(VertexLines& lines, const std::vector<Eigen::Vector3f>& places) {
    for (std::size_t i = 3; i < lines.vertices.size(); i += 2) {
      std::uint32_t& begin = lines.vertices[i - 1];
      const std::uint32_t before = lines.vertices[i - 2];
      if (begin != before && places[begin] == places[before]) begin = before;
    }
  }

  const json& document_;
  GltfBuffers& buffers_;
  GroomBuilder builder_;
  const json& nodes_;
  std::vector<bool> seen_;
  std::vector<std::pair<std::uint32_t, Eigen::Affine3d>> open_;
};

}  // namespace

tl::expected<Groom, std::string> read_gltf_lines(const std::filesystem::path& path,
                                                 std::span<const std::filesystem::path> roots) {
  const auto document = read_gltf_json(path, kMembers);
  if (!document) return tl::unexpected(document.error());
  Groom groom;
  groom.format = "glTF 2.0";
  groom.space.unit = Statement::kDeclared;
  groom.space.unit_words = "glTF is in metres";
  groom.space.up = Statement::kDeclared;
  groom.space.up_words = "glTF has Y up";
  GltfBuffers buffers(path, *document, folders_of_source(path, roots));
  if (std::string fault = LineScene(*document, buffers, groom).read(); !fault.empty())
    return tl::unexpected(std::move(fault));
  return groom;
}

}  // namespace coif
