#include "render/gallery.h"

#include "render/camera.h"
#include "render/picture_text.h"
#include "render/stage_renderer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace coif::render {
namespace {

constexpr std::uint32_t kChartColumns = 3;
constexpr std::uint32_t kNobody = ~std::uint32_t{0};
constexpr PictureColor kInk{255, 255, 255}, kMarkedInk{255, 90, 80}, kLabelGround{20, 20, 20};

struct ChartSide {
  const char* name;
  double yaw_degrees, pitch_degrees;
};

constexpr ChartSide kChartSides[] = {{"front", 0, 5},  {"left side", 90, 5},   {"from above", 0, 75},
                                     {"back", 180, 5}, {"right side", -90, 5}, {"back, from below", 180, -35}};

/// The patch that is seen in each pixel: a depth buffer of numbers instead of colours.
class SeenPatches {
 public:
  SeenPatches(std::uint32_t width, std::uint32_t height)
      : width_(width),
        height_(height),
        patch_(std::size_t(width) * height, kNobody),
        depth_(patch_.size(), std::numeric_limits<float>::infinity()) {}

  void draw(const SolidMesh& mesh, const Eigen::Matrix4f& clip_from_head, std::uint32_t patch) {
    std::vector<Eigen::Vector3f> pixels;
    for (const SolidVertex& vertex : mesh.vertices) {
      const Eigen::Vector4f clip = clip_from_head * vertex.position.homogeneous();
      const Eigen::Vector3f device = clip.head<3>() / clip.w();
      pixels.push_back({(device.x() + 1) * float(width_) / 2, (1 - device.y()) * float(height_) / 2, device.z()});
    }
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
      fill({pixels[mesh.triangles[t]], pixels[mesh.triangles[t + 1]], pixels[mesh.triangles[t + 2]]}, patch);
    }
  }

  /// Per patch the pixels in which it is seen.
  [[nodiscard]] std::vector<std::vector<Eigen::Vector2i>> pixels_of(std::size_t patches) const {
    std::vector<std::vector<Eigen::Vector2i>> pixels(patches);
    for (std::size_t i = 0; i < patch_.size(); ++i) {
      if (patch_[i] < patches) pixels[patch_[i]].push_back({int(i % width_), int(i / width_)});
    }
    return pixels;
  }

 private:
  void fill(const std::array<Eigen::Vector3f, 3>& c, std::uint32_t patch) {
    const auto cross = [](const Eigen::Vector2f& a, const Eigen::Vector2f& b) { return a.x() * b.y() - a.y() * b.x(); };
    const Eigen::Vector2f a = c[0].head<2>(), ab = c[1].head<2>() - a, ac = c[2].head<2>() - a;
    const float area = cross(ab, ac);
    if (area == 0 || !std::isfinite(area)) return;
    const auto limit = [](float value, std::uint32_t most) { return int(std::clamp(value, 0.0f, float(most))); };
    const auto [left, right] = std::minmax({c[0].x(), c[1].x(), c[2].x()});
    const auto [top, bottom] = std::minmax({c[0].y(), c[1].y(), c[2].y()});
    for (int y = limit(top, height_); y < limit(bottom + 1, height_); ++y) {
      for (int x = limit(left, width_); x < limit(right + 1, width_); ++x) {
        const Eigen::Vector2f from = Eigen::Vector2f(float(x) + 0.5f, float(y) + 0.5f) - a;
        const float u = cross(from, ac) / area, v = cross(ab, from) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const float depth = c[0].z() + u * (c[1].z() - c[0].z()) + v * (c[2].z() - c[0].z());
        const std::size_t at = std::size_t(y) * width_ + std::size_t(x);
        if (!(depth < depth_[at])) continue;
        depth_[at] = depth;
        patch_[at] = patch;
      }
    }
  }

  std::uint32_t width_, height_;
  std::vector<std::uint32_t> patch_;
  std::vector<float> depth_;
};

/// The pixel nearest to the middle of all of them: the middle of a crescent is not on it.
Eigen::Vector2i middle_pixel(std::span<const Eigen::Vector2i> pixels) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2i& pixel : pixels) mean += pixel.cast<double>() / double(pixels.size());
  return *std::ranges::min_element(
      pixels, {}, [&](const Eigen::Vector2i& pixel) { return (pixel.cast<double>() - mean).squaredNorm(); });
}

/// Puts labels on the patches, the most visible first, as long as none covers another.
void draw_labels(std::span<const std::vector<Eigen::Vector2i>> pixels_of, std::span<const PatchLabel> labels,
                 Picture& picture) {
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t p) { return pixels_of[p].size(); });
  const std::uint32_t dot = std::max(1u, picture.width / 480);
  std::vector<Eigen::AlignedBox2i> taken;
  for (const std::size_t p : order) {
    const PictureText text(labels[p].text, picture.width, dot);
    const Eigen::Vector2i size(int(text.width() + 2 * dot), int(text.height() - dot));
    if (pixels_of[p].size() < std::size_t(size.x()) * std::size_t(size.y()) / 4)
      return;  // Further patches are smaller still.
    const Eigen::Vector2i last(int(picture.width) - size.x() - 1, int(picture.height) - size.y() - 1);
    const Eigen::Vector2i corner = (middle_pixel(pixels_of[p]) - size / 2).cwiseMin(last).cwiseMax(0);
    const Eigen::AlignedBox2i box(corner, corner + size);
    if (std::ranges::any_of(taken, [&](const Eigen::AlignedBox2i& other) { return other.intersects(box); })) continue;
    taken.push_back(box);
    const auto x = std::uint32_t(corner.x()), y = std::uint32_t(corner.y());
    fill_rectangle(picture, x, y, x + std::uint32_t(size.x()), y + std::uint32_t(size.y()), kLabelGround);
    text.draw(picture, x + dot, y + dot, labels[p].is_marked ? kMarkedInk : kInk);
  }
}

}  // namespace

tl::expected<GallerySheet, ToolError> render_patch_chart(const Asset& asset, std::span<const PatchLabel> labels,
                                                         const PatchChartSettings& settings,
                                                         const std::function<void(const std::string&)>& progress) {
  if (auto checked = check_tile_size(settings.width, settings.height); !checked) return tl::unexpected(checked.error());
  auto maker = PictureMaker::create(asset);
  if (!maker) return tl::unexpected(maker.error());
  const auto pose = motion::simulate_pose(asset, nullptr, 0, {});
  if (!pose) return tl::unexpected(pose.error());
  const std::vector<SolidMesh> patches = patch_surfaces(asset, pose->palette, 0);
  const std::vector<SolidMesh> head = mannequin_meshes(asset.colliders());
  PictureSettings picture;
  picture.width = settings.width;
  picture.height = settings.height;
  picture.warm_up = false;
  picture.patches = true;
  GallerySheet result;
  SheetSection section{settings.title, {}};
  std::string device;
  for (const ChartSide& side : kChartSides) {
    progress(side.name);
    picture.yaw_degrees = side.yaw_degrees;
    picture.pitch_degrees = side.pitch_degrees;
    auto taken = maker->take(picture);
    if (!taken) return tl::unexpected(taken.error());
    device = taken->device;
    const auto frame = frame_picture(asset, picture);
    if (!frame) return tl::unexpected(frame.error());
    Eigen::Matrix4f clip_from_head = Eigen::Matrix4f::Identity();
    clip_from_head.topRightCorner<3, 1>() = frame->view.places.front().cast<float>();
    clip_from_head = frame->view.camera.clip_from_world * clip_from_head;
    SeenPatches seen(settings.width, settings.height);
    for (std::uint32_t p = 0; p < patches.size(); ++p) seen.draw(patches[p], clip_from_head, p);
    for (const SolidMesh& mesh : head) seen.draw(mesh, clip_from_head, kNobody);
    draw_labels(seen.pixels_of(labels.size()), labels, *taken);
    section.tiles.push_back({side.name, std::move(*taken)});
    ++result.pictures;
  }
  result.sheet = contact_sheet({&section, 1}, kChartColumns);
  result.sheet.device = device;
  return result;
}

}  // namespace coif::render
