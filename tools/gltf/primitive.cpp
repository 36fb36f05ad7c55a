#include "gltf/primitive.h"

#include "gltf/accessors.h"
#include "gltf/document.h"
#include "gltf/draco_mesh.h"

#include <numeric>
#include <optional>
#include <utility>

namespace coif::gltf {
namespace {

using nlohmann::json;
using Numbers = tl::expected<std::vector<float>, std::string>;
using Integers = tl::expected<std::vector<std::uint32_t>, std::string>;

constexpr std::size_t kMostInfluenceSets = 4;  // Four influences each; exporters write one or two sets.

const char* type_of_width(std::size_t width) { return width == 2 ? "VEC2" : width == 3 ? "VEC3" : "VEC4"; }

class PrimitiveReader {
 public:
  PrimitiveReader(const json& document, GltfBuffers& buffers, const json& primitive)
      : document_(document),
        buffers_(buffers),
        primitive_(primitive),
        attributes_(member(primitive, "attributes")),
        compression_(extension(primitive, "KHR_draco_mesh_compression")) {}

  tl::expected<GltfPrimitive, std::string> read(std::uint32_t uv_set, std::span<const double> morph_weights) {
    if (auto unpacked = unpack(); !unpacked) return tl::unexpected(unpacked.error());
    auto positions = numbers("POSITION", 3);
    if (!positions) return tl::unexpected(positions.error());
    if (positions->empty()) return fault("POSITION: there is none");
    out_.positions = vectors<3>(*positions);
    const std::string uv_name = fmt::format("TEXCOORD_{}", uv_set);
    auto normals = numbers("NORMAL", 3), uvs = numbers(uv_name.c_str(), 2);
    if (!normals) return tl::unexpected(normals.error());
    if (!uvs) return tl::unexpected(uvs.error());
    out_.normals = vectors<3>(*normals);
    out_.uvs = vectors<2>(*uvs);
    if (std::string bad = read_colors(); !bad.empty()) return tl::unexpected(bad);
    if (std::string bad = read_influences(); !bad.empty()) return tl::unexpected(bad);
    if (std::string bad = add_targets(morph_weights); !bad.empty()) return tl::unexpected(bad);
    if (std::string bad = read_triangles(); !bad.empty()) return tl::unexpected(bad);
    return std::move(out_);
  }

 private:
  tl::expected<void, std::string> unpack() {
    if (!compression_.is_object()) return {};
    const auto view = buffers_.view(member(compression_, "bufferView"));
    if (!view) return fault("its compressed form {}", view.error());
    auto mesh = DracoMesh::decode(view->bytes);
    if (!mesh) return fault("its compressed form {}", mesh.error());
    draco_ = std::move(*mesh);
    return {};
  }

  /// The unique id of the attribute in the compressed data; none where it is not compressed.
  [[nodiscard]] std::optional<std::uint32_t> id_of(const char* name) const {
    return draco_ ? index_of(member(member(compression_, "attributes"), name), kMostPrimitiveVertices) : std::nullopt;
  }

  [[nodiscard]] const json& accessor(const char* name) const {
    const json& accessors = list_of(member(document_, "accessors"));
    const auto index = index_of(member(attributes_, name), accessors.size());
    return index ? accessors[*index] : member(json::object(), name);
  }

  template <class Values>
  Values checked(const char* name, Values values, std::size_t width) const {
    if (!values) return fault("{}: {}", name, values.error());
    const std::size_t count = values->size() / width;
    if (!out_.positions.empty() && count != out_.positions.size()) {
      return fault("{}: there are {} of them, and {} positions", name, count, out_.positions.size());
    }
    return values;
  }

  /// Empty where the primitive has no such attribute.
  Numbers numbers(const char* name, std::size_t width) {
    if (const auto id = id_of(name)) {
      return checked(name, draco_->numbers(*id, width, member(accessor(name), "normalized") == true), width);
    }
    const json& index = member(attributes_, name);
    return index.is_null() ? Numbers() : checked(name, numbers_of(index, width), width);
  }

  Numbers numbers_of(const json& index, std::size_t width) {
    return read_gltf_numbers(document_, buffers_, index,
                             {type_of_width(width), width, kMostPrimitiveVertices, true, true});
  }

  Integers integers(const char* name) {
    if (const auto id = id_of(name)) return checked(name, draco_->integers(*id, 4), 4);
    const json& index = member(attributes_, name);
    return index.is_null() ? Integers()
                           : checked(name, read_gltf_indices(document_, buffers_, index, kMostPrimitiveVertices, 4), 4);
  }

  template <int kWidth>
  static std::vector<Eigen::Matrix<float, kWidth, 1>> vectors(const std::vector<float>& numbers) {
    std::vector<Eigen::Matrix<float, kWidth, 1>> out(numbers.size() / kWidth);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = Eigen::Map<const Eigen::Matrix<float, kWidth, 1>>(&numbers[i * kWidth]);
    return out;
  }

  std::string read_colors() {
    const std::size_t width = member(accessor("COLOR_0"), "type") == "VEC3" ? 3 : 4;
    const auto colors = numbers("COLOR_0", width);
    if (!colors) return colors.error();
    for (std::size_t i = 0; i < colors->size(); i += width) {
      const float* const c = &(*colors)[i];
      out_.colors.emplace_back(c[0], c[1], c[2], width == 4 ? c[3] : 1.0f);
    }
    return {};
  }

  std::string read_influences() {
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
    for (std::size_t set = 0; set < kMostInfluenceSets; ++set) {
      auto of_joints = integers(fmt::format("JOINTS_{}", set).c_str());
      auto of_weights = numbers(fmt::format("WEIGHTS_{}", set).c_str(), 4);
      if (!of_joints) return of_joints.error();
      if (!of_weights) return of_weights.error();
      if (of_joints->empty() != of_weights->empty()) {
        return fmt::format("JOINTS_{0} and WEIGHTS_{0} are not both there", set);
      }
      if (of_joints->empty()) break;
      joints.push_back(std::move(*of_joints));
      weights.push_back(std::move(*of_weights));
    }
    out_.influences = 4 * joints.size();
    for (std::size_t v = 0; v < out_.positions.size(); ++v) {
      for (std::size_t set = 0; set < joints.size(); ++set) {
        for (std::size_t k = 4 * v; k < 4 * v + 4; ++k) {
          out_.joints.push_back(joints[set][k]);
          out_.weights.push_back(weights[set][k]);
        }
      }
    }
    return {};
  }

  std::string add_targets(std::span<const double> morph_weights) {
    const json& targets = list_of(member(primitive_, "targets"));
    for (std::size_t t = 0; t < std::min(morph_weights.size(), targets.size()); ++t) {
      if (morph_weights[t] == 0) continue;
      for (auto [name, to] : {std::pair{"POSITION", &out_.positions}, std::pair{"NORMAL", &out_.normals}}) {
        const json& index = member(targets[t], name);
        if (index.is_null() || to->empty()) continue;
        const Numbers steps = checked(name, numbers_of(index, 3), 3);
        if (!steps) return fmt::format("morph target {}: {}", t, steps.error());
        for (std::size_t v = 0; v < to->size(); ++v) {
          (*to)[v] = ((*to)[v].cast<double>() +
                      morph_weights[t] * Eigen::Map<const Eigen::Vector3f>(&(*steps)[3 * v]).cast<double>())
                         .cast<float>();
        }
      }
    }
    return {};
  }

  std::string read_triangles() {
    if (draco_) {
      out_.triangles = draco_->triangles();
      return {};
    }
    std::vector<std::uint32_t> corners(out_.positions.size());
    std::iota(corners.begin(), corners.end(), 0u);
    if (const json& index = member(primitive_, "indices"); !index.is_null()) {
      auto listed = read_gltf_indices(document_, buffers_, index, 3 * kMostPrimitiveVertices);
      if (!listed) return "indices: " + listed.error();
      corners = std::move(*listed);
    }
    set_triangles(corners);
    return {};
  }

  void set_triangles(std::vector<std::uint32_t>& corners) {
    const GltfMode mode = gltf_mode(primitive_).value_or(GltfMode::kTriangles);
    if (mode == GltfMode::kTriangles) {
      corners.resize(corners.size() / 3 * 3);
      out_.triangles = std::move(corners);
      return;
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const bool is_odd = mode == GltfMode::kStrip && i % 2 == 1;
      const std::uint32_t first = mode == GltfMode::kFan ? corners[0] : corners[i - 2];
      out_.triangles.insert(out_.triangles.end(),
                            {is_odd ? corners[i - 1] : first, is_odd ? first : corners[i - 1], corners[i]});
    }
  }

  const json& document_;
  GltfBuffers& buffers_;
  const json& primitive_;
  const json& attributes_;
  const json& compression_;
  std::optional<DracoMesh> draco_;
  GltfPrimitive out_;
};

}  // namespace

std::optional<GltfMode> gltf_mode(const json& primitive) {
  const json& mode = member(primitive, "mode");
  if (mode.is_null()) return GltfMode::kTriangles;
  const auto number = index_of(mode, 7);
  return number ? std::optional(GltfMode(*number)) : std::nullopt;
}

tl::expected<GltfPrimitive, std::string> read_gltf_primitive(const json& document, GltfBuffers& buffers,
                                                             const json& primitive, std::uint32_t uv_set,
                                                             std::span<const double> morph_weights) {
  return PrimitiveReader(document, buffers, primitive).read(uv_set, morph_weights);
}

}  // namespace coif::gltf
