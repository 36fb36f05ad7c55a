#include "view/sheet/live_sheet.h"

#include "base/geometry.h"
#include "base/text.h"
#include "motion/head_path.h"
#include "render/camera.h"
#include "view/page/view_settings.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace coif::view {
namespace {

/// The page knows air, but no hands, no sizes and no animations.
bool can_show(const render::PictureSettings& picture) {
  const motion::HairCompany* const company = picture.company.get();
  return company == nullptr || (!company->colliders && !company->pose && company->scale == 1);
}

float number_of_motion(std::string_view word) {
  const std::string words = motion_words(false);
  const std::size_t at = ("|" + words + "|").find("|" + std::string(word) + "|");
  return at == std::string::npos ? 0 : float(std::count(words.begin(), words.begin() + std::ptrdiff_t(at), '|'));
}

void set_material(const Asset& asset, const MaterialRecord& material, ViewSettings& s) {
  const MaterialRecord own = material_of(asset, settings_of(asset));
  for (int k = 0; k < 3; ++k) {
    s.base_color[k] = own.base_color[k] != 0 ? material.base_color[k] / own.base_color[k] : 1;
  }
  set_look(material, s);
}

/// The number that means `wanted`; 0 where none does.
template <typename Meaning, typename Wanted>
float choice_of(const Meaning& meaning, const Wanted& wanted) {
  constexpr int kMostChoices = 16;
  for (int number = 0; number < kMostChoices; ++number) {
    if (meaning(float(number)) == wanted) return float(number);
  }
  return 0;
}

void set_air(const Asset& asset, const render::PictureSettings& picture, ViewSettings& s) {
  const Vec3& wind = picture.step.environment.wind;
  s.wind = std::hypot(wind.x, wind.z);
  if (s.wind > 0)
    s.wind_from = float(std::atan2(-double(wind.x), -double(wind.z)) / kDegree - render::yaw_of_face(asset));
  if (picture.company) s.gusts = picture.company->gusts.amplitude;
}

ViewSettings tile_settings(const Asset& asset, const render::Gallery& gallery, const render::PictureSettings& picture) {
  ViewSettings s = settings_of(asset);
  s.yaw = float(picture.yaw_degrees);
  s.pitch = float(picture.pitch_degrees);
  s.motion = number_of_motion(gallery.motion);
  s.plays = gallery.motion.empty() ? 0 : 1;
  s.solver = choice_of([](float number) { return &solver_of(number); }, picture.solver);
  s.iterations = float(picture.step.iterations);
  s.shadows = 0;  // As in `coif gallery`.
  s.component = choice_of(
      [](float number) {
        ViewSettings asked;
        asked.component = number;
        return component_of(asked);
      },
      picture.component);
  set_air(asset, picture, s);
  if (picture.material) set_material(asset, *picture.material, s);
  return s;
}

/// Factor by which hair must be smaller than at rest so that its motion stays in the picture, with the same middle.
tl::expected<float, ToolError> zoom_of_motion(const Asset& asset, const render::PictureSettings& picture) {
  const auto moving = render::frame_picture(asset, picture);
  if (!moving) return tl::unexpected(moving.error());
  std::vector<Eigen::Vector3d> points = render::framed_points(asset);
  const render::CameraSettings camera{.yaw_degrees = picture.yaw_degrees + render::yaw_of_face(asset),
                                      .pitch_degrees = picture.pitch_degrees,
                                      .aspect = double(picture.width) / picture.height};
  const render::CrowdView still = render::frame_crowd(points, camera);
  const Eigen::Matrix3d axes =
      (Eigen::Matrix3d() << still.camera.right, still.camera.up, still.camera.back).finished().transpose();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(Eigen::Vector3d(axes * point));
  const Eigen::Vector3d middle = axes.transpose() * box.center();
  // A point that is as far on the other side does not change a frame with this middle.
  for (const Eigen::Vector3d& point : moving->points) {
    points.push_back(point);
    points.emplace_back(2 * middle - point);
  }
  const render::CrowdView wide = render::frame_crowd(points, camera);
  const auto distance = [&](const render::CrowdView& view) { return (view.camera.eye - middle).dot(view.camera.back); };
  return float(std::min(distance(still) / distance(wide), 1.0));
}

/// One tile that plays the motion of the gallery's moments.
tl::expected<LiveTile, ToolError> playing_tile(const Asset& asset, const render::Gallery& gallery) {
  const render::PictureSettings& last = gallery.pictures.back().settings;
  LiveTile tile{gallery.title, tile_settings(asset, gallery, last), {}};
  const auto zoom = zoom_of_motion(asset, last);
  if (!zoom) return tl::unexpected(zoom.error());
  tile.settings.zoom = *zoom;
  for (const auto& [caption, picture] : gallery.pictures) tile.moments.push_back({caption, picture.time});
  return tile;
}

std::string note_of(const std::vector<std::string>& left_out, std::size_t pictures, bool has_moments) {
  std::string note;
  if (has_moments) note = "The moments of a motion share a tile, which plays it.";
  if (left_out.empty()) return note;
  note += note.empty() ? "" : " ";
  return note + fmt::format("Left out, as the page cannot show them but a SHEET.png can: {} ({}).",
                            fmt::join(left_out, "; "), counted(pictures, "picture", "pictures"));
}

}  // namespace

tl::expected<LiveSheet, ToolError> live_sheet(const Asset& asset, std::span<const render::Gallery> galleries) {
  LiveSheet sheet;
  std::vector<std::string> left_out;
  bool has_moments = false;
  for (const render::Gallery& gallery : galleries) {
    const auto shown = [](const render::GalleryPicture& picture) { return can_show(picture.settings); };
    if (gallery.pictures.empty() || !std::ranges::all_of(gallery.pictures, shown)) {
      left_out.push_back(gallery.title);
      sheet.pictures_left_out += gallery.pictures.size();
      continue;
    }
    LiveGallery live{gallery.title, {}};
    if (!gallery.motion.empty()) {
      auto tile = playing_tile(asset, gallery);
      if (!tile) return tl::unexpected(tile.error());
      live.tiles.push_back(std::move(*tile));
      has_moments = true;
    } else {
      for (const auto& [caption, picture] : gallery.pictures) {
        live.tiles.push_back({caption, tile_settings(asset, gallery, picture), {}});
      }
    }
    sheet.tiles += live.tiles.size();
    sheet.galleries.push_back(std::move(live));
  }
  sheet.note = note_of(left_out, sheet.pictures_left_out, has_moments);
  return sheet;
}

}  // namespace coif::view
