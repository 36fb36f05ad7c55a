#pragma once

#include "base/tool_error.h"
#include "render/camera.h"
#include "render/egl_context.h"

#include <coif/asset.h>
#include <coif/renderer.h>

#include <tl/expected.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::render {

/// A crowd to draw; the caller decides how it is simulated.
struct DrawnCrowd {
  std::function<void()> step;  ///< One frame of all heads.
  std::function<std::span<const Mat34>(std::uint32_t head)> palette;
};
using MakeCrowd = std::function<tl::expected<DrawnCrowd, ToolError>(std::uint32_t heads)>;

/// One way to draw a crowd.
struct DrawnFrame {
  std::uint32_t crowd = 0;  ///< From CrowdStage::add().
  const TransparencyMode* transparency = &kBlendMode;
  std::uint32_t samples = 1;  ///< Per pixel, 1 or 4.
  std::uint32_t lod = 0;      ///< For all heads.
  bool simulation = false;    ///< The crowd is stepped first.
  /// With all terms that a shading model may have, whatever the asset's material has.
  bool strand_terms = false;
};

/// Crowds of one asset's hair and a framebuffer without a window to draw them to. One at a time, and its thread's
/// OpenGL context while it lives.
class CrowdStage {
 public:
  /// `width` and `height`: pixels. Errors: kUnsupported where no EGL display with OpenGL ES 3.0 can be had or the
  /// driver refuses the asset, kBadInput for an asset without a mesh, kUsage for a size out of 16..8192.
  /// `through` as DrawingDevice::create() takes it.
  static tl::expected<std::unique_ptr<CrowdStage>, ToolError> create(const Asset& asset, std::uint32_t width,
                                                                     std::uint32_t height,
                                                                     const GlLoader* through = nullptr);

  CrowdStage(const CrowdStage&) = delete;
  CrowdStage& operator=(const CrowdStage&) = delete;

  /// One head for each of the view's places. Returns the crowd's number: 0, 1 and so on.
  std::uint32_t add(DrawnCrowd crowd, const CrowdView& view);

  /// Steps, clears, draws and waits until the device has finished. `frame`'s crowd must be there.
  [[nodiscard]] Status draw(const DrawnFrame& frame);

  /// Time of stepping in the last draw(); 0 where nothing was stepped.
  [[nodiscard]] double step_seconds() const { return step_seconds_; }

  /// Time of the draw calls of the last draw(), as the device reports it; none where it does not.
  [[nodiscard]] std::optional<double> gpu_seconds() { return timer_.poll(); }

  /// Draws and counts the pixels that changed; none where draw() fails.
  [[nodiscard]] std::optional<std::uint64_t> count_covered_pixels(const DrawnFrame& frame);

  /// A crowd of `heads` that fills the picture, or is `times_as_far` (>= 1) times as far away.
  [[nodiscard]] CrowdView filling_view(std::uint32_t heads, double times_as_far = 1) const;

  [[nodiscard]] std::string device() const { return device_->context.device(); }  ///< GL_RENDERER.
  [[nodiscard]] std::uint32_t lod_count() const { return model_.lod_count(); }

 private:
  struct Scene {
    DrawnCrowd crowd;
    Camera camera;
    std::array<Light, 3> lights;
    std::vector<HairInstance> heads;  ///< Their palettes are renewed every frame.
  };

  CrowdStage(const Asset& asset, double aspect, std::unique_ptr<DrawingDevice> device);
  [[nodiscard]] OffscreenTarget& target_of(const DrawnFrame& frame) { return *(frame.samples > 1 ? many_ : one_); }
  Status draw_heads(const DrawnFrame& frame);

  double aspect_;
  std::unique_ptr<DrawingDevice> device_;  ///< Destroyed after the objects made in it.
  HairModel model_;
  MaterialRecord with_terms_;
  GpuTimer timer_;
  std::optional<OffscreenTarget> one_, many_;  ///< Samples a pixel.
  std::vector<Eigen::Vector3d> points_;
  std::vector<Scene> scenes_;
  double step_seconds_ = 0;
};

struct FrameTime {
  double seconds = 0;                   ///< Wall time until the device has finished, median.
  double spread_pct = 0;                ///< Width of the middle half of the frames, % of the median.
  double step_seconds = 0;              ///< Time of stepping in these frames; median.
  std::optional<double> gpu_seconds{};  ///< As the device reports it, median; none where it does not.
};

inline constexpr unsigned kLeastFrames = 3;  ///< For each way, however long they take.

/// Draws frames in turns for about `seconds` (> 0), so that a machine that is slower for a while is slower for all.
/// Each must be one that `stage` can draw.
[[nodiscard]] std::vector<FrameTime> time_frames(CrowdStage& stage, std::span<const DrawnFrame> frames, double seconds,
                                                 unsigned least_frames = kLeastFrames);

/// A crowd that was not measured.
struct DrawCostLeftOut {
  std::uint32_t heads = 0;
  std::string why;
};

inline constexpr std::uint32_t kMostDrawnHeads = 10'000;

/// Puts crowds on a stage as long as one of their frames does not take too long. Small crowds come first, since they
/// give a lower bound for large ones. One head is never too slow.
class AffordableCrowds {
 public:
  /// `longest_frame`: seconds, with blend. `stage` and `make_crowd` must outlive this object.
  AffordableCrowds(CrowdStage& stage, const MakeCrowd& make_crowd, double longest_frame)
      : stage_(stage), make_crowd_(make_crowd), longest_frame_(longest_frame) {}

  /// Adds a crowd with one head for each of the view's places, not fewer than the last. Returns its number on the
  /// stage; none where it was left out. Errors: kBadInput where the hair cannot be drawn; those of `make_crowd`.
  tl::expected<std::optional<std::uint32_t>, ToolError> add(const CrowdView& view);

  /// In the order of add(): all from some size on.
  [[nodiscard]] const std::vector<DrawCostLeftOut>& left_out() const { return left_out_; }

 private:
  [[nodiscard]] double least_seconds(std::uint32_t heads) const;
  [[nodiscard]] double seconds_of_a_frame(std::uint32_t crowd) const;
  bool leave_out_slow(double seconds, std::uint32_t heads);

  CrowdStage& stage_;
  const MakeCrowd& make_crowd_;
  double longest_frame_;
  double last_seconds_ = 0;       ///< Per frame of the largest crowd so far.
  std::uint32_t last_heads_ = 1;  ///< Heads of that crowd.
  std::vector<DrawCostLeftOut> left_out_;
};

}  // namespace coif::render
