#include "cli/issue_pictures.h"

#include "render/picture.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif {
namespace {

constexpr std::size_t kMostPictures = 12;

std::vector<std::uint32_t> patches_of(std::span<const Issue> issues) {
  std::vector<std::uint32_t> patches;
  for (const Issue& issue : issues) {
    const bool known = issue.patch && std::ranges::find(patches, *issue.patch) != patches.end();
    if (issue.patch && !known && patches.size() < kMostPictures) patches.push_back(*issue.patch);
  }
  return patches;
}

Eigen::Vector3d middle_of(const Asset& asset, std::span<const std::uint32_t> corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t corner : corners) {
    sum += Eigen::Vector3f(asset.vertices()[corner].position).cast<double>();
  }
  return sum / double(corners.size());
}

PictureSettings look_at(const Asset& asset, std::uint32_t patch) {
  PictureSettings settings;
  settings.width = settings.height = 360;
  settings.patches = true;
  while (settings.lod + 1 < asset.lods().size() && patch >= asset.lods()[settings.lod + 1].first_patch) ++settings.lod;
  settings.marked_patch = patch - (asset.lods().empty() ? 0 : asset.lods()[settings.lod].first_patch);
  const PatchRecord& record = asset.patches()[patch];
  const Eigen::Vector3d from = middle_of(asset, asset.indices().subspan(record.first_index, record.index_count)) -
                               middle_of(asset, asset.lod_indices(settings.lod));
  constexpr double kDegrees = 180 / std::numbers::pi;
  settings.yaw_degrees = std::atan2(from.x(), from.z()) * kDegrees;
  settings.pitch_degrees = std::clamp(std::atan2(from.y(), std::hypot(from.x(), from.z())) * kDegrees, -30.0, 60.0);
  settings.warm_up = false;
  return settings;
}

}  // namespace

IssuePictures picture_issues(const Asset& asset, std::span<const Issue> issues) {
  IssuePictures result;
  const std::vector<std::uint32_t> patches = patches_of(issues);
  if (patches.empty()) return result;
  auto maker = PictureMaker::create(asset);
  if (!maker) {
    result.why_none = maker.error().message;
    return result;
  }
  for (const std::uint32_t patch : patches) {
    const auto picture = maker->take(look_at(asset, patch));
    if (!picture) {
      result.why_none = picture.error().message;
      return result;
    }
    result.pictures.push_back({patch, encode_png(*picture)});
  }
  return result;
}

}  // namespace coif
