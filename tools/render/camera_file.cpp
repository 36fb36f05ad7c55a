#include "render/camera_file.h"

#include "base/files.h"
#include "base/geometry.h"
#include "base/json.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::render {
namespace {

constexpr const char* kLightNames[] = {"key", "fill", "rim"};

nlohmann::ordered_json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Unit and at right angles but for rounding.
bool are_axes(const CameraPlace& camera) {
  constexpr double kRounding = 1e-3;
  Eigen::Matrix3d axes;
  axes << camera.right, camera.up, camera.back;
  return axes.determinant() > 0 && (axes.transpose() * axes).isApprox(Eigen::Matrix3d::Identity(), kRounding);
}

}  // namespace

std::optional<Eigen::Vector3d> vector_of_json(const nlohmann::json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  Eigen::Vector3d v;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = number_of(json[k]);
    if (!number) return std::nullopt;
    v[Eigen::Index(k)] = *number;
  }
  return v;
}

nlohmann::ordered_json camera_json(const CameraPlace& camera, const Eigen::Vector3d& joint) {
  return {{"eye", vector_json(camera.eye + joint)},
          {"right", vector_json(camera.right)},
          {"up", vector_json(camera.up)},
          {"back", vector_json(camera.back)},
          {"fov_degrees", camera.fov_degrees}};
}

nlohmann::ordered_json lights_json(std::span<const Light> lights) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    list.push_back({{"name", i < std::size(kLightNames) ? kLightNames[i] : fmt::format("{}", i)},
                    {"towards", vector_json(to_eigen(lights[i].from).cast<double>().normalized())},
                    {"color", vector_json(to_eigen(lights[i].color).cast<double>())}});
  }
  return list;
}

tl::expected<CameraPlace, std::string> camera_of_json(const nlohmann::json& json, const Eigen::Vector3d& joint) {
  const nlohmann::json& inner = member(json, "camera");
  const nlohmann::json& own = inner.is_object() ? inner : json;
  CameraPlace camera;
  for (const auto& [name, place] :
       {std::pair{"eye", &camera.eye}, {"right", &camera.right}, {"up", &camera.up}, {"back", &camera.back}}) {
    const auto v = vector_of_json(member(own, name));
    if (!v) return tl::unexpected(fmt::format("its camera has no three numbers '{}'", name));
    *place = *v;
  }
  camera.eye -= joint;
  if (!are_axes(camera)) {
    return tl::unexpected(std::string("the camera's 'right', 'up' and 'back' are not unit vectors at right angles"));
  }
  const auto fov = number_of(member(own, "fov_degrees"));
  if (!fov || !(*fov >= 1 && *fov <= 150))
    return tl::unexpected(std::string("its camera has no 'fov_degrees' of 1 to 150"));
  camera.fov_degrees = *fov;
  return camera;
}

tl::expected<std::vector<Light>, std::string> lights_of_json(const nlohmann::json& json) {
  if (!json.is_array() || json.size() > kMaxLights) {
    return tl::unexpected(fmt::format("'lights' is no list of at most {}", kMaxLights));
  }
  std::vector<Light> lights;
  for (const nlohmann::json& one : json) {
    const auto towards = vector_of_json(member(one, "towards")), color = vector_of_json(member(one, "color"));
    if (!towards || !(towards->norm() > 0)) return tl::unexpected(std::string("a light has no direction 'towards'"));
    if (!color || !(color->minCoeff() >= 0))
      return tl::unexpected(std::string("a light has no 'color' of three numbers from 0"));
    lights.push_back({Light::Kind::kDirectional, to_vec3(*towards), to_vec3(*color)});
  }
  return lights;
}

tl::expected<CameraPlace, ToolError> read_camera(const std::filesystem::path& path, const Eigen::Vector3d& joint) {
  const auto bytes = FileBytes::read(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto span = bytes->span();
  const auto json = parse_shallow_json({reinterpret_cast<const char*>(span.data()), span.size()});
  const auto camera = json ? camera_of_json(*json, joint) : tl::unexpected(json.error());
  if (!camera) return file_failure(ToolError::Kind::kBadInput, path.string(), "{}", camera.error());
  return *camera;
}

Eigen::Vector3d joint_of(const Asset& asset) {
  return Eigen::Map<const Eigen::Vector3f>(asset.skeleton().head_joint).cast<double>();
}

}  // namespace coif::render
