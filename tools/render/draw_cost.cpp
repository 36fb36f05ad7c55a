#include "render/draw_cost.h"

#include "render/egl_context.h"
#include "render/offscreen_target.h"
#include "render/studio.h"
#include "timing.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace coif {
namespace {

constexpr std::uint32_t kMostHeads = 10'000;
constexpr double kLargestShare = 0.6;  // of the time, for one crowd
constexpr unsigned kLeastRounds = 3;
constexpr unsigned kRunsOfACrowd = 3 * (kLeastRounds + 1);  // two ways that are dear and two that are cheap; warming up
constexpr double kYawDegrees = 30, kPitchDegrees = 5;

tl::unexpected<ToolError> fail(ToolError::Kind kind, std::string message) {
  return tl::unexpected(ToolError{kind, std::move(message)});
}

tl::expected<void, ToolError> check(const Asset& asset, const DrawCostSettings& settings) {
  const auto side_ok = [](std::uint32_t side) { return side >= 16 && side <= 8192; };
  const auto crowd_ok = [](std::uint32_t heads) { return heads >= 1 && heads <= kMostHeads; };
  if (!side_ok(settings.width) || !side_ok(settings.height) || !std::ranges::all_of(settings.heads, crowd_ok) ||
      !(settings.seconds > 0)) {
    return fail(ToolError::Kind::kUsage,
                "a picture has 16 to 8192 pixels each way and 1 to 10000 heads, and drawing takes time");
  }
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) {
    return fail(ToolError::Kind::kBadInput, "the asset has no mesh to draw");
  }
  return {};
}

/// A crowd and where each head stands.
struct Scene {
  DrawnCrowd crowd;
  CrowdView view;
  std::array<Light, 3> lights;
};

class DrawMeasurement {
 public:
  static tl::expected<std::unique_ptr<DrawMeasurement>, ToolError> create(const Asset& asset,
                                                                          const DrawCostSettings& settings) {
    auto context = EglContext::create();
    if (!context) return tl::unexpected(context.error());
    std::unique_ptr<DrawMeasurement> made(new DrawMeasurement(asset, settings, std::move(*context)));
    if (made->renderer_.create(made->context_.loader()) != Status::kOk) {
      return fail(ToolError::Kind::kUnsupported,
                  std::string("the renderer does not start: ") + made->renderer_.failure());
    }
    if (const Status status = made->model_.upload(made->renderer_, asset); status != Status::kOk) {
      return fail(ToolError::Kind::kUnsupported, std::string("the driver refuses the asset: ") + describe(status));
    }
    const auto target = OffscreenTarget::create(settings.width, settings.height, 0);
    if (!target) return tl::unexpected(target.error());
    target->bind();
    return made;
  }

  tl::expected<DrawCost, ToolError> run(const MakeCrowd& make_crowd) {
    DrawCost cost{.device = context_.device(), .rows = {}, .left_out = {}};
    for (const std::uint32_t heads : std::set(settings_.heads.begin(), settings_.heads.end())) {
      if (auto added = add_crowd(heads, make_crowd, cost); !added) return tl::unexpected(added.error());
    }
    std::vector<std::function<void()>> works;
    for (const DrawCostRow& row : cost.rows) {
      works.emplace_back([this, row] { (void)draw_frame(row); });
    }
    const std::vector<Timing> timings = SideBySideTiming({.clock = TimingClock::kWall,
                                                          .seconds = settings_.seconds,
                                                          .least_rounds = kLeastRounds,
                                                          .batch_seconds = 0})
                                            .run(works);
    for (std::size_t i = 0; i < timings.size(); ++i) {
      cost.rows[i].seconds = timings[i].seconds;
      cost.rows[i].spread_pct = timings[i].spread_pct;
    }
    return cost;
  }

 private:
  DrawMeasurement(const Asset& asset, const DrawCostSettings& settings, EglContext context)
      : settings_(settings), context_(std::move(context)), points_(framed_points(asset)) {}

  tl::expected<void, ToolError> add_crowd(std::uint32_t heads, const MakeCrowd& make_crowd, DrawCost& cost) {
    if (!cost.left_out.empty()) {
      cost.left_out.push_back({heads, "fewer are too slow already"});
      return {};
    }
    if (heads > 1 && is_too_slow(slowest_ * least_growth(heads), heads, cost)) return {};
    auto crowd = make_crowd(heads);
    if (!crowd) return tl::unexpected(crowd.error());
    const double aspect = double(settings_.width) / settings_.height;
    const CrowdView view = frame_crowd(
        points_, {.yaw_degrees = kYawDegrees, .pitch_degrees = kPitchDegrees, .aspect = aspect, .heads = heads});
    scenes_[heads] = {std::move(*crowd), view, studio_lights(view.camera)};
    // The first frame also pays for what drivers put off until then.
    if (const Status status = draw_frame({.heads = heads}); status != Status::kOk) {
      return fail(ToolError::Kind::kBadInput, std::string("the hair cannot be drawn: ") + describe(status));
    }
    const auto begin = std::chrono::steady_clock::now();
    (void)draw_frame({.heads = heads});
    slowest_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    largest_ = heads;
    if (heads == 1 || !is_too_slow(slowest_, heads, cost)) add_rows(heads, cost);
    return {};
  }

  void add_rows(std::uint32_t heads, DrawCost& cost) const {
    for (const bool transparency : {true, false}) {
      for (const bool simulation : {false, true}) {
        cost.rows.push_back({.heads = heads, .transparency = transparency, .simulation = simulation});
      }
    }
    for (std::uint32_t lod = 1; heads == 1 && lod < model_.lod_count(); ++lod) {
      cost.rows.push_back({.heads = heads, .lod = lod});
    }
  }

  /// By how much more at least a crowd takes than the last one: the same pixels, but more vertices.
  [[nodiscard]] double least_growth(std::uint32_t heads) const {
    constexpr double kVertexShare = 0.2;  // of one head's time, at the least
    return std::max(1.0, kVertexShare * heads / largest_);
  }

  /// Then notes it in `cost`.
  bool is_too_slow(double seconds, std::uint32_t heads, DrawCost& cost) const {
    if (seconds * kRunsOfACrowd <= kLargestShare * settings_.seconds) return false;
    cost.left_out.push_back({heads, "one frame takes " + std::to_string(std::lround(1e3 * seconds)) +
                                        " ms or more, too long for the time there is"});
    return true;
  }

  Status draw_frame(const DrawCostRow& row) {
    const Scene& scene = scenes_.at(row.heads);
    if (row.simulation) scene.crowd.step();
    glClearColor(0.2f, 0.2f, 0.2f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    DrawDesc desc;
    Eigen::Map<Eigen::Matrix4f>{desc.clip_from_world} = scene.view.camera.clip_from_world;
    const Eigen::Vector3d& eye = scene.view.camera.eye;
    desc.eye = {float(eye.x()), float(eye.y()), float(eye.z())};
    desc.lights = scene.lights;
    desc.transparency = row.transparency ? &kBlendMode : &kOpaqueMode;
    desc.framebuffer_is_srgb = true;
    std::vector<HairInstance> heads(row.heads);
    for (std::uint32_t head = 0; head < row.heads; ++head) {
      Eigen::Map<Eigen::Vector3d>{heads[head].head.position} = scene.view.places[head];
      heads[head].palette = scene.crowd.palette(head);
      heads[head].lod = row.lod;
    }
    if (const Status status = renderer_.draw(model_, heads, desc); status != Status::kOk) return status;
    glFinish();
    return Status::kOk;
  }

  const DrawCostSettings& settings_;
  EglContext context_;  ///< Before what is made in it.
  HairRenderer renderer_;
  HairModel model_;
  std::vector<Eigen::Vector3d> points_;
  std::map<std::uint32_t, Scene> scenes_;
  double slowest_ = 0;  ///< Seconds a frame of the largest crowd so far.
  std::uint32_t largest_ = 1;
};

}  // namespace

tl::expected<DrawCost, ToolError> measure_drawing(const Asset& asset, const DrawCostSettings& settings,
                                                  const MakeCrowd& make_crowd) {
  if (auto checked = check(asset, settings); !checked) return tl::unexpected(checked.error());
  auto measurement = DrawMeasurement::create(asset, settings);
  if (!measurement) return tl::unexpected(measurement.error());
  return (*measurement)->run(make_crowd);
}

}  // namespace coif
