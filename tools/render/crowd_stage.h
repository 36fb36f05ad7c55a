#pragma once

#include "render/camera.h"
#include "render/egl_context.h"
#include "render/gpu_timer.h"
#include "render/offscreen_target.h"
#include "tool_error.h"

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

namespace coif {

/// A crowd to draw; whoever measures says how it is simulated.
struct DrawnCrowd {
  std::function<void()> step;  ///< One frame of all heads.
  std::function<std::span<const Mat34>(std::uint32_t head)> palette;
};
using MakeCrowd = std::function<tl::expected<DrawnCrowd, ToolError>(std::uint32_t heads)>;

/// One way to draw a crowd.
struct DrawnFrame {
  std::uint32_t crowd = 0;  ///< As CrowdStage::add() numbered it.
  const TransparencyMode* transparency = &kBlendMode;
  std::uint32_t samples = 1;  ///< Of a pixel, 1 or 4.
  std::uint32_t lod = 0;      ///< Of all heads.
  bool simulation = false;    ///< The crowd is stepped first.
};

/// Crowds of one asset's hair and a framebuffer without a window to draw them to. One at a time, and its thread's
/// OpenGL context while it lives.
class CrowdStage {
 public:
  /// `width` and `height`: pixels. Errors: kUnsupported where no EGL display with OpenGL ES 3.0 can be had or the
  /// driver refuses the asset, kBadInput for an asset without a mesh, kUsage for a size out of 16..8192.
  static tl::expected<std::unique_ptr<CrowdStage>, ToolError> create(const Asset& asset, std::uint32_t width,
                                                                     std::uint32_t height);

  CrowdStage(const CrowdStage&) = delete;
  CrowdStage& operator=(const CrowdStage&) = delete;

  /// One head for each of the view's places. Returns the crowd's number: 0, 1 and so on.
  std::uint32_t add(DrawnCrowd crowd, const CrowdView& view);

  /// Steps, clears, draws and waits until the device has finished. `frame`'s crowd must be there.
  [[nodiscard]] Status draw(const DrawnFrame& frame);

  /// Of the last draw(), draw calls alone, as the device itself tells; nothing where it does not.
  [[nodiscard]] std::optional<double> gpu_seconds() { return timer_.poll(); }

  /// Draws and counts the pixels that are not as they were; nothing where draw() fails.
  [[nodiscard]] std::optional<std::uint64_t> count_covered_pixels(const DrawnFrame& frame);

  /// A crowd of `heads` that fills the picture, or is so many times as far away (>= 1).
  [[nodiscard]] CrowdView filling_view(std::uint32_t heads, double times_as_far = 1) const;

  [[nodiscard]] std::string device() const { return context_.device(); }  ///< GL_RENDERER.
  [[nodiscard]] std::uint32_t lod_count() const { return model_.lod_count(); }

 private:
  struct Scene {
    DrawnCrowd crowd;
    Camera camera;
    std::array<Light, 3> lights;
    std::vector<HairInstance> heads;  ///< Their palettes are renewed every frame.
  };

  CrowdStage(const Asset& asset, double aspect, EglContext context);
  [[nodiscard]] OffscreenTarget& target_of(const DrawnFrame& frame) { return *(frame.samples > 1 ? many_ : one_); }
  Status draw_heads(const DrawnFrame& frame);

  double aspect_;
  EglContext context_;  ///< Before what is made in it.
  HairRenderer renderer_;
  HairModel model_;
  GpuTimer timer_;
  std::optional<OffscreenTarget> one_, many_;  ///< Samples a pixel.
  std::vector<Eigen::Vector3d> points_;
  std::vector<Scene> scenes_;
};

}  // namespace coif
