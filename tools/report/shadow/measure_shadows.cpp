#include "report/shadow/measure_shadows.h"
#include "report/shadow/deep_shadow_map.h"

#include "base/timing.h"
#include "motion/head_path.h"
#include "render/camera.h"
#include "render/egl_context.h"
#include "render/picture.h"
#include "render/stage_renderer.h"

#include <GLES3/gl3.h>
#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kLeastSize = 16, kMostSize = 4096;
constexpr double kLeastSpacing = 0.0005, kMostSpacing = 0.02;
constexpr double kTurnSeconds = 0.45;  // hair at its furthest
constexpr unsigned kTimedRuns = 3;
constexpr float kPixel = 0.0005f;         // metres: fine enough that textures keep their detail
constexpr float kAside = 0.25f * kPixel;  // along both axes
constexpr float kBound = 0.02f;           // error that the CPU's deep shadow maps may have
constexpr char kOnProcessor[] = "deep-shadow-cpu";

tl::expected<void, ToolError> check(const Asset& asset, const ShadowSettings& settings) {
  const auto size_ok = [](std::uint32_t size) { return size >= kLeastSize && size <= kMostSize; };
  const bool spacing_ok = settings.spacing >= kLeastSpacing && settings.spacing <= kMostSpacing;
  if (settings.sizes.empty() || !std::ranges::all_of(settings.sizes, size_ok) || !spacing_ok) {
    return failure(ToolError::Kind::kUsage,
                   "a shadow's map has 16 to 4096 texels each way, and the reference's lines are 0.5 to 20 mm apart");
  }
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) {
    return failure(ToolError::Kind::kBadInput,
                   "the asset has no mesh to cast shadows; cook it again without leaving the mesh out");
  }
  return {};
}

/// Lights of the kind that games have: sun, sky light before the face, rim light, lamp at the side.
std::vector<ShadowLight> measured_lights() {
  return {{"above", 20, 80}, {"front", 0, 30}, {"side", 90, 20}, {"back", 170, 30}, {"low", 40, -20}};
}

Eigen::Vector3f towards(const ShadowLight& light) {
  const double yaw = light.yaw_degrees * std::numbers::pi / 180, pitch = light.pitch_degrees * std::numbers::pi / 180;
  return Eigen::Vector3d(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch))
      .cast<float>();
}

struct Pose {
  std::string name;
  std::vector<Mat34> palette;
};

tl::expected<std::vector<Pose>, ToolError> make_poses(const Asset& asset) {
  std::vector<Pose> poses;
  const auto add = [&](const char* name, const motion::HeadPath* path,
                       double seconds) -> tl::expected<void, ToolError> {
    auto pose = motion::simulate_pose(asset, path, seconds, {});
    if (!pose) return tl::unexpected(pose.error());
    poses.push_back({name, std::move(pose->palette)});
    return {};
  };
  if (auto added = add("rest", nullptr, 0); !added) return tl::unexpected(added.error());
  if (asset.dynamics().empty()) return poses;
  if (auto added = add("turn", motion::path_of(motion::Motion::kTurn).get(), kTurnSeconds); !added) {
    return tl::unexpected(added.error());
  }
  return poses;
}

/// A technique with its map and its probe.
struct Measured {
  ShadowDesc desc;
  render::StudioShadow shadow;
  ShadowProbe probe;
};

/// Everything that lives in the OpenGL context.
class ShadowMeasurement {
 public:
  static tl::expected<std::unique_ptr<ShadowMeasurement>, ToolError> create(const Asset& asset,
                                                                            const ShadowSettings& settings,
                                                                            const ReportProgress& progress) {
    auto context = render::EglContext::create();
    if (!context) return tl::unexpected(context.error());
    std::unique_ptr<ShadowMeasurement> made(new ShadowMeasurement(asset, settings, progress, std::move(*context)));
    if (auto begun = made->begin(); !begun) return tl::unexpected(begun.error());
    return made;
  }

  tl::expected<ShadowReport, ToolError> run() {
    const auto poses = make_poses(asset_);
    if (!poses) return tl::unexpected(poses.error());
    for (const Pose& pose : *poses) {
      const std::vector<Eigen::Vector3f> positions = visibility::posed_positions(asset_, pose.palette);
      for (const ShadowLight& light : report_.lights) {
        const visibility::FragmentView seen(surface_, positions, {towards(light), float(settings_.spacing), kPixel});
        add_truth(light, seen, positions);
        const std::vector<ShadowPoint> points = shadow_points(seen, surface_, positions);
        if (auto done = add_light(pose, light, points); !done) return tl::unexpected(done.error());
        for (const std::uint32_t size : settings_.sizes) add_on_processor(pose, light, positions, points, size);
      }
    }
    report_.truth_rmse = agreement_.rmse();
    report_.truth_compared = agreement_.compared();
    report_.aside = kAside * std::numbers::sqrt2_v<float>;
    report_.totals = shadow_totals(report_.rows);
    return std::move(report_);
  }

 private:
  ShadowMeasurement(const Asset& asset, const ShadowSettings& settings, const ReportProgress& progress,
                    render::EglContext&& context)
      : asset_(asset), settings_(settings), progress_(progress), surface_(asset), context_(std::move(context)) {
    report_.device = context_.device();
    report_.spacing = settings.spacing;
    report_.lights = measured_lights();
  }

  tl::expected<void, ToolError> begin() {
    if (renderer_.create(context_.loader()) != Status::kOk) {
      return failure(ToolError::Kind::kUnsupported, std::string("the renderer does not start: ") + renderer_.failure());
    }
    if (const Status status = model_.upload(renderer_, asset_); status != Status::kOk) {
      return failure(ToolError::Kind::kUnsupported, std::string("the driver refuses the asset: ") + describe(status));
    }
    auto stage = render::StageRenderer::create(render::mannequin_meshes(asset_.colliders()));
    if (!stage) return tl::unexpected(stage.error());
    stage_ = std::move(*stage);
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    ball_ = render::ball_around(render::framed_points(asset_), {&origin, 1});
    for (const std::uint32_t size : settings_.sizes) {
      const std::initializer_list<ShadowDesc> descs = {{.technique = &kPlainShadow, .size = size},
                                                       {.technique = &kOpacityShadow, .size = size, .layers = 4},
                                                       {.technique = &kOpacityShadow, .size = size, .layers = 12},
                                                       {.technique = &kDeepOpacityShadow, .size = size, .layers = 4},
                                                       {.technique = &kDeepOpacityShadow, .size = size, .layers = 8},
                                                       {.technique = &kDeepShadow, .size = size, .layers = 4},
                                                       {.technique = &kDeepShadow, .size = size, .layers = 6}};
      for (const ShadowDesc& desc : descs) {
        if (auto added = add_technique(desc); !added) return added;
      }
    }
    return {};
  }

  tl::expected<void, ToolError> add_technique(const ShadowDesc& desc) {
    auto shadow = render::StudioShadow::create(renderer_, context_.loader(), desc);
    if (!shadow) return tl::unexpected(shadow.error());
    auto probe = ShadowProbe::create(shadow->shadow());
    if (!probe) return tl::unexpected(probe.error());
    measured_.push_back({desc, std::move(*shadow), std::move(*probe)});
    return {};
  }

  tl::expected<void, ToolError> add_light(const Pose& pose, const ShadowLight& light,
                                          const std::vector<ShadowPoint>& points) {
    if (progress_) progress_(fmt::format("{}: light from {}", pose.name, light.name));
    const auto heads = std::ranges::count(points, true, &ShadowPoint::is_head);
    report_.head_points += std::uint64_t(heads);
    report_.hair_points += points.size() - std::uint64_t(heads);
    add_row({.technique = "none", .light = light.name, .pose = pose.name}, points,
            std::vector<float>(points.size(), 1.0f));
    for (Measured& one : measured_) {
      const auto ms = draw(one, pose, light);
      if (!ms) return tl::unexpected(ms.error());
      const auto asked = std::chrono::steady_clock::now();
      const std::vector<float> found = one.probe.light_at(points);
      add_row({.technique = name_of(*one.desc.technique),
               .layers = one.desc.layers,
               .size = one.desc.size,
               .light = light.name,
               .pose = pose.name,
               .ms = *ms,
               .read_ns = nanoseconds_since(asked) / double(points.size()),
               .bytes = one.shadow.shadow().bytes()},
              points, found);
    }
    return {};
  }

  /// Deep shadow maps as published, without a device.
  void add_on_processor(const Pose& pose, const ShadowLight& light, std::span<const Eigen::Vector3f> positions,
                        const std::vector<ShadowPoint>& points, std::uint32_t size) {
    const float texel = 2 * ball_.radius / float(size);
    const auto start = std::chrono::steady_clock::now();
    const visibility::FragmentView seen(surface_, positions, {towards(light), texel, texel});
    const DeepShadowMap map(seen, towards(light), texel, kBound);
    const double made = nanoseconds_since(start);
    const auto asked = std::chrono::steady_clock::now();
    std::vector<float> found;
    found.reserve(points.size());
    for (const ShadowPoint& point : points) found.push_back(map.light_at(point));
    add_row({.technique = kOnProcessor,
             .size = size,
             .light = light.name,
             .pose = pose.name,
             .ms = made * 1e-6,
             .read_ns = nanoseconds_since(asked) / double(points.size()),
             .bytes = map.bytes()},
            points, found);
  }

  void add_truth(const ShadowLight& light, const visibility::FragmentView& seen,
                 std::span<const Eigen::Vector3f> positions) {
    const visibility::ViewGrid moved{
        .towards_eye = towards(light), .spacing = float(settings_.spacing), .pixel = kPixel, .aside = kAside};
    agreement_.add(seen, visibility::FragmentView(surface_, positions, moved), surface_, positions);
  }

  static double nanoseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  }

  void add_row(ShadowRow row, const std::vector<ShadowPoint>& points, const std::vector<float>& light) {
    row.hair = shadow_error(points, light, false);
    row.head = shadow_error(points, light, true);
    report_.rows.push_back(std::move(row));
  }

  /// Milliseconds, median.
  tl::expected<double, ToolError> draw(Measured& one, const Pose& pose, const ShadowLight& from) {
    const Eigen::Vector3f direction = towards(from);
    const Light light{Light::Kind::kDirectional, {direction.x(), direction.y(), direction.z()}};
    const HeadPose head;  // lights are in head space
    const HairInstance instance{head, pose.palette};
    const ShadowCrowd crowd{&model_, {&instance, 1}};
    std::vector<double> samples;
    for (unsigned run = 0; run <= kTimedRuns; ++run) {
      glFinish();
      const auto start = std::chrono::steady_clock::now();
      const Status status = one.shadow.draw(light, ball_, stage_, {&head, 1}, &crowd);
      if (status != Status::kOk) {
        return failure(ToolError::Kind::kUnsupported, std::string("the shadow cannot be drawn: ") + describe(status));
      }
      glFinish();
      const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
      if (run > 0) samples.push_back(took.count());  // The first run also pays for work that drivers put off.
    }
    return SideBySideTiming::summarize(std::move(samples)).seconds;
  }

  const Asset& asset_;
  const ShadowSettings& settings_;
  const ReportProgress& progress_;
  visibility::HairSurface surface_;
  render::EglContext context_;
  HairRenderer renderer_;
  HairModel model_;
  render::StageRenderer stage_;
  ShadowBall ball_;
  std::vector<Measured> measured_;
  TruthAgreement agreement_;
  ShadowReport report_;
};

}  // namespace

tl::expected<ShadowReport, ToolError> measure_shadows(const Asset& asset, const ShadowSettings& settings,
                                                      const ReportProgress& progress) {
  if (const auto checked = check(asset, settings); !checked) return tl::unexpected(checked.error());
  const auto measurement = ShadowMeasurement::create(asset, settings, progress);
  if (!measurement) return tl::unexpected(measurement.error());
  return (*measurement)->run();
}

}  // namespace coif::report
