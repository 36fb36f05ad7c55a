#include "groom/strand_files.h"

#include "gltf/accessors.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "gltf/primitive.h"
#include "gltf/tree.h"
#include "import/source_warnings.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace coif::groom {
namespace {

using nlohmann::json;

class LineScene {
 public:
  LineScene(const json& document, gltf::GltfBuffers& buffers, Groom& groom)
      : document_(document), buffers_(buffers), builder_(groom), nodes_(list_of(member(document, "nodes"))) {}

  /// Reads the scene's nodes except hidden ones.
  std::string read() {
    for (const gltf::GltfSceneNode& entry : gltf::gltf_scene_nodes(document_)) {
      if (entry.is_hidden) continue;
      const std::string fault = read_mesh(nodes_[entry.in_file], entry.model_from_node);
      if (!fault.empty()) return fmt::format("node {}: {}", entry.in_file, fault);
    }
    return builder_.finish();
  }

 private:
  std::string read_mesh(const json& node, const Eigen::Affine3d& placed) {
    const json& meshes = list_of(member(document_, "meshes"));
    const auto mesh = index_of(member(node, "mesh"), meshes.size());
    if (!mesh) return {};
    std::string name = printable_text_of(member(node, "name"));
    builder_.begin_group(name.empty() ? printable_text_of(member(meshes[*mesh], "name")) : std::move(name));
    for (const json& primitive : list_of(member(meshes[*mesh], "primitives"))) {
      const auto kind = gltf::gltf_mode(primitive);
      if (kind != gltf::GltfMode::kLines && kind != gltf::GltfMode::kLineLoop && kind != gltf::GltfMode::kLineStrip)
        continue;
      if (std::string fault = read_lines(primitive, *kind, placed); !fault.empty())
        return fmt::format("mesh {}: {}", *mesh, fault);
    }
    return {};
  }

  std::string read_lines(const json& primitive, gltf::GltfMode mode, const Eigen::Affine3d& placed) {
    const auto numbers = gltf::read_gltf_numbers(
        document_, buffers_, member(member(primitive, "attributes"), "POSITION"),
        {.type = "VEC3", .width = 3, .most_elements = kMostStrandPoints, .may_be_quantized = true});
    if (!numbers) return numbers.error();
    std::vector<Eigen::Vector3f> places(numbers->size() / 3);
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] = (placed * Eigen::Vector3f(&(*numbers)[3 * i]).cast<double>()).cast<float>();
    }
    std::vector<std::uint32_t> indices(places.size());
    std::iota(indices.begin(), indices.end(), 0u);
    if (!member(primitive, "indices").is_null()) {
      auto listed = gltf::read_gltf_indices(document_, buffers_, member(primitive, "indices"), kMostStrandPoints);
      if (!listed) return listed.error();
      indices = std::move(*listed);
    }
    if (std::ranges::any_of(indices, [&](std::uint32_t v) { return v >= places.size(); }))
      return "an index beyond the vertices";
    add(mode, indices, places);
    return {};
  }

  void add(gltf::GltfMode mode, std::vector<std::uint32_t>& indices, const std::vector<Eigen::Vector3f>& places) {
    VertexLines lines;
    if (mode == gltf::GltfMode::kLineLoop && !indices.empty()) indices.push_back(indices.front());
    if (mode == gltf::GltfMode::kLines) {
      for (std::size_t i = 0; i + 1 < indices.size(); i += 2) lines.add(std::span(indices).subspan(i, 2));
      weld(lines, places);
    } else if (indices.size() > 1) {
      lines.add(indices);
    }
    std::vector<Eigen::Vector3f> points;
    const VertexLines strands =
        mode == gltf::GltfMode::kLines ? joined_lines(lines, places.size()).strands : std::move(lines);
    for (std::size_t i = 0; i < strands.count(); ++i) {
      points.clear();
      for (const std::uint32_t v : strands.line(i)) points.push_back(places[v]);
      builder_.add(points);
    }
  }

  /// Exporters may give each segment two vertices of its own: a segment that begins where the one before it ended
  /// continues it.
  static void weld(VertexLines& lines, const std::vector<Eigen::Vector3f>& places) {
    for (std::size_t i = 3; i < lines.vertices.size(); i += 2) {
      std::uint32_t& begin = lines.vertices[i - 1];
      const std::uint32_t before = lines.vertices[i - 2];
      if (begin != before && places[begin] == places[before]) begin = before;
    }
  }

  const json& document_;
  gltf::GltfBuffers& buffers_;
  GroomBuilder builder_;
  const json& nodes_;
};

}  // namespace

tl::expected<Groom, std::string> read_gltf_lines(const std::filesystem::path& path,
                                                 std::span<const std::filesystem::path> roots) {
  const auto document = gltf::read_gltf_json(path);
  if (!document) return tl::unexpected(document.error());
  Groom groom;
  groom.format = "glTF 2.0";
  groom.space.unit = importer::Statement::kDeclared;
  groom.space.unit_words = "glTF is in metres";
  groom.space.up = importer::Statement::kDeclared;
  groom.space.up_words = "glTF has Y up";
  gltf::GltfBuffers buffers(path, *document, roots);
  if (std::string fault = LineScene(*document, buffers, groom).read(); !fault.empty())
    return tl::unexpected(std::move(fault));
  importer::warn_of_respelled(buffers.respelled(), groom.warnings);
  return groom;
}

}  // namespace coif::groom
