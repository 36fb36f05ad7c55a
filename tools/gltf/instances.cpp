#include "gltf/tree.h"

#include "gltf/accessors.h"
#include "gltf/document.h"

#include <utility>

namespace coif::gltf {
namespace {

constexpr const char* kInstanceAttributes[] = {"TRANSLATION", "ROTATION", "SCALE"};

/// The attributes' numbers, empty where the file gives none.
struct InstanceNumbers {
  std::vector<float> of[3];
  std::size_t count = 0;

  [[nodiscard]] Eigen::Vector3d vector(int attribute, std::size_t i, double otherwise) const {
    if (of[attribute].empty()) return Eigen::Vector3d::Constant(otherwise);
    return Eigen::Map<const Eigen::Vector3f>(&of[attribute][3 * i]).cast<double>();
  }
  [[nodiscard]] Eigen::Quaterniond turn(std::size_t i) const {
    if (of[1].empty()) return Eigen::Quaterniond::Identity();
    const Eigen::Quaterniond turn = Eigen::Map<const Eigen::Quaternionf>(&of[1][4 * i]).cast<double>();
    return turn.norm() > 1e-3 ? turn.normalized() : Eigen::Quaterniond::Identity();
  }
};

}  // namespace

tl::expected<std::vector<Eigen::Affine3d>, std::string> read_gltf_instances(const nlohmann::json& document,
                                                                            GltfBuffers& buffers,
                                                                            const nlohmann::json& node) {
  const nlohmann::json& attributes = member(extension(node, "EXT_mesh_gpu_instancing"), "attributes");
  if (!attributes.is_object()) return std::vector{Eigen::Affine3d::Identity()};
  InstanceNumbers numbers;
  for (int k = 0; k < 3; ++k) {
    const nlohmann::json& accessor = member(attributes, kInstanceAttributes[k]);
    if (accessor.is_null()) continue;
    const std::size_t width = k == 1 ? 4 : 3;
    auto read = read_gltf_numbers(document, buffers, accessor, {k == 1 ? "VEC4" : "VEC3", width, kMostInstances});
    if (!read) return fault("{} of its instances: {}", kInstanceAttributes[k], read.error());
    const std::size_t count = read->size() / width;
    if (numbers.count != 0 && count != numbers.count) return fault("its instances have attributes of unlike length");
    numbers.count = count;
    numbers.of[k] = std::move(*read);
  }
  std::vector<Eigen::Affine3d> out;
  for (std::size_t i = 0; i < numbers.count; ++i)
    out.push_back(gltf_placed(numbers.vector(0, i, 0), numbers.turn(i), numbers.vector(2, i, 1)));
  return out;
}

}  // namespace coif::gltf
