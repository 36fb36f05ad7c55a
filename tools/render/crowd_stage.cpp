#include "render/crowd_stage.h"

#include "base/timing.h"
#include "render/camera.h"
#include "render/gallery.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace coif::render {
namespace {

constexpr double kYawDegrees = 30, kPitchDegrees = 5;
constexpr std::uint32_t kManySamples = 4;

void clear(float shade, float alpha) {
  glClearColor(shade, shade, shade, alpha);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

CrowdStage::CrowdStage(const Asset& asset, double aspect, std::unique_ptr<DrawingDevice> device)
    : aspect_(aspect),
      device_(std::move(device)),
      with_terms_(own_material(asset)),
      timer_(device_->context.loader()),
      points_(framed_points(asset)) {
  with_terms_.glow = with_terms_.root_shade = with_terms_.variation = 0.5f;
}

tl::expected<std::unique_ptr<CrowdStage>, ToolError> CrowdStage::create(const Asset& asset, std::uint32_t width,
                                                                        std::uint32_t height, const GlLoader* through) {
  const auto side_ok = [](std::uint32_t side) { return side >= 16 && side <= 8192; };
  if (!side_ok(width) || !side_ok(height)) {
    return usage("a picture has 16 to 8192 pixels each way");
  }
  if (auto drawable = check_drawable(asset); !drawable) return tl::unexpected(drawable.error());
  auto device = DrawingDevice::create({}, through);
  if (!device) return tl::unexpected(device.error());
  std::unique_ptr<CrowdStage> made(new CrowdStage(asset, double(width) / height, std::move(*device)));
  if (const Status status = made->model_.upload(made->device_->renderer, asset); status != Status::kOk) {
    return failure(ToolError::Kind::kUnsupported, std::string("the driver refuses the asset: ") + describe(status));
  }
  const auto one = OffscreenTarget::create(width, height, 0),
             many = OffscreenTarget::create(width, height, kManySamples);
  if (!one) return tl::unexpected(one.error());
  if (!many) return tl::unexpected(many.error());
  made->one_ = *one;
  made->many_ = *many;
  return made;
}

std::uint32_t CrowdStage::add(DrawnCrowd crowd, const CrowdView& view) {
  Scene scene{std::move(crowd), view.camera, studio_lights(view.camera), std::vector<HairInstance>(view.places.size())};
  for (std::size_t head = 0; head < view.places.size(); ++head) {
    Eigen::Map<Eigen::Vector3d>{scene.heads[head].head.position} = view.places[head];
  }
  scenes_.push_back(std::move(scene));
  return std::uint32_t(scenes_.size() - 1);
}

CrowdView CrowdStage::filling_view(std::uint32_t heads, double times_as_far) const {
  CameraSettings settings;
  settings.yaw_degrees = kYawDegrees;
  settings.pitch_degrees = kPitchDegrees;
  settings.aspect = aspect_;
  settings.heads = heads;
  settings.margin *= times_as_far;
  return frame_crowd(points_, settings);
}

Status CrowdStage::draw_heads(const DrawnFrame& frame) {
  Scene& scene = scenes_[frame.crowd];
  for (std::uint32_t head = 0; head < scene.heads.size(); ++head) {
    scene.heads[head].palette = scene.crowd.palette(head);
    scene.heads[head].lod = frame.lod;
  }
  DrawDesc desc = studio_desc(scene.camera, scene.lights);
  desc.transparency = frame.transparency;
  if (frame.strand_terms) desc.material = &with_terms_;
  timer_.begin();
  const Status status = device_->renderer.draw(model_, scene.heads, desc);
  timer_.end();
  glFinish();
  return status;
}

Status CrowdStage::draw(const DrawnFrame& frame) {
  const auto begin = std::chrono::steady_clock::now();
  if (frame.simulation) scenes_[frame.crowd].crowd.step();
  const std::chrono::duration<double> stepped = std::chrono::steady_clock::now() - begin;
  step_seconds_ = frame.simulation ? stepped.count() : 0;
  target_of(frame).bind();
  clear(0.2f, 1);
  return draw_heads(frame);
}

std::optional<std::uint64_t> CrowdStage::count_covered_pixels(const DrawnFrame& frame) {
  target_of(frame).bind();
  clear(0, 0);
  if (draw_heads(frame) != Status::kOk) return {};
  const std::vector<std::uint8_t> pixels = target_of(frame).read();
  std::uint64_t covered = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    covered += (pixels[i] | pixels[i + 1] | pixels[i + 2] | pixels[i + 3]) != 0 ? 1 : 0;
  }
  return covered;
}

namespace {

/// Leaves out the first frame, which also pays for work that drivers put off.
std::optional<double> median_of_later(std::vector<double> samples) {
  if (samples.size() < 2) return {};
  samples.erase(samples.begin());
  return SideBySideTiming::summarize(std::move(samples)).seconds;
}

}  // namespace

std::vector<FrameTime> time_frames(CrowdStage& stage, std::span<const DrawnFrame> frames, double seconds,
                                   unsigned least_frames) {
  std::vector<std::vector<double>> gpu_samples(frames.size()), step_samples(frames.size());
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    works.emplace_back([&stage, &frame = frames[i], &samples = gpu_samples[i], &steps = step_samples[i]] {
      (void)stage.draw(frame);
      steps.push_back(stage.step_seconds());
      if (const auto gpu = stage.gpu_seconds()) samples.push_back(*gpu);
    });
  }
  const std::vector<Timing> timings =
      SideBySideTiming(
          {.clock = TimingClock::kWall, .seconds = seconds, .least_rounds = least_frames, .batch_seconds = 0})
          .run(works);
  std::vector<FrameTime> times;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    times.push_back({.seconds = timings[i].seconds,
                     .spread_pct = timings[i].spread_pct,
                     .step_seconds = median_of_later(std::move(step_samples[i])).value_or(0),
                     .gpu_seconds = median_of_later(std::move(gpu_samples[i]))});
  }
  return times;
}

/// As many pixels as the last crowd, but more vertices.
double AffordableCrowds::least_seconds(std::uint32_t heads) const {
  constexpr double kVertexShare = 0.2;  // Share of one head's time, at least.
  return last_seconds_ * std::max(1.0, kVertexShare * heads / last_heads_);
}

bool AffordableCrowds::leave_out_slow(double seconds, std::uint32_t heads) {
  if (heads == 1 || seconds <= longest_frame_) return false;
  left_out_.push_back({heads, "one frame takes " + std::to_string(std::lround(1e3 * seconds)) +
                                  " ms or more, too long for the time there is"});
  return true;
}

/// A frame that something else delayed does not count as slow; frames that are slow anyway are drawn once.
double AffordableCrowds::seconds_of_a_frame(std::uint32_t crowd) const {
  constexpr int kTries = 4;
  constexpr double kLong = 1;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTries && least > longest_frame_; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    (void)stage_.draw({.crowd = crowd});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    least = std::min(least, seconds);
    if (seconds > kLong) break;
  }
  return least;
}

tl::expected<std::optional<std::uint32_t>, ToolError> AffordableCrowds::add(const CrowdView& view) {
  const auto heads = std::uint32_t(view.places.size());
  if (!left_out_.empty()) {
    left_out_.push_back({heads, "fewer are too slow already"});
    return std::nullopt;
  }
  if (leave_out_slow(least_seconds(heads), heads)) return std::nullopt;
  auto crowd = make_crowd_(heads);
  if (!crowd) return tl::unexpected(crowd.error());
  const std::uint32_t number = stage_.add(std::move(*crowd), view);
  // The first frame also pays for work that drivers put off.
  if (const Status status = stage_.draw({.crowd = number}); status != Status::kOk) {
    return failure(ToolError::Kind::kBadInput, std::string("the hair cannot be drawn: ") + describe(status));
  }
  last_seconds_ = seconds_of_a_frame(number);
  last_heads_ = heads;
  if (leave_out_slow(last_seconds_, heads)) return std::nullopt;
  return number;
}

}  // namespace coif::render
