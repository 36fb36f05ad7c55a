#include "import/gltf_scene.h"

#include "base/text.h"
#include "gltf/accessors.h"
#include "gltf/document.h"
#include "gltf/primitive.h"
#include "gltf/tree.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

namespace coif::importer {
namespace {

using Eigen::Affine3d;
using nlohmann::json;

constexpr std::size_t kMostJoints = 65536;
constexpr std::size_t kMostPlacedVertices = std::size_t{1} << 26;  // All meshes and instances together.

class MeshReader {
 public:
  MeshReader(const json& document, gltf::GltfBuffers& buffers, const GltfNodes& nodes, const std::vector<GltfUvs>& uvs,
             SourceModel& model)
      : document_(document),
        buffers_(buffers),
        nodes_(nodes),
        uvs_(uvs),
        model_(model),
        meshes_(list_of(member(document, "meshes"))) {}

  std::string read(const std::string& variant) {
    if (std::string bad = choose_variant(variant); !bad.empty()) return bad;
    for (std::uint32_t n = 0; n < model_.nodes.size(); ++n) {
      if (nodes_.in_file[n] == kNoIndex) continue;
      const json& node = list_of(member(document_, "nodes"))[nodes_.in_file[n]];
      if (member(node, "mesh").is_null()) continue;
      if (nodes_.is_hidden[n]) {
        hidden_.push_back(model_.nodes[n].name);
      } else if (std::string bad = read_node(node, n); !bad.empty()) {
        return bad;
      }
    }
    warn_of_hidden(hidden_, model_.warnings);
    return {};
  }

 private:
  /// Finds the variant's number among the document's.
  std::string choose_variant(const std::string& wanted) {
    if (wanted.empty()) return {};
    std::vector<std::string> names;
    for (const json& entry : list_of(member(gltf::extension(document_, "KHR_materials_variants"), "variants"))) {
      names.push_back(printable_text_of(member(entry, "name")));
    }
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) {
      if (names.empty())
        return fmt::format("it has no variants, and '{}' is asked for; remove source.variant from the recipe", wanted);
      return fmt::format("it has no variant '{}'; there are '{}'", wanted, fmt::join(names, "', '"));
    }
    variant_ = std::uint32_t(found - names.begin());
    return {};
  }

  std::string read_node(const json& node, std::uint32_t n) {
    const auto mesh = index_of(member(node, "mesh"), meshes_.size());
    if (!mesh) {
      warn(model_.warnings, source_code::kRepaired, "node '{}': refers to an absent mesh", model_.nodes[n].name);
      return {};
    }
    auto instances = gltf::read_gltf_instances(document_, buffers_, node);
    if (!instances) return fmt::format("node '{}': {}", model_.nodes[n].name, instances.error());
    const auto [carrier, carrier_from_node] = carrier_of(n);
    for (Affine3d& instance : *instances) instance = carrier_from_node * instance;
    const json& primitives = list_of(member(meshes_[*mesh], "primitives"));
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      RawMesh raw;
      raw.name = mesh_name(*mesh, carrier, p, primitives.size());
      if (std::string bad = read_primitive(meshes_[*mesh], primitives[p], node, raw); !bad.empty()) {
        return fmt::format("mesh '{}', {}", raw.name, bad);
      }
      if (std::string bad = place(raw, carrier, *instances); !bad.empty()) return bad;
    }
    return {};
  }

  /// The node that carries the mesh of node `n`, and the mesh's transform in it. Packing tools put the mesh into a
  /// nameless node of its own, below its former node, to undo the packing of its numbers.
  [[nodiscard]] std::pair<std::uint32_t, Affine3d> carrier_of(std::uint32_t n) const {
    const json& in_file = list_of(member(document_, "nodes"));
    const auto is_named = [&](std::uint32_t at) {
      return !printable_text_of(member(in_file[nodes_.in_file[at]], "name")).empty();
    };
    const std::uint32_t parent = model_.nodes[n].parent;
    const json& node = in_file[nodes_.in_file[n]];
    const bool is_of_packing = !is_named(n) && list_of(member(node, "children")).empty() && parent != kNoIndex &&
                               nodes_.in_file[parent] != kNoIndex && is_named(parent);
    const auto place = is_of_packing ? gltf::gltf_place(node) : std::nullopt;
    return place ? std::pair(parent, place->parent_from_node) : std::pair(n, Affine3d::Identity());
  }

  [[nodiscard]] std::string mesh_name(std::uint32_t mesh, std::uint32_t carrier, std::size_t primitive,
                                      std::size_t count) const {
    std::string name = printable_text_of(member(meshes_[mesh], "name"));
    const json& node = list_of(member(document_, "nodes"))[nodes_.in_file[carrier]];
    if (name.empty()) name = printable_text_of(member(node, "name"));
    if (name.empty()) name = fmt::format("meshes[{}]", mesh);
    return count > 1 ? fmt::format("{}-{}", name, primitive) : name;
  }

  /// Weights of the targets: the node's, or else the mesh's.
  std::vector<double> morph_weights(const json& mesh, const json& node) {
    const json& own = list_of(member(node, "weights"));
    std::vector<double> weights;
    for (const json& weight : own.empty() ? list_of(member(mesh, "weights")) : own)
      weights.push_back(number_of(weight).value_or(0));
    return weights;
  }

  void tell_of_morphs(const json& mesh, const std::string& name, std::span<const double> weights) {
    const json& names = list_of(member(member(mesh, "extras"), "targetNames"));
    std::vector<std::string> on;
    for (std::size_t t = 0; t < weights.size(); ++t) {
      if (weights[t] == 0) continue;
      const std::string known = t < names.size() ? printable_text_of(names[t]) : "";
      on.push_back(fmt::format("'{}' at {:g}", known.empty() ? fmt::format("target {}", t) : known, weights[t]));
    }
    if (on.empty() || !told_of_morphs_.emplace(&mesh, true).second) return;
    warn_of_shape_keys(name, on, model_.warnings);
  }

  /// From the file, or one where it does not say.
  [[nodiscard]] std::size_t count_of_lines(const json& primitive, gltf::GltfMode mode) const {
    const json& accessors = list_of(member(document_, "accessors"));
    const json& indices = member(primitive, "indices");
    const auto index =
        index_of(indices.is_null() ? member(member(primitive, "attributes"), "POSITION") : indices, accessors.size());
    const std::size_t count =
        index ? index_of(member(accessors[*index], "count"), std::size_t{1} << 31).value_or(0) : 0;
    return std::max<std::size_t>(mode == gltf::GltfMode::kLines                    ? count / 2
                                 : mode == gltf::GltfMode::kLineStrip && count > 0 ? count - 1
                                                                                   : count,
                                 1);
  }

  std::string read_primitive(const json& mesh, const json& primitive, const json& node, RawMesh& raw) {
    const auto mode = gltf::gltf_mode(primitive);
    if (!mode)
      return fmt::format("primitive of mode {}, which there is not; export again",
                         excerpt(member(primitive, "mode").dump(-1, ' ', true, json::error_handler_t::replace), 20));
    if (*mode < gltf::GltfMode::kTriangles) {
      raw.points_and_lines = count_of_lines(primitive, *mode);
      return {};
    }
    raw.material = material_of(primitive);
    const GltfUvs uvs = raw.material < uvs_.size() ? uvs_[raw.material] : GltfUvs{};
    const std::vector<double> weights = morph_weights(mesh, node);
    auto read = gltf::read_gltf_primitive(document_, buffers_, primitive, uvs.set, weights);
    if (!read) return read.error();
    if (!list_of(member(primitive, "targets")).empty()) tell_of_morphs(mesh, raw.name, weights);
    warn_of_lost_uvs(*read, uvs, raw);
    raw.positions = std::move(read->positions);
    raw.normals = std::move(read->normals);
    raw.uvs = std::move(read->uvs);
    raw.colors = std::move(read->colors);
    raw.triangles = std::move(read->triangles);
    if (!uvs.image_from_uv.matrix().isIdentity(0)) {
      for (Eigen::Vector2f& uv : raw.uvs) uv = uvs.image_from_uv * uv;
    }
    return read_skin(node, *read, raw);
  }

  void warn_of_lost_uvs(const gltf::GltfPrimitive& read, const GltfUvs& uvs, const RawMesh& raw) {
    if (uvs.set == 0 || !read.uvs.empty()) return;
    warn(model_.warnings, source_code::kUvs,
         "mesh '{}': its texture lies in UV set {}, which the mesh lacks; export that UV map too", raw.name, uvs.set);
  }

  /// The variant's, where one is chosen and the primitive has one for it.
  std::uint32_t material_of(const json& primitive) {
    const json* chosen = &member(primitive, "material");
    for (const json& mapping : list_of(member(gltf::extension(primitive, "KHR_materials_variants"), "mappings"))) {
      for (const json& entry : list_of(member(mapping, "variants"))) {
        if (variant_ && index_of(entry, 1 << 20) == *variant_) chosen = &member(mapping, "material");
      }
    }
    if (const auto index = index_of(*chosen, uvs_.size())) return *index;
    if (!chosen->is_null() && !std::exchange(told_of_material_, true))
      warn(model_.warnings, source_code::kMaterials, "a mesh refers to an absent material; a plain one is used");
    if (!plain_) {
      plain_ = static_cast<std::uint32_t>(model_.materials.size());
      SourceMaterial& plain = model_.materials.emplace_back();
      plain.alpha_use = AlphaUse::kOpaque;
      plain.roughness = 1;
    }
    return *plain_;
  }

  std::string read_skin(const json& node, const gltf::GltfPrimitive& read, RawMesh& raw) {
    const json& skins = list_of(member(document_, "skins"));
    const json& named = member(node, "skin");
    if (named.is_null() || read.influences == 0) return {};
    const auto skin = index_of(named, skins.size());
    if (!skin) {
      warn(model_.warnings, source_code::kSkin, "mesh '{}': refers to an absent skin; it is taken as rigid", raw.name);
      return {};
    }
    std::vector<std::uint32_t> bone_of_joint;
    if (std::string bad = read_bones(skins[*skin], raw, bone_of_joint); !bad.empty()) return "skin: " + bad;
    for (std::size_t i = 0; i < read.joints.size(); ++i) {
      if (read.weights[i] == 0) continue;
      const auto vertex = static_cast<std::uint32_t>(i / read.influences);
      const std::uint32_t bone = read.joints[i] < bone_of_joint.size() ? bone_of_joint[read.joints[i]] : kNoIndex;
      raw.weights.push_back({vertex, bone, read.weights[i]});
    }
    return {};
  }

  /// A bone for each joint, by its place in the list: names may repeat.
  std::string read_bones(const json& skin, RawMesh& raw, std::vector<std::uint32_t>& bone_of_joint) {
    const json& joints = list_of(member(skin, "joints"));
    const json& inverse = member(skin, "inverseBindMatrices");
    std::vector<float> matrices;
    if (!inverse.is_null()) {
      auto read = gltf::read_gltf_numbers(document_, buffers_, inverse, {"MAT4", 16, kMostJoints, false, true});
      if (!read) return read.error();
      matrices = std::move(*read);
    }
    std::size_t absent = 0, unusable = 0;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      bone_of_joint.push_back(kNoIndex);
      const auto in_file = index_of(joints[j], nodes_.of_file.size());
      if (!in_file || nodes_.of_file[*in_file] == kNoIndex) {
        ++absent;
        continue;
      }
      RawBone bone{nodes_.of_file[*in_file]};
      const bool has_matrix = 16 * (j + 1) <= matrices.size();
      if (has_matrix)
        bone.bone_from_mesh.matrix().topRows<3>() =
            Eigen::Map<const Eigen::Matrix4f>(&matrices[16 * j]).topRows<3>().cast<double>();
      if (!bone.bone_from_mesh.matrix().allFinite() || (!matrices.empty() && !has_matrix)) {
        ++unusable;
        continue;
      }
      bone_of_joint.back() = static_cast<std::uint32_t>(raw.bones.size());
      raw.bones.push_back(bone);
    }
    const std::string label = fmt::format("mesh '{}'", raw.name);
    warn_count(model_.warnings, source_code::kSkin, absent, label, "bones dropped: they are no nodes of the scene");
    warn_count(model_.warnings, source_code::kSkin, unusable, label,
               "bones dropped: their bind matrix is absent or not finite");
    return {};
  }

  std::string place(RawMesh& raw, std::uint32_t carrier, std::span<const Affine3d> instances) {
    for (const Affine3d& instance : instances) {
      placed_vertices_ += raw.positions.size();
      if (placed_vertices_ > kMostPlacedVertices)
        return fmt::format("its meshes and instances have more than {} vertices; {}", kMostPlacedVertices, kReduce);
      raw.node_from_mesh = instance;
      keep_mesh(raw, place_mesh(raw, carrier, model_.nodes, model_.warnings), model_.meshes, model_.warnings);
    }
    return {};
  }

  const json& document_;
  gltf::GltfBuffers& buffers_;
  const GltfNodes& nodes_;
  const std::vector<GltfUvs>& uvs_;
  SourceModel& model_;
  const json& meshes_;
  std::optional<std::uint32_t> variant_;
  std::optional<std::uint32_t> plain_;
  bool told_of_material_ = false;
  std::map<const json*, bool> told_of_morphs_;  // looked up only
  std::vector<std::string> hidden_;
  std::size_t placed_vertices_ = 0;
};

}  // namespace

std::string read_gltf_meshes(const json& document, gltf::GltfBuffers& buffers, const GltfNodes& nodes,
                             const std::vector<GltfUvs>& uvs, const std::string& variant, SourceModel& model) {
  return MeshReader(document, buffers, nodes, uvs, model).read(variant);
}

}  // namespace coif::importer
