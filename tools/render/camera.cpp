#include "render/camera.h"

#include "base/geometry.h"
#include "base/studio.h"
#include "render/stage_renderer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace coif::render {
namespace {

constexpr double kSpacing = 1.12;  // between heads of a grid, of their own size

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

void aim(Camera& camera, const CameraSettings& settings) {
  const double yaw = radians(settings.yaw_degrees);
  const double pitch = radians(std::clamp(settings.pitch_degrees, -89.0, 89.0));
  camera.back = {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
  camera.right = {std::cos(yaw), 0.0, -std::sin(yaw)};
  camera.up = camera.back.cross(camera.right);
}

/// Offsets in camera space of a grid of cells, row by row from the top, the last row centred.
std::vector<Eigen::Vector2d> grid(const Eigen::Vector2d& cell, const CameraSettings& settings) {
  const double wide = std::sqrt(settings.heads * settings.aspect * cell.y() / cell.x());
  const auto columns = static_cast<std::uint32_t>(std::clamp(std::round(wide), 1.0, double(settings.heads)));
  const std::uint32_t rows = (settings.heads + columns - 1) / columns;
  std::vector<Eigen::Vector2d> places;
  for (std::uint32_t i = 0; i < settings.heads; ++i) {
    const std::uint32_t row = i / columns;
    const std::uint32_t in_row = std::min(columns, settings.heads - row * columns);
    places.emplace_back((i % columns - 0.5 * (in_row - 1.0)) * cell.x(), (0.5 * (rows - 1.0) - row) * cell.y());
  }
  return places;
}

Eigen::Matrix4d perspective(double tan_x, double tan_y, double near, double far) {
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 1.0 / tan_x;
  clip(1, 1) = 1.0 / tan_y;
  clip(2, 2) = (near + far) / (near - far);
  clip(2, 3) = 2.0 * near * far / (near - far);
  clip(3, 2) = -1.0;
  return clip;
}

/// Tangents of half the picture's angles, across and upwards.
Eigen::Vector2d half_tangents(double fov_degrees, double aspect) {
  const double tan_short = std::tan(0.5 * radians(fov_degrees));
  return {tan_short * std::max(aspect, 1.0), tan_short / std::min(aspect, 1.0)};
}

/// Rows: right, up, back.
Eigen::Matrix3d axes_of(const CameraPlace& place) {
  Eigen::Matrix3d axes;
  axes << place.right.transpose(), place.up.transpose(), place.back.transpose();
  return axes;
}

void set_clip(Camera& camera, const Eigen::Vector2d& tangents, double near, double far) {
  const Eigen::Matrix3d axes = axes_of(camera);
  Eigen::Matrix4d view_from_world = Eigen::Matrix4d::Identity();
  view_from_world.topLeftCorner<3, 3>() = axes;
  view_from_world.topRightCorner<3, 1>() = -(axes * camera.eye);
  camera.clip_from_world = (perspective(tangents.x(), tangents.y(), near, far) * view_from_world).cast<float>();
}

}  // namespace

CrowdView view_from(const CameraPlace& place, double aspect, std::span<const Eigen::Vector3d> points) {
  CrowdView view{{}, {Eigen::Vector3d::Zero()}};
  static_cast<CameraPlace&>(view.camera) = place;
  constexpr double kNearest = 0.01;  // metres
  double near = std::numeric_limits<double>::max(), far = 0;
  for (const Eigen::Vector3d& point : points) {
    const double depth = place.back.dot(place.eye - point);
    near = std::min(near, depth);
    far = std::max(far, depth);
  }
  const double room = 0.5 * std::max(far - near, kNearest);  // bodies reach beyond hair and head
  near = std::max(near - room, kNearest);
  set_clip(view.camera, half_tangents(place.fov_degrees, aspect), near, std::max(far + room, 2 * near));
  return view;
}

CrowdView frame_crowd(std::span<const Eigen::Vector3d> points, const CameraSettings& settings) {
  CrowdView view;
  Camera& camera = view.camera;
  aim(camera, settings);
  camera.fov_degrees = settings.fov_degrees;
  const Eigen::Matrix3d axes = axes_of(camera);

  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(Eigen::Vector3d(axes * point));
  const Eigen::Vector3d center = box.center();
  const Eigen::Vector2d size = box.sizes().head<2>().cwiseMax(1e-3);
  Eigen::Vector2d reach = Eigen::Vector2d::Zero();  // The grid's outermost places.
  for (const Eigen::Vector2d& place : grid(kSpacing * size, settings)) {
    reach = reach.cwiseMax(place.cwiseAbs());
    view.places.push_back(camera.right * place.x() + camera.up * place.y());
  }

  const Eigen::Vector2d tangents = half_tangents(settings.fov_degrees, settings.aspect);
  double distance = 0;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = axes * point - center;
    distance = std::max({distance, (std::abs(p.x()) + reach.x()) / tangents.x() + p.z(),
                         (std::abs(p.y()) + reach.y()) / tangents.y() + p.z()});
  }
  distance *= settings.margin;

  const double depth = box.max().z() - box.min().z() + size.norm();  // swinging hair may leave the box
  const double near = std::max(distance - depth, 0.02 * distance);
  camera.eye = axes.transpose() * (center + Eigen::Vector3d(0, 0, distance));
  set_clip(camera, tangents, near, distance + depth);
  return view;
}

double yaw_of_face(const Asset& asset) { return (asset.skeleton().flags & kSkeletonFacesBackwards) != 0 ? 180 : 0; }

std::vector<Eigen::Vector3d> framed_points(const Asset& asset) {
  std::vector<Eigen::Vector3d> points;
  for (const VertexRecord& vertex : asset.vertices()) {
    points.push_back(Eigen::Map<const Eigen::Vector3f>(vertex.position).cast<double>());
  }
  for (const SolidMesh& mesh : mannequin_meshes(asset.colliders())) {
    for (const SolidVertex& v : mesh.vertices) points.push_back(v.position.cast<double>());
  }
  return points;
}

DrawDesc studio_desc(const Camera& camera, std::span<const Light> lights) {
  DrawDesc desc;
  Eigen::Map<Eigen::Matrix4f>{desc.clip_from_world} = camera.clip_from_world;
  desc.eye = to_vec3(camera.eye);
  desc.lights = lights;
  desc.framebuffer_is_srgb = true;
  return desc;
}

tl::expected<void, ToolError> check_drawable(const Asset& asset) {
  if (asset.is_open() && !asset.vertices().empty() && !asset.indices().empty()) return {};
  return failure(ToolError::Kind::kBadInput,
                 "the asset has no mesh to draw; cook it again without leaving the mesh out");
}

std::array<Light, 3> camera_lights(std::span<const StudioLight, 3> own, const Camera& camera) {
  std::array<Light, 3> lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& [right, up, back] = own[i].towards;
    const auto& [red, green, blue] = own[i].color;
    const Eigen::Vector3d towards = camera.right * double(right) + camera.up * double(up) + camera.back * double(back);
    lights[i] = {Light::Kind::kDirectional, to_vec3(towards), {red, green, blue}};
  }
  return lights;
}

std::array<Light, 3> studio_lights(const Camera& camera) { return camera_lights(kStudioLights, camera); }

}  // namespace coif::render
